// Sine and cosine in one implementation for every machine: bits must not depend on a system's math library.
// Reduction by π/2 in three parts (Cody & Waite), then the polynomials of degree 13 and 14 on [−π/4, π/4].
// Error below 1 ulp·|x| reduction error for |x| < 10⁵; the argument must be finite and below 2²⁰·π/2.
#pragma once

#include <cmath>

namespace shapes {

struct SineCosine {
  double sine, cosine;
};

inline SineCosine sine_cosine(double x) {
  const double k = std::floor(x * 0.63661977236758134308 + 0.5);
  // π/2 = high + middle + low; high and middle hold 33 bits each, so k·high and k·middle are exact for k < 2²⁰.
  const double r =
      ((x - k * 1.57079632673412561417e+00) - k * 6.07710050630396597660e-11) - k * 2.02226624879595063154e-21;
  const double z = r * r;
  const double s = r + r * z *
                           (-1.66666666666666324348e-01 +
                            z * (8.33333333332248946124e-03 +
                                 z * (-1.98412698298579493134e-04 +
                                      z * (2.75573137070700676789e-06 +
                                           z * (-2.50507602534068634195e-08 + z * 1.58969099521155010221e-10)))));
  const double c =
      1 - (0.5 * z - z * z *
                         (4.16666666666666019037e-02 +
                          z * (-1.38888888888741095749e-03 +
                               z * (2.48015872894767294178e-05 +
                                    z * (-2.75573143513906633035e-07 +
                                         z * (2.08757232129817482790e-09 + z * -1.13596475577881948265e-11))))));
  switch (static_cast<long long>(k) & 3) {
    case 0:
      return {s, c};
    case 1:
      return {c, -s};
    case 2:
      return {-s, -c};
    default:
      return {-c, s};
  }
}

}  // namespace shapes
