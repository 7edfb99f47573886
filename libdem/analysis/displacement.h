// Deformation: how bodies have moved since a reference frame, and the strain and rotation of their neighbourhoods.
//
//   u = x − X   of bodies in both frames, [m]; along periodic axes to the image that has moved least in units of the
//               cell: more than half a cell is not told from less, and the cell's own deformation is part of u      (1)
//   G = ∂u/∂X   least squares over the neighbours in the reference (affine_fit.h), bodies within 1.8 mean bounding
//               diameters; over a box: its bodies                                                                   (2)
//   strain      E = (FᵀF − I)/2, F = I + G; volume change det F − 1 (compression negative); shear: deviator of E
//   curl        ∇ × u = twice the mean rotation where it is small [rad]; over the time between: vorticity [1/s]
//   non-affine  √(Σ |u − G X|²/n) [m] of Falk and Langer
// The same fit of velocities now gives ∇v: its divergence, shear rate (deviator) and vorticity ∇ × v.
// Bodies whose neighbours do not span the space have none of it: `fitted` 0 and zeros. Cost: O(bodies · neighbours),
// in parallel. Accuracy: exact for affine motion to round-off. Tests: tests/libdem/analysis_displacement.cpp.
#pragma once

#include <vector>

#include "libdem/analysis/affine_fit.h"
#include "libdem/analysis/grid.h"
#include "libdem/analysis/result.h"

namespace dem::analysis {

struct Displacements {
  std::vector<std::uint32_t> reference;  // place of each body there, or Groups::none
  std::vector<Vec3d> of_body;            // u, m; zero of bodies that are not there
  std::size_t known = 0;
};
Displacements displacements(const Snapshot& snapshot, const Snapshot& reference);

struct LocalGradient {
  bool fitted = false;
  Mat3d gradient{};
  double left_over = 0;  // (2) of affine_fit.h
  std::uint32_t neighbours = 0;
};
// Of each body of the snapshot. range 0: 1.8 mean bounding diameters.
std::vector<LocalGradient> displacement_gradients(const Snapshot& snapshot, const Snapshot& reference,
                                                  const Displacements& u, double range = 0);
std::vector<LocalGradient> velocity_gradients(const Snapshot& snapshot, double range = 0);

// Over all bodies of each box of a grid over the reference; `neighbours` their number.
std::vector<LocalGradient> box_gradients(const Snapshot& snapshot, const Snapshot& reference, const Displacements& u,
                                         const Grid& grid);

Result report_displacement(const Snapshot& snapshot, const Settings& settings);

}  // namespace dem::analysis
