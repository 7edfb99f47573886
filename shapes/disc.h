// Disc about the origin of its body frame, in the plane z = 0.
#pragma once

#include "shapes/math/vec.h"

namespace shapes {

struct Disc {
  static constexpr const char* name = "disc";
  double radius;  // m, > 0
};

}  // namespace shapes
