// What holds an adhesive contact tangentially: formulas of thornton_peeling.h, F the elastic normal force (JKR).
//   Fc = (3/2) π W R*                                                                                   [N]   (8.106)
//   a³ = (3R*/(4E*)) (P + sqrt(Q − κ Ft²)),   P = F + 2Fc, Q = 4 F Fc + 4 Fc², κ = E*/(4 G*)            [m³]  (9.15)
//   |Ft| at which the root is 0: 4 sqrt((G*/E*)(F Fc + Fc²))                                            [N]   (9.17)
//   the radius there: a³ = (3R*/(4E*)) P                                                                [m³]  (9.18)
//   what friction multiplies then:  H = P;  F < −0.3 Fc:  H = Fh (1 − (Fh − F)/(3 Fh))^1.5, Fh = P + sqrt(Q)  (9.19)
//   with Ft = 8 G* a x in (9.15), b = a over (9.18), p = 8 G* x times (9.18):
//     (b³ − 1)² + κ (p/P)² b² = Q/P², the root >= 1                                                          (1)
// Accuracy: rounding; (1) by a quadratic, then four steps of Newton. Source: Thornton, J. Phys. D 24 (1991) 1942;
// Savkoor & Briggs, Proc. R. Soc. A 356 (1977) 103. Tests: tests/libcontact/laws_thornton_peeling.cpp
#pragma once

#include "libcontact/laws/state.h"
#include "shapes/math/cube_root.h"

namespace contact::peeling {

// Fc, N.
template <class T>
T pull_off(const PairOf<T>& p, const T& radius_eff) {
  return T(4.71238898038468985769) * p.work_of_adhesion * radius_eff;
}
// (9.15); where `force_t` is beyond (9.17), (9.18).
template <class T>
T radius(const PairOf<T>& p, const T& radius_eff, const T& force, const T& force_t) {
  using std::sqrt;
  const T pull = pull_off(p, radius_eff), ratio = p.young_eff / (T(4) * p.shear_eff);
  const T root = sqrt(larger(T(4) * pull * (force + pull) - ratio * force_t * force_t, T(0)));
  const T load = larger(force + T(2) * pull + root, T(0));
  return radius_eff * shapes::cube_root(T(0.75) * load / (p.young_eff * radius_eff * radius_eff));
}
// (9.17)
template <class T>
T peel_force(const PairOf<T>& p, const T& radius_eff, const T& force) {
  using std::sqrt;
  const T pull = pull_off(p, radius_eff);
  return T(4) * sqrt(larger(p.shear_eff / p.young_eff * pull * (force + pull), T(0)));
}
// b of (1), `force_t` = p. Where it is 1 the contact has peeled.
template <class T>
T growth(const PairOf<T>& p, const T& radius_eff, const T& force, const T& force_t) {
  using std::sqrt;
  const T pull = pull_off(p, radius_eff), whole = force + T(2) * pull;
  const auto some = whole > T(0);
  const T scale = select(some, T(1) / select(some, whole, T(1)), T(0)), ft = force_t * scale;
  const T q = larger(T(4) * pull * (force + pull), T(0)) * scale * scale;
  const T m = p.young_eff / (T(4) * p.shear_eff) * ft * ft;
  const T left = larger(q - m, T(0));
  T v = sqrt(q) * T(1.0 / 3);
  for (int i = 0; i < 2; ++i) {  // in v = b − 1: the square's factor held, a quadratic
    const T c = T(3) + v * (T(3) + v), under = m + sqrt(m * m + (c * c + m) * left);
    v = select(under > T(0), left / select(under > T(0), under, T(1)), T(0));
  }
  for (int i = 0; i < 4; ++i) {  // Newton
    const T c = T(3) + v * (T(3) + v), d = v * c;
    const T slope = T(2) * (d * (c + v * (T(3) + T(2) * v)) + m * (T(1) + v));
    const auto rises = slope > T(0);
    v = larger(v - select(rises, (d * d + m * v * (T(2) + v) - left) / select(rises, slope, T(1)), T(0)), T(0));
  }
  return T(1) + select(left > T(0), v, T(0));
}
// H of (9.19).
template <class T>
T pressing(const PairOf<T>& p, const T& radius_eff, const T& force) {
  using std::sqrt;
  const T pull = pull_off(p, radius_eff), simple = larger(force + T(2) * pull, T(0));
  const T whole = simple + T(2) * sqrt(larger(pull * (force + pull), T(0)));
  const auto low = force < T(-0.3) * pull && whole > T(0);
  const T base = larger(T(1) - (whole - force) / (T(3) * select(low, whole, T(1))), T(0));
  return select(low, whole * base * sqrt(base), simple);
}

}  // namespace contact::peeling
