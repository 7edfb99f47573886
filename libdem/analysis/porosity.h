// Porosity over the distance from planes: along an axis, and from walls into the bed.
//
//   ε(d) = 1 − Σ (volume of bodies in the slab)/(volume of the slab)                                              (1)
//   slab   the points of the region whose least distance from the planes is between d and d + Δd
//
// One plane gives slabs; the side of a container, seen from inside as the planes of its facets, gives shells: a
// cylinder of 48 facets is met as the prism that it is. Volumes of slabs and the shares of bodies are exact
// (box_share.h). Where bodies overlap both count. Cost: 1e5 spheres, ten slabs a diameter, 0.1 s a profile on one core;
// polyhedra 2 us a body and slab. Accuracy: 1e-12 of a body. Tests: tests/libdem/analysis_porosity.cpp.
#pragma once

#include "libdem/analysis/box_share.h"
#include "libdem/analysis/result.h"

namespace dem::analysis {

struct PorosityProfile {
  double width = 0;              // Δd, m
  std::vector<double> porosity;  // of slab k, from k Δd to (k + 1) Δd; 1 where the slab has no volume
  std::vector<double> volume;    // of the slab, m³
};

// Planes with their unit normals into the wall: normal·x <= offset is the bed's side.
PorosityProfile porosity_from(const Snapshot& snapshot, const BoxShares& shares, const Domain& region,
                              std::span<const shapes::HalfSpace> planes, double width, std::size_t slabs);

Result report_porosity(const Snapshot& snapshot, const Settings& settings);

}  // namespace dem::analysis
