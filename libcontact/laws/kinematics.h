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
  T previous_overlap;      // m, 0: was not touching
};

template <class T>
struct NormalForce {
  T force;           // N, >= 0 for the laws without adhesion
  T elastic;         // N, its elastic part
  T stiffness;       // dF/dδ of the elastic part, N/m
  T damping;         // c of the dashpot, N s/m
  T contact_radius;  // a, m; 0 for laws without one
};

}  // namespace contact
