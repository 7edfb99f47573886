// What the laws that resist rolling and twisting share. ω = ω_a − ω_b turns about n as twist, across n as rolling.
//   ω_n = ω·n,  w = ω − ω_n n                                                 [rad/s]  (1)
//   cap of rolling   μ_r R* F         F: the force that `friction` multiplies   [N m]  (2)
//   cap of twisting  μ_tw F a,  of laws without a contact radius μ_tw F R*      [N m]  (3)
//     μ_tw = 3π/16 μ: Hertz's contact slides
//   I = 2/5 m* R*²                                                            [kg m²]  (4)
//   M = −w min(cap/|w|, I/(4 dt))     dry friction with a viscous ramp          [N m]  (5)
// (4) is the inertia of a solid sphere on a plane and less than that of two spheres turning against each other,
// (Σ 5/(2 mᵢ Rᵢ²))⁻¹, a quarter of it when they are equal. So one contact takes at most a quarter of w in one step,
// four planes or 16 equal neighbours at most all of it: (5) does not turn a rotation round, and bodies come to rest.
// The price is that what should stand still creeps under a load M at w = 4 dt M/I, first order in dt; a spring does
// not. Test: tests/libcontact/laws_rolling_*.cpp
#pragma once

#include "libcontact/laws/state.h"

namespace contact::resistance {

template <class T>
struct Spin {
  T twist{};          // ω_n
  Vec3<T> rolling{};  // w
};

template <class T>
Spin<T> split(const Kinematics<T>& k) {  // (1)
  const T twist = dot(k.relative_spin, k.normal);
  return {twist, k.relative_spin - k.normal * twist};
}

template <class T>
T rolling_cap(const PairOf<T>& p, const Kinematics<T>& k, const NormalForce<T>& f) {
  return capped<T>(p.rolling_friction * k.radius_eff, f.holding);  // (2)
}
template <class T>
T twisting_cap(const PairOf<T>& p, const Kinematics<T>& k, const NormalForce<T>& f) {
  const T arm = select(f.contact_radius > T(0), f.contact_radius, k.radius_eff);
  return capped<T>(p.twisting_friction * arm, f.holding);  // (3)
}

template <class T>
T solid_inertia(const Kinematics<T>& k) {
  return T(0.4) * k.mass_eff * (k.radius_eff * k.radius_eff);  // (4)
}

// The most that a moment over a rate may be in this step, N m s; at dt = 0 there is no limit, and the answer is
// `asked`.
template <class T>
T within_the_step(const T& asked, const Kinematics<T>& k) {
  const auto steps = k.dt > T(0);
  const T most = solid_inertia(k) / select(steps, T(4) * k.dt, T(1));
  return select(steps && most < asked, most, asked);
}

// M/w of (5) but for its sign, for |w|² = square.
template <class T>
T dry(const T& cap, const T& square, const Kinematics<T>& k) {
  using std::sqrt;
  const auto turns = square > T(0);
  return select(turns, within_the_step<T>(cap / sqrt(select(turns, square, T(1))), k), T(0));
}

// On a, about n.
template <class T>
Vec3<T> dry_twist(const PairOf<T>& p, const Kinematics<T>& k, const NormalForce<T>& f, const T& twist) {
  return k.normal * -(dry<T>(twisting_cap(p, k, f), twist * twist, k) * twist);
}

}  // namespace contact::resistance
