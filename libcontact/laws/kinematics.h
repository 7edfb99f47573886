// What a law sees of a contact, and what it answers. All members are scalars or packs T; world axes; SI units.
// Signs: the normal points from a to b; velocities are those of a relative to b at the contact's centre; forces are
// those on b (a feels the opposite), moments those on a (b feels the opposite).
#pragma once

#include <cmath>

#include "shapes/math/select.h"
#include "shapes/math/vec.h"

namespace contact {

using shapes::larger;
using shapes::lesser;
using shapes::select;
using shapes::Vec3;

template <class T>
struct Kinematics {
  T overlap{};                 // δ, m; >= 0, but < 0 for a law that holds across a gap
  Vec3<T> normal{};            // n, unit
  T closing_speed{};           // dδ/dt = v·n, m/s
  Vec3<T> slip{};              // v − (v·n) n, m/s
  T radius_eff{}, mass_eff{};  // R*, m; m*, kg
  T dt{};                      // s, the step; 0: the force as it stands
  T onset{};           // part of the step in contact when it began in it or (not clipped) will end in it, else 0, –
  T overlap_before{};  // δ of the last step, m; 0: first step of a contact
  T dt_contact{};      // the part of dt that was spent in contact, s
  Vec3<T> relative_spin{};  // ω_a − ω_b, rad/s
};

// The closing speed at hand is that of half a step ago, v − a dt/2: with it the elastic force and the dashpot both act
// as if stronger by 1/(1 − ε), ε = cn dt/(2 m*), and the restitution misses at first order in dt. What decides the
// restitution is cn/sqrt(U), U the elastic energy; so a dashpot less by the factor
//   s = sqrt(1 + x²) − x,   x = (p/2) cn dt/(2 m*),   p = ∫ε Fe dδ / (ε U)                                         (1)
// hits it at second order: p = 1 for the linear spring, 10/11 for Hertz with Tsuji's dashpot (ε ∝ δ^¼). A contact of
// the linear law alone is then stable up to dt = (2/ω)/sqrt(1 + 2β). At rest (1) changes nothing.
template <class T>
T lag_factor(const T& damping, const T& mass_eff, const T& dt, double p) {
  using std::sqrt;
  const T x = T(0.25 * p) * (damping * dt / mass_eff);
  return sqrt(T(1) + x * x) - x;
}

// c = s c0 of c0 = factor · β sqrt(m* k) at the cost of one square root: sqrt(c0² + y²) − y, y = x c0 = (p/4) factor²
// β² k dt.
template <class T>
T lagging_dashpot(const T& factor_beta, const T& stiffness, const T& mass_eff, const T& dt, double p) {
  using std::sqrt;
  const T pushed = factor_beta * factor_beta * stiffness, y = T(0.25 * p) * (pushed * dt);
  return sqrt(pushed * mass_eff + y * y) - y;
}

// Tsuji's dashpot beside a spring of the stiffness k, with the two corrections for finite steps.
//   c  = s c0,  c0 = factor · β sqrt(m* k)                                                     [N s/m]  s of (1)
//   w  = (4/5)(f + ½) ((f + ½)/f)^¼ in the first step of a contact, of which the part f was spent in contact, else 1:
//        the step's force stands for the time f dt + dt/2, in which the dashpot's grows as t^¼; unclipped also in the
//        last one
template <class T>
struct Dashpot {
  T damping{};  // c
  T weight{};   // w
};
template <class T>
Dashpot<T> tsuji_dashpot(const T& factor_beta, const T& stiffness, const Kinematics<T>& k) {
  using std::sqrt;
  const T c = lagging_dashpot(factor_beta, stiffness, k.mass_eff, k.dt, 10.0 / 11.0);
  const auto begins = k.onset > T(0);
  const T x = select(begins, k.onset, T(1)), since = x + T(0.5);
  return {c, select(begins, T(0.8) * since * sqrt(sqrt(since / x)), T(1))};
}

template <class T>
struct NormalForce {
  T force{};           // on b along n, N; >= 0 where it is clipped, < 0 where it pulls
  T elastic{};         // N, its part without dashpots
  T stiffness{};       // steepest slope dF/dδ of the elastic part here, loading or unloading, N/m
  T damping{};         // c of the dashpot, N s/m
  T contact_radius{};  // a, m; 0 for laws without one
  T stiffness_t{};     // kt of the tangential spring, N/m
  T damping_t{};       // ct of its dashpot, N s/m
  T holding{};         // what the friction coefficient multiplies, N, >= 0
  T shrink{};          // factor on the tangential spring as the contact radius shrinks, 0 … 1; 1: none
  T energy{};          // stored, as it would be given back from here, J
  T bond{};            // 1 where the contact holds on without overlap, else 0
};

template <class T>
struct TangentialForce {
  Vec3<T> force{};  // on b, along the slip of a, N
  T energy{};       // stored in springs, J
};

template <class T>
struct Moment {
  Vec3<T> moment{};  // on a, N m
  T energy{};        // stored in springs, J
};

template <class T>
struct Pull {
  T force{};   // attraction, N, >= 0
  T energy{};  // stored, J, <= 0: zero where the pull ends
  T bond{};    // 1 where it reaches on without overlap, else 0
};

// f(a.member, b.member) for every member of a NormalForce.
template <class A, class B, class F>
constexpr void each_of_normal_force(A& a, B& b, F&& f) {
  f(a.force, b.force);
  f(a.elastic, b.elastic);
  f(a.stiffness, b.stiffness);
  f(a.damping, b.damping);
  f(a.contact_radius, b.contact_radius);
  f(a.stiffness_t, b.stiffness_t);
  f(a.damping_t, b.damping_t);
  f(a.holding, b.holding);
  f(a.shrink, b.shrink);
  f(a.energy, b.energy);
  f(a.bond, b.bond);
}

}  // namespace contact
