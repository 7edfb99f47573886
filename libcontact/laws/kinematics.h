// What a law sees of a contact, and what it answers. All members are scalars or packs T; world axes; SI units.
// Signs: the normal points from a to b; velocities are those of a relative to b at the contact's centre; forces are
// those on a (b feels the opposite).
#pragma once

#include <cmath>

#include "shapes/math/select.h"
#include "shapes/math/vec.h"

namespace contact {

using shapes::larger;
using shapes::select;

template <class T>
struct Kinematics {
  T overlap;               // δ, m; <= 0: no contact
  shapes::Vec3<T> normal;  // n, unit
  T closing_speed;         // dδ/dt = v·n, m/s
  shapes::Vec3<T> slip;    // v − (v·n) n, m/s
  T radius_eff, mass_eff;  // R*, m; m*, kg
  T dt;                    // s, the step; 0: the force as it stands
  T onset;  // part of the step in contact when it began in it or (not clipped) will end in it, else 0, –
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

template <class T>
struct NormalForce {
  T force;           // N, >= 0 where it is clipped
  T elastic;         // N, its elastic part
  T stiffness;       // dF/dδ of the elastic part, N/m
  T damping;         // c of the dashpot, N s/m
  T contact_radius;  // a, m; 0 for laws without one
};

}  // namespace contact
