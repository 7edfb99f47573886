// Simple polygon, convex or not, in the plane z = 0 of its body frame.
#pragma once

#include <vector>

#include "shapes/math/vec.h"

namespace shapes {

struct Polygon {
  static constexpr const char* name = "polygon";
  std::vector<Vec3d> vertices;  // counter-clockwise, z = 0
};

}  // namespace shapes
