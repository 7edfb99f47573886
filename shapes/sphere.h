// Sphere about the origin of its body frame.
#pragma once

#include "shapes/math/vec.h"

namespace shapes {

struct Sphere {
  static constexpr const char* name = "sphere";
  double radius;  // m, > 0
};

// Support point: the body point farthest along the direction n (need not be unit for the point, must not vanish).
inline Vec3d support(const Sphere& s, const Vec3d& unit_n) { return unit_n * s.radius; }

}  // namespace shapes
