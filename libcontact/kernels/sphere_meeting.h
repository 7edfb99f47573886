// Two spheres that may overlap: what their contact is, over any scalar. Inside the kernels only.
#pragma once

#include "libcontact/kernels/rows.h"
#include "shapes/math/vec.h"

namespace contact::kernels {
inline namespace KERNEL_SET {

template <class T>
struct SphereMeeting {
  T overlap;                  // m
  shapes::Vec3<T> normal;     // a → b
  shapes::Vec3<T> velocity;   // of a relative to b at the centre of contact, m/s
  T turn;                     // ½(ω_a + ω_b)·n, rad/s
  T radius_eff, mass_eff;     // m, kg
  T arm_a, arm_b;             // from the centres to the point of contact, midway in the overlap, m
  decltype(T() < T()) touch;  // as sphere_clearance says it, and with an overlap that is one
};

// offset: x_b − x_a, m; reach: the sum of the radii, m; velocity: of the centres, a relative to b, m/s; inverse_mass:
// the sum of both, 1/kg; spins, rad/s.
template <class T>
[[gnu::always_inline]] inline SphereMeeting<T> meeting_of(const shapes::Vec3<T>& offset, const T& radius_a,
                                                          const T& radius_b, const T& reach,
                                                          const shapes::Vec3<T>& velocity, const T& inverse_mass,
                                                          const shapes::Vec3<T>& spin_a,
                                                          const shapes::Vec3<T>& spin_b) {
  using std::sqrt;
  SphereMeeting<T> m;
  const T square = dot(offset, offset), distance = sqrt(square);
  m.normal = offset * (T(1) / distance);
  m.overlap = reach - distance;
  const T half = T(0.5) * m.overlap;
  m.arm_a = radius_a - half;
  m.arm_b = radius_b - half;
  m.velocity = velocity + cross(spin_a * m.arm_a + spin_b * m.arm_b, m.normal);
  m.turn = T(0.5) * dot(spin_a + spin_b, m.normal);
  const T both = T(1) / (reach * inverse_mass);  // divisions are dear
  m.radius_eff = radius_a * radius_b * (inverse_mass * both);
  m.mass_eff = reach * both;
  m.touch = square - reach * reach < T(0) && m.overlap > T(0);
  return m;
}

}  // namespace KERNEL_SET
}  // namespace contact::kernels
