// Chain of straight segments, open or closed, in the plane z = 0: a wall of two-dimensional scenes. Segments that
// continue each other are one side: a side is what one contact record belongs to.
#pragma once

#include <vector>

#include "shapes/math/vec.h"

namespace shapes {

struct Polyline {
  static constexpr const char* name = "polyline";
  std::vector<Vec3d> vertices;  // z = 0
};

}  // namespace shapes
