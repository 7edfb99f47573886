// Laws that yield, viscoelastic spheres, elliptical contacts: restitution and force by their closed forms.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bench/laws/contacts.h"
#include "bench/laws/digits.h"
#include "bench/laws/report.h"
#include "libcontact/laws/elliptical.h"

namespace laws {
namespace {

constexpr double radius = 1e-3;

// Of a contact with given m* and R*, on a plane.
Rebound impact_of(const LawContact& c, double mass, double speed, double duration, int steps = 1000) {
  return dem::law_driver::impact(c, dem::law_driver::solid_ball(c.radius_eff, mass), {},
                                 {.normal_speed = speed, .dt = duration / steps, .phase = 0.5});
}

void latching(Report& r) {
  r.heading("Walton & Braun: e at every speed");
  Material m = stone();
  const double mass = 1e-5;
  for (const double e : {0.2, 0.5, 0.9})
    for (const double speed : {0.01, 1.0}) {
      m.restitution = e;
      LawContact c = contact_of({"latching_spring", "coulomb_spring"}, m, m);
      c.radius_eff = radius;
      const double duration = std::acos(-1.0) * std::sqrt(mass / c.pair.stiffness_n);
      r.near(fmt::format("latching_spring, e = {:g} at {:g} m/s", e, speed), e,
             impact_of(c, mass, speed, e * duration).restitution, 1e-3);
    }
}

void thornton_ning(Report& r) {
  r.heading("Thornton & Ning: E* 1.1e11, R* 1 mm, m* 3.3e-5 kg, p_y 1e9");
  Material m = stone();
  m.friction = 0;
  LawContact c = contact_of({"thornton_ning", "coulomb_spring"}, m, m);
  c.pair.young_eff = 1.1e11;
  c.pair.yield_pressure = 1e9;
  c.radius_eff = radius;
  const double mass = 3.3e-5;
  const Digits e = 1.1e11, p = 1e9, R = radius, half = pi() / (2 * e);
  const Digits yield = half * half * sqrt(8 * pi() * R * R * R / (15 * Digits(mass))) * p * p * sqrt(p);
  r.near("V_y (m/s), published digits", .0459485, as_double(yield), 6e-8);
  const double stated[][2] = {{2, .930626}, {5, .773337}, {20, .557109}, {100, .374299}};
  for (const auto& [ratio, digits] : stated) {
    const double speed = ratio * as_double(yield);
    const Digits x = 1 / Digits(ratio);
    const Digits closed =
        sqrt(6 * sqrt(Digits(3)) / 5) * sqrt(1 - x * x / 6) * sqrt(sqrt(x / (x + 2 * sqrt(Digits(6) / 5 - x * x / 5))));
    const Rebound b = impact_of(c, mass, speed, hertz_duration(mass, radius, 1.1e11, speed));
    r.near(fmt::format("e at V = {:g} V_y", ratio), as_double(closed), b.restitution, 1e-3);
    r.near(fmt::format("e at V = {:g} V_y, published digits", ratio), digits, as_double(closed), 6e-7);
    if (ratio == 5) {
      r.close("largest overlap at 5 V_y (m), published digits", .810088e-6, b.peak_overlap, 1e-4);
      r.close("largest force at 5 V_y (N), published digits", 2.33142, b.peak_force, 1e-4);
    }
  }
}

void viscoelastic(Report& r) {
  r.heading("viscoelastic Hertz: e over α = (3/2) A (ρ/m*)^⅖ V^⅕; expected by integration, as published");
  Material m = stone();
  m.friction = 0;
  const double mass = 1e-5, speed = 1;
  const double stated[][2] = {{.01, .98855}, {.05, .94440}, {.1, .89286}, {.3, .72209}};
  const Digits c1 = gamma_function(Digits(3) / 5) * sqrt(pi()) /
                    (pow(Digits(2), Digits(1) / 5) * pow(Digits(5), Digits(2) / 5) * gamma_function(Digits(21) / 10));
  for (const auto& [alpha, digits] : stated) {
    LawContact c = contact_of({"viscoelastic_hertz", "coulomb_spring"}, m, m);
    c.radius_eff = radius;
    const double rho = 4.0 / 3 * c.pair.young_eff * std::sqrt(radius);
    c.pair.viscous_time = alpha / (1.5 * std::pow(rho / mass, 0.4) * std::pow(speed, 0.2));
    const Rebound b = impact_of(c, mass, speed, hertz_duration(mass, radius, c.pair.young_eff, speed));
    r.near(fmt::format("e at α = {:g}", alpha), digits, b.restitution, 1e-3);
    const Digits a = Digits(alpha);
    if (alpha <= 0.05)
      r.near(fmt::format("e at α = {:g}, series of two terms", alpha),
             as_double(1 - c1 * a + Digits(3) / 5 * c1 * c1 * a * a), b.restitution, 1e-3);
  }
}

void luding(Report& r) {
  if (!has_normal_law("adhesive_plastic_spring")) return;
  r.heading("Luding: e² = k1/k2 − (kc/k1)(k2 − k1)²/(k2 (k2 + kc)), k2 of the largest overlap");
  Material m = stone();
  m.restitution = 1;
  m.friction = 0;
  const double mass = 1e-5;
  for (const double adhesive : {0.0, 1e3, 3e3}) {
    m.adhesive_stiffness = adhesive;
    LawContact c = contact_of({"adhesive_plastic_spring", "coulomb_spring"}, m, m);
    c.radius_eff = radius;
    const double duration = std::acos(-1.0) * std::sqrt(mass / c.pair.stiffness_n);
    const Rebound b = impact_of(c, mass, 1, duration, 4000);
    const Digits k1 = c.pair.stiffness_n, kp = c.pair.plastic_stiffness, kc = c.pair.adhesive_stiffness;
    const Digits full = kp / (kp - k1) * Digits(c.pair.plastic_depth) * 2 * Digits(radius);
    const Digits k2 = k1 + (kp - k1) * Digits(b.peak_overlap) / full;
    const Digits square = k1 / k2 - kc / k1 * (k2 - k1) * (k2 - k1) / (k2 * (k2 + kc));
    r.near(fmt::format("adhesive_plastic_spring, kc = {:g} N/m", adhesive), as_double(sqrt(square)), b.restitution,
           1e-3);
  }
}

void elliptical(Report& r) {
  r.heading("elliptical Hertz: b/a, δ over that of the circle at a force, size, by the ratio R1/R2; published digits");
  const double stated[][4] = {{1.5, .763299, .997724, .997730},
                              {2, .630596, .993393, .993436},
                              {4, .399887, .974314, .974931},
                              {10, .222250, .933330, .937098},
                              {50, .082842, .833997, .852913}};
  for (const auto& [ratio, axes, overlap, size] : stated) {
    const contact::EllipticalHertz e = contact::elliptical_hertz(ratio);
    r.near(fmt::format("b/a at R1/R2 = {:g}", ratio), axes, e.axis_ratio, 6e-7);
    r.near(fmt::format("δ/δ0 at R1/R2 = {:g}", ratio), overlap, std::pow(e.factor, -2.0 / 3), 6e-7);
    r.near(fmt::format("sqrt(ab)/a0 at R1/R2 = {:g}", ratio), size, e.size, 6e-7);
  }
}

}  // namespace

void plastic(Report& r) {
  latching(r);
  thornton_ning(r);
  viscoelastic(r);
  luding(r);
  elliptical(r);
}

}  // namespace laws
