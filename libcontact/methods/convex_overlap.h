// The overlap of two convex polyhedra as a body: one of them cut by the face planes of the other, plane by plane.
//
// Every cut decides for each corner once on which side it lies, and faces share their corners: the pieces of both
// surfaces fit together whatever the rounding, where faces are parallel or lie in one plane too. Corners in a plane
// are kept: a face that both bodies have in one place is the first one's.
//
// Scratch of the thread that grows to the largest overlap and is not given back. Cost: corners of the overlap × planes
// that meet it, 2 us a pair of cubes. Accuracy: corners to 64 eps of the pair's size. Tests:
// tests/libcontact/overlap_volume.cpp, approximate_polyhedra.cpp
#pragma once

#include "libcontact/methods/polyhedron_pair.h"

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
