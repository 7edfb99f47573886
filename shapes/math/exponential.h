// Exponential and natural logarithm in one implementation for every machine: bits must not depend on a system's math
// library. Error below 2 ulp for |x| < 700 and for positive normal x.
#pragma once

#include <cmath>

namespace shapes {

// x = k ln 2 + r with |r| <= ½ ln 2 (ln 2 in two parts, Cody & Waite), then the Taylor polynomial of degree 14.
inline double exponential(double x) {
  const double k = std::floor(x * 1.44269504088896340736 + 0.5);
  const double r = (x - k * 6.93147180369123816490e-01) - k * 1.90821492927058770002e-10;
  double sum = 1;
  for (int n = 14; n >= 1; --n) sum = 1 + sum * r / n;
  return std::ldexp(sum, static_cast<int>(k));
}

// x = 2^k m with m in [½√2, √2), then 2 artanh((m − 1)/(m + 1)) by its series.
inline double logarithm(double x) {
  int k = 0;
  double m = std::frexp(x, &k);
  if (m < 0.70710678118654752440) {
    m *= 2;
    --k;
  }
  const double s = (m - 1) / (m + 1), z = s * s;
  double sum = 0;
  for (int n = 23; n >= 3; n -= 2) sum = z * (1.0 / n + sum);
  return k * 6.93147180369123816490e-01 + (2 * (s + s * sum) + k * 1.90821492927058770002e-10);
}

}  // namespace shapes
