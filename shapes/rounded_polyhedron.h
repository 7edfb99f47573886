// Convex polyhedron with rounded edges and corners: all points within `radius` of the core (its Minkowski sum with a
// ball).
#pragma once

#include "shapes/polyhedron.h"

namespace shapes {

struct RoundedPolyhedron {
  static constexpr const char* name = "rounded_polyhedron";
  Polyhedron core;
  double radius{};  // m, > 0
};

}  // namespace shapes
