// Answers in closed form for one contact: what a collision and a steady load do to it. SI units; undamped.
//   Hertz, F = 4/3 E* sqrt(R*) δ^(3/2):
//     collision  δ = (15 m* v² / (16 E* sqrt(R*)))^(2/5),  t = 2.8682657 (m*² / (R* E*² v))^(1/5)                 (1)
//     load       δ = (3 F / (4 E* sqrt(R*)))^(2/3)                                                               (2)
//   linear, F = k δ:  δ = v sqrt(m*/k),  t = π sqrt(m*/k);  δ = F/k                                               (3)
// A dashpot makes both δ and, as the contact ends at zero force, t smaller.
#pragma once

#include <cmath>
#include <numbers>

namespace dem::forecast {

struct Collision {
  double overlap = 0;   // m, deepest
  double duration = 0;  // s
};

// (1). m_eff: m1 m2 / (m1 + m2), kg; r_eff: R1 R2 / (R1 + R2), m; e_eff: E*, Pa; speed: of approach, > 0, m/s.
inline Collision hertz_collision(double m_eff, double r_eff, double e_eff, double speed) {
  return {std::pow(15 * m_eff * speed * speed / (16 * e_eff * std::sqrt(r_eff)), 0.4),
          2.8682656996 * std::pow(m_eff * m_eff / (r_eff * e_eff * e_eff * speed), 0.2)};
}
// (3). stiffness: N/m.
inline Collision linear_collision(double m_eff, double stiffness, double speed) {
  const double root = std::sqrt(m_eff / stiffness);
  return {speed * root, std::numbers::pi * root};
}
// (2). force: N.
inline double hertz_overlap(double force, double r_eff, double e_eff) {
  return std::pow(3 * force / (4 * e_eff * std::sqrt(r_eff)), 2.0 / 3);
}

// Time that a Rayleigh wave takes around a sphere's half: π R sqrt(ρ/G) / λ, G = E/(2(1 + ν)), λ = 0.1631 ν + 0.8766
// (within 0.3 % of the root of Rayleigh's equation for 0 <= ν <= 0.5). s.
inline double rayleigh_time(double radius, double density, double young, double poisson) {
  const double shear = young / (2 * (1 + poisson));
  return std::numbers::pi * radius * std::sqrt(density / shear) / (0.1631 * poisson + 0.8766);
}

// Mean contact force in a bed under pressure p, by the mean stress of N bodies with Z contacts each,
// p V = N Z F 2R / (2 D):
//   spheres, φ = N 4/3 π R³ / V:    F = 4 π R² p / (φ Z)
//   prisms of height h, φ = N π R² h / V:    F = 2 π R h p / (φ Z)
inline double contact_force(double pressure, double radius, double solid_fraction, double contacts) {
  return 4 * std::numbers::pi * radius * radius * pressure / (solid_fraction * contacts);
}
inline double contact_force_of_prisms(double pressure, double radius, double thickness, double solid_fraction,
                                      double contacts) {
  return 2 * std::numbers::pi * radius * thickness * pressure / (solid_fraction * contacts);
}

}  // namespace dem::forecast
