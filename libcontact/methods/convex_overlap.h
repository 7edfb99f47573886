// Sums over the overlap of two convex polyhedra: its volume and the pieces of both surfaces. Cones from one of its
// corners over its faces add up to the volume. Cost: 0.5 us a pair of cubes. Tests:
// tests/libcontact/overlap_volume.cpp, approximate_polyhedra.cpp
#pragma once

#include "libcontact/methods/overlap_body.h"

namespace contact {

// About `apex`, a corner of the overlap; in the frame of the pair's self.
struct OverlapSums {
  Vec3d apex{};
  double volume = 0;
  Vec3d first{};                    // ∫x
  Vec3d surface[2]{}, moment[2]{};  // ∫n, ∫x × n over what lies of self's surface in other; and of other's in self
};

OverlapSums convex_overlap(const PolyhedronPair& pair);

}  // namespace contact
