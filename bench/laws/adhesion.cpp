// JKR: force and radius over the overlap, pull-off, where it lets go, work lost, sticking speed, restitution. DMT. The
// pull of liquid bridges over the gap. Expected: the formulas of the sheet (1.0, 1.6, 3.4, 3.6), in 50 digits.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bench/laws/contacts.h"
#include "bench/laws/digits.h"
#include "bench/laws/report.h"

namespace laws {
namespace {

Material sticky() {
  Material m;
  m.young = 1e9;
  m.poisson = 0.3;
  m.density = 2500;
  m.work_of_adhesion = 0.1;
  return m;
}
constexpr double radius = 1e-5;

LawContact jkr() {
  LawContact c = contact_of({"jkr", "coulomb_spring"}, sticky(), sticky());
  c.radius_eff = radius;
  return c;
}

struct Jkr {
  Digits e, w, R;
  Digits pull() const { return 3 * pi() * w * R / 2; }
  Digits rest_cubed() const { return 9 * pi() * w * R * R / (2 * e); }  // a0³
  Digits overlap(const Digits& a) const { return a * a / R - sqrt(2 * pi() * w * a / e); }
  Digits force(const Digits& a) const { return 4 * e * a * a * a / (3 * R) - sqrt(8 * pi() * w * e * a * a * a); }
  // ∫ F dδ, as a function of a.
  Digits work(const Digits& a) const {
    const Digits p = sqrt(pi() * w / (2 * e)), q = sqrt(8 * pi() * w * e), root = sqrt(a);
    return 8 * e / (15 * R * R) * a * a * a * a * a - (4 * e / (3 * R) * p + 2 * q / R) * 2 * a * a * a * root / 7 +
           pi() * w * a * a;
  }
};
Digits cube_root_of(const Digits& x) { return pow(x, Digits(1) / 3); }

// Presses to `depth` and pulls to `overlap` in small steps.
dem::law_driver::Answer pulled_to(double overlap, double depth = 1e-7) {
  Drive drive(jkr());
  drive.step({.overlap = 1e-9});
  drive.step({.overlap = depth});
  return drive.step({.overlap = overlap});
}

void jkr_curve(Report& r) {
  const LawContact c = jkr();
  const Jkr j{c.pair.young_eff, c.pair.work_of_adhesion, radius};
  const Digits a0 = cube_root_of(j.rest_cubed()), af = cube_root_of(j.rest_cubed() / 36);
  r.heading("JKR: force (over Fc) and radius by the overlap");
  double worst_force = 0, worst_radius = 0;
  std::vector<std::vector<double>> curve;
  for (int i = 0; i <= 60; ++i) {
    const Digits a = af + (3 * a0 - af) * (Digits(i) * i / 3600 + Digits(1) / 1000);
    // The overlap that the law is given is the rounded one; what that does to the force is F'(δ) of it.
    const double d = as_double(j.overlap(a));
    Digits exact = a;
    for (int n = 0; n < 8; ++n)
      exact -= (j.overlap(exact) - Digits(d)) / (2 * exact / j.R - sqrt(pi() * j.w / (2 * j.e * exact)));
    const auto got = pulled_to(d, 1e-6);
    worst_force = std::max(worst_force, std::abs(as_double((Digits(got.normal) - j.force(exact)) / j.pull())));
    worst_radius = std::max(worst_radius, std::abs(as_double(Digits(got.contact_radius) / exact - 1)));
    curve.push_back({d, as_double(j.force(exact)), got.normal, got.contact_radius});
  }
  r.at_most("worst error of F over Fc, 61 overlaps from δf to 9 times that of no force", 1e-12, worst_force);
  r.at_most("worst relative error of a", 1e-12, worst_radius);
  r.csv("jkr", "overlap,force_expected,force,contact_radius", curve);
  r.figure("jkr",
           "set xlabel 'overlap (m)'\nset ylabel 'force (N)'\nplot 'jkr.csv' skip 1 using 1:2 with points pt 6 "
           "title 'JKR, 50 digits', '' skip 1 using 1:3 with lines title 'jkr'");
  const Digits a_min = cube_root_of(j.rest_cubed() / 4), release = j.overlap(af);
  r.close("pull-off force: at its overlap (N)", as_double(-j.pull()), pulled_to(as_double(j.overlap(a_min))).normal,
          1e-12);
  r.close("force at δ = 0, −8/9 Fc (N)", as_double(-8 * j.pull() / 9), pulled_to(0).normal, 1e-12);
  const double last = as_double(release);
  const bool holds = pulled_to(last * (1 - 1e-12)).touching;
  r.is_true("holds just before δf", holds, "yes", holds ? "yes" : "no");
  const bool gone = !pulled_to(last * (1 + 1e-12)).touching;
  r.is_true("lets go just beyond δf", gone, "yes", gone ? "yes" : "no");
  r.close("range of the law: |δf| (m)", -last, c.model.range(c.pair, c.options, radius), 1e-14);
}

void jkr_impacts(Report& r) {
  r.heading("JKR: impacts of a ball on a plane at 1000 steps a contact");
  const Material m = sticky();
  LawContact c = jkr();
  const Ball ball_of = ball(radius, m.density);
  dem::law_driver::set_bodies(c, ball_of, {});
  const Jkr j{c.pair.young_eff, c.pair.work_of_adhesion, radius};
  const Digits at_touch = cube_root_of(4 * j.rest_cubed() / 9), af = cube_root_of(j.rest_cubed() / 36);
  const Digits lost = j.work(af) - j.work(at_touch);
  const double sticking = as_double(sqrt(2 * lost / Digits(c.mass_eff)));
  const Digits scale = cube_root_of(pow(j.w, Digits(5)) * pow(j.R, Digits(4)) / (j.e * j.e));
  r.near("work lost over (W⁵ R*⁴/E*²)^⅓, published digits", 7.092196, as_double(lost / scale), 6e-7);
  const auto run = [&](double speed) {
    const double dt = hertz_duration(c.mass_eff, radius, c.pair.young_eff, speed) / 1000;
    return dem::law_driver::impact(c, ball_of, {}, {.normal_speed = speed, .dt = dt, .phase = 0.5}, {}, 20000);
  };
  const Rebound one = run(2 * sticking);
  r.close("work lost (J)", as_double(lost), one.kinetic_before - one.kinetic_after, 2e-3);
  r.close("work booked as adhesive (J)", as_double(lost),
          one.lost[static_cast<std::size_t>(contact::Mechanism::adhesive)], 2e-3);
  double low = 0.9 * sticking, high = 1.1 * sticking;
  while (high - low > 1e-4 * sticking) {
    const double middle = 0.5 * (low + high);
    (run(middle).ended ? high : low) = middle;
  }
  r.close("sticking speed (m/s)", sticking, 0.5 * (low + high), 1e-3);
  for (const double ratio : {1.01, 1.1, 1.5, 2.0, 4.0})
    r.near(fmt::format("e at {:g} times the sticking speed", ratio), std::sqrt(1 - 1 / (ratio * ratio)),
           run(ratio * sticking).restitution, 1e-3);
}

void dmt(Report& r) {
  r.heading("DMT");
  LawContact c = contact_of({"hertz", "coulomb_spring", "none", "dmt"}, sticky(), sticky());
  c.radius_eff = radius;
  const Digits pull = 2 * pi() * Digits(c.pair.work_of_adhesion) * Digits(radius);
  Drive drive(c);
  r.close("pull-off 2π W R* (N)", as_double(-pull), drive.step({.overlap = 1e-30}).normal, 1e-12);
  const Digits d = 1e-8, f = Digits(4) / 3 * Digits(c.pair.young_eff) * sqrt(Digits(radius)) * d * sqrt(d) - pull;
  r.close("force at 10 nm (N)", as_double(f), drive.step({.overlap = 1e-8}).normal, 1e-13);
}

// Equal spheres of 1 mm, 10 nL … of the sheet, 3.6.
void bridges(Report& r) {
  r.heading("liquid bridge of two spheres of 1 mm, V = 1e-11 m³, γ = 0.0728 N/m, θ = 10 degrees: pull over the gap");
  Material m = sticky();
  m.contact_angle = as_double(pi() / 18);
  const double ball_radius = 1e-3, volume = 1e-11, tension = 0.0728;
  const double stated[][3] = {{1e-6, 4.4482e-4, 4.4568e-4}, {1e-5, 3.9445e-4, 3.9864e-4}, {1e-4, 9.8348e-5, 9.9004e-5}};
  for (const auto& [name, column] : {std::pair{"liquid_bridge_rabinovich", 1}, std::pair{"liquid_bridge", 2}}) {
    LawContact c = contact_of({"hertz", "coulomb_spring", "none", name}, m, m,
                              {.surface_tension = tension, .bridge_volume = volume});
    c.radius_eff = 0.5 * ball_radius;
    const Digits R = ball_radius, V = volume, full = 2 * pi() * R * Digits(tension) * cos(pi() / 18);
    for (const auto& row : stated) {
      Drive drive(c);
      drive.step({.overlap = 1e-12});
      const double got = -drive.step({.overlap = -row[0]}).normal;
      const Digits H = row[0], s = H * sqrt(R / V);
      const Digits expected = column == 1 ? Digits(full * (1 - 1 / sqrt(1 + 2 * V / (pi() * R * H * H))))
                                          : Digits(full / (1 + Digits(105) / 100 * s + Digits(5) / 2 * s * s));
      r.close(fmt::format("{} at {:g} m (N)", name, row[0]), as_double(expected), got, 1e-12);
      r.close(fmt::format("{} at {:g} m, published digits (N)", name, row[0]), row[column], got, 2e-5);
    }
    const Digits rupture = (1 + pi() / 36) * cube_root_of(V);
    r.close(std::string(name) + ": ruptures at (1 + θ/2) V^⅓ (m)", as_double(rupture),
            c.model.range(c.pair, c.options, c.radius_eff), 1e-12);
    Drive drive(c);
    const double first = drive.step({.overlap = -1e-6}).normal;
    r.near(std::string(name) + ": no pull before the first touch (N)", 0, first, 0);
  }
}

}  // namespace

void adhesion(Report& r) {
  jkr_curve(r);
  jkr_impacts(r);
  dmt(r);
  bridges(r);
}

}  // namespace laws
