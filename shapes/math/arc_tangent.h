// Arc tangent in one implementation for every machine and for SIMD packs: bits must not depend on a system's math
// library. Three times tan(x/2) = t/(1 + sqrt(1 + t²)), then the Taylor series for |t| <= tan(π/16), to the digits of T
// (53 of those that name none: packs). Error below 4 ulp; x² must not overflow. Test:
// tests/libcontact/laws_cohesion.cpp
#pragma once

#include <cmath>
#include <limits>

namespace shapes {

template <class T>
T arc_tangent(const T& x) {
  using std::sqrt;
  constexpr int digits = std::numeric_limits<T>::is_specialized ? std::numeric_limits<T>::digits : 53;
  constexpr int terms = 2 + digits * 10 / 46;  // t² = 2^−4.6 at most
  T t = x;
  for (int i = 0; i < 3; ++i) t = t / (T(1) + sqrt(T(1) + t * t));
  const T z = t * t;
  T sum = T(0);
  for (int n = terms; n > 0; --n) sum = z * (T(1) / T(2 * n + 1) - sum);
  return T(8) * (t - t * sum);
}

}  // namespace shapes
