// Forces, stiffness, energy, damping ratios, durations: from the formulas, in 50 digits.
#include <fmt/format.h>

#include <cmath>

#include "bench/laws/contacts.h"
#include "bench/laws/digits.h"
#include "bench/laws/report.h"

namespace laws {
namespace {

Material metal() {
  Material m;
  m.young = 70e9;
  m.poisson = 0.3;
  m.density = 2650;
  m.stiffness = 1e7;
  return m;
}

// The contact pressed to this overlap at once, at rest.
dem::law_driver::Answer pressed(LawContact c, double radius_eff, double overlap) {
  c.radius_eff = radius_eff;
  Drive drive(c);
  return drive.step({.overlap = overlap});
}

void forces(Report& r) {
  r.heading("forces at rest, E* and R* of 70 GPa, ν 0.3, equal balls of 25 mm");
  const double radius = 0.0125;
  for (const double overlap : {1e-9, 1e-6, 1e-4}) {
    const LawContact c = contact_of({"hertz", "coulomb_spring"}, metal(), metal());
    const dem::law_driver::Answer a = pressed(c, radius, overlap);
    using std::sqrt;
    const Digits e = Digits(c.pair.young_eff), d = overlap, root = sqrt(Digits(radius) * d),
                 f = Digits(4) / 3 * e * root * d;
    const std::string at = fmt::format(" at {:g} m", overlap);
    r.close("hertz F (N)" + at, as_double(f), a.normal, 1e-14);
    r.close("hertz kn (N/m)" + at, as_double(2 * e * root), a.stiffness, 1e-14);
    r.close("hertz kt = 8 G* a (N/m)" + at, as_double(8 * Digits(c.pair.shear_eff) * root), a.stiffness_t, 1e-14);
    r.close("hertz energy 2/5 F δ (J)" + at, as_double(f * d * Digits(2) / 5), a.energy, 1e-14);
  }
  const LawContact linear = contact_of({"linear", "coulomb_spring"}, metal(), metal());
  const dem::law_driver::Answer a = pressed(linear, radius, 1e-6);
  r.close("linear F (N) at 1e-06 m", as_double(Digits(linear.pair.stiffness_n) * Digits(1e-6)), a.normal, 1e-14);
  const Digits nu = Digits(0.3);
  r.close("linear kt/kn = 2(1-ν)/(2-ν) (9.23)", as_double(2 * (1 - nu) / (2 - nu)), a.stiffness_t / a.stiffness, 1e-14);
  r.heading("laws that are Hertz's where their own parameter plays no part");
  for (const LawNames& n : every_law()) {
    const LawContact c = contact_of(n, metal(), metal());
    if (!c.model.hertzian || n.rolling != "none" || n.cohesion != "none") continue;
    if (n.normal == "hertz" && n.tangential == "coulomb_spring") continue;
    const Digits f = Digits(4) / 3 * Digits(c.pair.young_eff) * sqrt(Digits(radius)) * pow(Digits(1e-6), Digits(1.5));
    r.close(title(n) + ": F (N) at 1e-06 m", as_double(f), pressed(c, radius, 1e-6).normal, 1e-13);
  }
}

// e of a dashpot β whose contact ends at zero force.
Digits clipped(const Digits& b) {
  using std::acos, std::exp, std::log, std::sqrt;
  if (b < 1) return exp(-2 * b * acos(b) / sqrt(1 - b * b));
  const Digits root = sqrt(b * b - 1);
  return exp(-2 * b * log(b + root) / root);
}

void damping(Report& r) {
  r.heading("damping ratio β of a restitution, put back into e(β)");
  double worst_clipped = 0, worst_unclipped = 0, at_clipped = 0, at_unclipped = 0;
  for (int i = 1; i < 100; ++i) {
    const double e = 0.01 * i;
    const double c = std::abs(as_double(clipped(Digits(contact::clipped_damping(e))) / e - 1));
    const Digits b = Digits(contact::unclipped_damping(e));
    using std::exp, std::sqrt;
    const double u = std::abs(as_double(exp(-pi() * b / sqrt(1 - b * b)) / e - 1));
    if (c > worst_clipped) worst_clipped = c, at_clipped = e;
    if (u > worst_unclipped) worst_unclipped = u, at_unclipped = e;
  }
  r.at_most(fmt::format("clipped, worst of e = 0.01 … 0.99 (at {:g}), relative", at_clipped), 1e-13, worst_clipped);
  r.at_most(fmt::format("not clipped, worst (at {:g}), relative", at_unclipped), 1e-13, worst_unclipped);
  const double table[][2] = {{.9, .0342652}, {.7, .1222148}, {.5, .2552756},
                             {.3, .4972394}, {.2, .7312469}, {.1, 1.2431879}};
  for (const auto& [e, beta] : table)
    r.near(fmt::format("β of e = {:g} clipped, as published", e), beta, contact::clipped_damping(e), 6e-8);
}

void durations(Report& r) {
  r.heading("undamped impacts at 1000 steps per contact");
  const Ball a = ball(0.025, 2650);
  LawContact c = contact_of({"hertz", "coulomb_spring"}, metal(), metal());
  dem::law_driver::set_bodies(c, a, a);
  for (const double speed : {0.01, 1.0, 5.0}) {
    using std::pow, std::sqrt;
    const Digits m = c.mass_eff, e = c.pair.young_eff, R = c.radius_eff, v = speed;
    const Digits depth = pow(15 * m * v * v / (16 * e * sqrt(R)), Digits(2) / 5);
    const Digits twice = Digits(4) / 5 * sqrt(pi()) * gamma_function(Digits(2) / 5) / gamma_function(Digits(9) / 10);
    const double duration = as_double(twice * depth / v);
    const Rebound b = dem::law_driver::impact(c, a, a, {.normal_speed = speed, .dt = duration / 1000, .phase = 0.3});
    const std::string at = fmt::format(" at {:g} m/s", speed);
    r.close("hertz duration (s)" + at, duration, b.duration, 1e-4);
    r.close("hertz largest overlap (m)" + at, as_double(depth), b.peak_overlap, 1e-4);
    r.close("hertz largest force (N)" + at, as_double(Digits(4) / 3 * e * sqrt(R) * pow(depth, Digits(1.5))),
            b.peak_force, 1e-4);
    r.near("hertz restitution" + at, 1, b.restitution, 1e-6);
    // (9.22) with its exact constant, (π/2.868…)²: the linear spring of the same duration.
    const Digits group = twice * pow(Digits(15) / 16, Digits(2) / 5);
    LawContact l = contact_of({"linear", "coulomb_spring"}, metal(), metal());
    l.pair.stiffness_n = as_double(pi() * pi() / (group * group) * pow(sqrt(m) * e * e * R * v, Digits(2) / 5));
    const Rebound s = dem::law_driver::impact(l, a, a, {.normal_speed = speed, .dt = duration / 1000, .phase = 0.3});
    r.close("linear duration with kn by (9.22) (s)" + at, duration, s.duration, 1e-4);
  }
}

}  // namespace

void closed_forms(Report& r) {
  forces(r);
  damping(r);
  durations(r);
}

}  // namespace laws
