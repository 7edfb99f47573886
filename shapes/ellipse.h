// Ellipse x²/a² + y²/b² <= 1, axes along its body frame, in the plane z = 0.
#pragma once

#include "shapes/math/vec.h"

namespace shapes {

struct Ellipse {
  static constexpr const char* name = "ellipse";
  double a, b;  // semi-axes along x and y, m, each > 0
};

}  // namespace shapes
