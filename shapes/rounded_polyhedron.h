// Convex polyhedron with rounded edges and corners: all points within `radius` of the core (its Minkowski sum with a
// ball).
#pragma once

#include "shapes/export.h"
#include "shapes/polyhedron.h"

namespace shapes {

struct RoundedPolyhedron {
  static constexpr const char* name = "rounded_polyhedron";
  Polyhedron core;
  double radius{};  // m, > 0
};

// The core with its edges rounded by `radius` > 0, in the principal frame of the rounded body: its centre of mass,
// which is not the core's when the core has no symmetry, is the origin (core.frame says where the core's input went).
SHAPES_API RoundedPolyhedron make_rounded(const Polyhedron& core, double radius);
// A polyhedron inscribed in the rounded body, for drawings only: the hull of balls of 42 points about the corners.
SHAPES_API Polyhedron drawing_of(const RoundedPolyhedron& body);

}  // namespace shapes
