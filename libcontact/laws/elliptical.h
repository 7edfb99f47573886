// Hertz contact of bodies whose gap is A x² + B y², A <= B: an ellipse of semi-axes a >= b, and how much stiffer it is
// than the circle of the same R_e = 1/(2 sqrt(AB)).
//   β = b/a,  m = 1 − β²;  K, E complete elliptic integrals of parameter m,  D = (K − E)/m
//   q = B/A = (K − D)/(β² D)                                    [–]   (1)   solved for β
//   a³ = 3 F D/(2π E* A)                                        [m³]  (2)
//   δ = 3 F K/(2π E* a)                                         [m]   (3)
//   F(δ) = φ · 4/3 E* sqrt(R_e) δ^(3/2),  φ = π sqrt(D sqrt(q)/(2 K³))      (4)   1 at q = 1, 1.109 at 10
//   sqrt(ab) at a force, over that of the circle (3 F R_e/(4 E*))^(1/3):  sqrt(β) (4 D sqrt(q)/π)^(1/3)    (5)
// K by the arithmetic-geometric mean of 1 and β, D from its differences: with c₁ = (1 − β)/2, cₙ₊₁ = cₙ²/(4 aₙ₊₁),
//   D/K = ½ + S,  (K − D)/K = ½ − S,  S = Σ 2ⁿ⁻¹ cₙ²/m                      (6)
// Source: Hertz 1881; Johnson, Contact Mechanics (1985), ch. 4; (6) Gauss. Valid for 1 <= q <= 1e30.
// Accuracy: φ 1e-15, β and (5) 1e-14 relative. Cost: 1 us, a dozen means. `double` only: set-up, or once per contact
// and step. Test: tests/libcontact/laws_elliptical.cpp
#pragma once

#include <cmath>
#include <numbers>

#include "shapes/math/cube_root.h"

namespace contact {

struct EllipticIntegrals {
  double k = 0;    // K
  double sum = 0;  // S of (6)
};

// Of β = b/a in (0, 1].
inline EllipticIntegrals elliptic_integrals(double axis_ratio) {
  double a = 0.5 * (1 + axis_ratio), b = std::sqrt(axis_ratio), c = 0.5 * (1 - axis_ratio);
  double part = 0.25 * (1 - axis_ratio) / (1 + axis_ratio);  // 2ⁿ⁻¹ cₙ²/m, n = 1
  EllipticIntegrals out;
  out.sum = part;
  for (int n = 2; n < 40 && part > 0x1p-60 * out.sum; ++n) {
    const double mean = 0.5 * (a + b), next = 0.25 * c * (c / mean);
    part = 2 * part * (next / c) * (next / c);
    b = std::sqrt(a * b);
    a = mean;
    c = next;
    out.sum += part;
  }
  out.k = std::numbers::pi / (a + b);
  return out;
}

// β of q = B/A >= 1, by a bracketed false position on (½ − S) − q β² (½ + S) (Illinois); q^(−2/3) <= β <= q^(−1/2).
inline double axis_ratio_of(double curvature_ratio) {
  const double q = curvature_ratio;
  if (!(q > 1)) return 1;
  const auto miss = [q](double x) {
    const double s = elliptic_integrals(x).sum;
    return (0.5 - s) - q * x * x * (0.5 + s);
  };
  const double root = 1 / shapes::cube_root(q);
  double low = root * root * (1 - 0x1p-40), high = 1 / std::sqrt(q), f_low = miss(low), f_high = miss(high);
  if (!(f_high < 0)) return high;
  int kept = 0;  // > 0: how often the upper end has stayed, < 0: the lower one
  for (int i = 0; i < 100 && high - low > 0x1p-52 * high; ++i) {
    double x = low + (high - low) * (f_low / (f_low - f_high));
    if (!(x > low && x < high)) x = 0.5 * (low + high);
    if (!(x > low && x < high)) break;
    const double f = miss(x);
    if (f == 0) return x;
    if (f > 0) {
      low = x, f_low = f;
      if (kept > 0) f_high *= 0.5;
      kept = kept > 0 ? kept + 1 : 1;
    } else {
      high = x, f_high = f;
      if (kept < 0) f_low *= 0.5;
      kept = kept < 0 ? kept - 1 : -1;
    }
  }
  return f_low < -f_high ? low : high;
}

struct EllipticalHertz {
  double axis_ratio = 1;  // β = b/a
  double factor = 1;      // φ of (4)
  double size = 1;        // of (5)
};

// Of q = B/A >= 1; what is below counts as 1, NaN too.
inline EllipticalHertz elliptical_hertz(double curvature_ratio) {
  EllipticalHertz out;
  if (!(curvature_ratio > 1)) return out;
  out.axis_ratio = axis_ratio_of(curvature_ratio);
  const EllipticIntegrals i = elliptic_integrals(out.axis_ratio);
  const double root = std::sqrt(curvature_ratio), d = 0.5 + i.sum;                                    // D/K
  out.factor = std::numbers::pi * std::sqrt(0.5 * d * root) / i.k;                                    // (4)
  out.size = std::sqrt(out.axis_ratio) * shapes::cube_root((4 / std::numbers::pi) * d * i.k * root);  // (5)
  return out;
}

}  // namespace contact
