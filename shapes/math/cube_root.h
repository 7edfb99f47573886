// Cube root in one implementation for scalars and packs, without a branch: bits must not depend on a system's math
// library.
//   y₀ = x^(1/4) x^(1/16);   y ← y (y³ + 2x)/(2y³ + x), six times (Halley: the number of right digits triples)
// Error below 2 ulp for 1e-40 < x < 1e40, 29 digits in an extended precision; 0 for 0. x is to be a number without a
// unit, so that a change of units does not change its bits. Tests: tests/libcontact/laws_jkr.cpp
#pragma once

#include <cmath>

#include "shapes/math/select.h"

namespace shapes {

template <class T>
T cube_root(const T& x) {
  using std::sqrt;
  const auto some = x > T(0);
  const T z = select(some, x, T(1));
  const T fourth = sqrt(sqrt(z));
  T y = fourth * sqrt(sqrt(fourth));
  for (int i = 0; i < 6; ++i) {
    const T cube = y * y * y;
    y = y * ((cube + z + z) / (cube + cube + z));
  }
  return select(some, y, T(0));
}

}  // namespace shapes
