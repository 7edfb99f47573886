// Ellipsoid x²/a² + y²/b² + z²/c² <= 1, axes along its body frame.
#pragma once

#include "shapes/math/vec.h"

namespace shapes {

struct Ellipsoid {
  static constexpr const char* name = "ellipsoid";
  Vec3d semi_axes;  // m, each > 0
};

// Support point D² n / |D n| with D = diag(semi_axes): the body point farthest along n, in the body frame.
inline Vec3d support(const Ellipsoid& e, const Vec3d& n) {
  const Vec3d u = scaled(e.semi_axes, n);
  return scaled(e.semi_axes, normalized(u));
}

}  // namespace shapes
