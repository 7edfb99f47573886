// The rolling spring: stiffness, cap, oscillation, rest on a slope, energy over closed paths of rotation and pressure.
#include <vector>

#include "libcontact/laws/rolling/rolling_spring.h"
#include "tests/libcontact/rolling_cases.h"

namespace contact {
namespace {

using Memory = RollingSpring::State<double>;

double kr(const OnPlane& c) {
  return 2.25 * c.normal.stiffness * c.pair.rolling_friction * c.pair.rolling_friction * c.radius * c.radius;
}
double k_twist(const OnPlane& c) { return 16.0 / 3 * std::pow(c.normal.contact_radius, 3) * c.pair.shear_twist; }

TEST(RollingSpring, SpringsOfKnownStiffnessUpToTheirCaps) {
  OnPlane c;
  Memory s;
  const double angle = 1e-7;
  Moment<double> m = c.moment<RollingSpring>(Vec3d{0.6, 0.8, -1} * (angle / c.dt), s);
  EXPECT_NEAR(m.moment.x / (kr(c) * angle), -0.6, 1e-14);
  EXPECT_NEAR(m.moment.y / (kr(c) * angle), -0.8, 1e-14);
  EXPECT_NEAR(m.moment.z / (k_twist(c) * angle), 1, 1e-14);
  EXPECT_NEAR(m.energy / (0.5 * (kr(c) + k_twist(c)) * angle * angle), 1, 1e-14);
  for (int i = 0; i < 10; ++i) m = c.moment<RollingSpring>(Vec3d{0.6, 0.8, -1} * (1e-3 / c.dt), s);
  EXPECT_NEAR(m.moment.x / (0.1 * 0.01 * c.weight()), -0.6, 1e-14);
  EXPECT_NEAR(m.moment.y / (0.1 * 0.01 * c.weight()), -0.8, 1e-14);
  EXPECT_NEAR(m.moment.z / (0.2 * 2e-4 * c.weight()), 1, 1e-15);
  const Moment<double> held = c.moment<RollingSpring>({}, s);  // and keeps them at rest
  EXPECT_NEAR(shapes::norm(held.moment - m.moment) / shapes::norm(m.moment), 0, 1e-15);
}

TEST(RollingSpring, WithoutAContactRadiusTheTwistHasASpringAllTheSame) {
  OnPlane c;
  c.normal.contact_radius = 0;
  Memory s;
  const double k = 2.25 * 1.6e4 * 0.2 * 0.2 * 1e-4;
  EXPECT_NEAR(c.moment<RollingSpring>({0, 0, 1e-7 / c.dt}, s).moment.z / (k * 1e-7), -1, 1e-14);
  for (int i = 0; i < 10; ++i) c.moment<RollingSpring>({0, 0, 1e-2 / c.dt}, s);
  EXPECT_NEAR(s.twist / (0.2 * 0.01 * c.weight()), 1, 1e-15);  // about n = −z
}

TEST(RollingSpring, TheDashpotActsBelowTheCapOnly) {
  OnPlane c, free;
  c.pair.rolling_damping = 0.3;
  Memory s, t;
  const Vec3d slow{0, 1e-4, 1e-4}, fast{0, 10, 10};
  const Vec3d with = c.moment<RollingSpring>(slow, s).moment, without = free.moment<RollingSpring>(slow, t).moment;
  EXPECT_NEAR((with.y - without.y) / (0.6 * std::sqrt(c.about_contact() * kr(c)) * 1e-4), -1, 1e-12);
  EXPECT_NEAR((with.z - without.z) / (0.6 * std::sqrt(c.solid() * k_twist(c)) * 1e-4), -1, 1e-12);
  for (int i = 0; i < 100; ++i) c.moment<RollingSpring>(fast, s), free.moment<RollingSpring>(fast, t);
  EXPECT_EQ(c.moment<RollingSpring>(fast, s).moment, free.moment<RollingSpring>(fast, t).moment);
}

// Rolls without slip on a slope: kick, then drift.
struct Roller {
  OnPlane c;
  Memory s;
  double w = 0, angle = 0, moment = 0, energy = 0;
  void step(double slope) {
    w += (moment + c.mass * c.gravity * std::sin(slope) * c.radius) / c.about_contact() * c.dt;
    angle += w * c.dt;
    const Moment<double> m = c.moment<RollingSpring>({0, w, 0}, s);
    moment = m.moment.y;
    energy = m.energy;
  }
};

// Below the cap: 2π sqrt(I/kr) for a period, no loss without damping, exp(−η ω t) with it.
TEST(RollingSpring, OscillatesBelowTheCapWithoutLoss) {
  Roller r;
  const double omega = std::sqrt(kr(r.c) / r.c.about_contact());
  const double cap = 0.1 * 0.01 * r.c.weight();
  r.w = 0.9 * cap / kr(r.c) * omega;
  const double amplitude = r.w / omega;
  const int steps = int(100 * 2 * M_PI / omega / r.c.dt);
  double most_late = 0;
  int crossings = 0;
  for (int i = 0; i < steps; ++i) {
    const double before = r.angle;
    r.step(0);
    if (before < 0 && r.angle >= 0) ++crossings;
    if (i > steps * 9 / 10) most_late = std::max(most_late, std::abs(r.angle));
  }
  EXPECT_NEAR(most_late / amplitude, 1, 1e-4);
  EXPECT_NEAR(crossings, 100, 1);
}

TEST(RollingSpring, TheDampedOscillationDecaysAsAsked) {
  Roller r;
  r.c.pair.rolling_damping = 0.1;
  const double omega = std::sqrt(kr(r.c) / r.c.about_contact());
  r.w = 0.5 * 0.1 * 0.01 * r.c.weight() / kr(r.c) * omega;
  const double start = r.w;
  const double period = 2 * M_PI / (omega * std::sqrt(1 - 0.01));
  for (int i = 0; i < int(5 * period / r.c.dt + 0.5); ++i) r.step(0);
  EXPECT_NEAR(r.w / (start * std::exp(-0.1 * omega * 5 * period)), 1, 0.03);
}

TEST(RollingSpring, RestsOnASlopeBelowItsAngleAndRollsAbove) {
  for (const double friction : {0.05, 0.1, 0.3}) {
    Roller rest, roll;
    for (Roller* r : {&rest, &roll}) {
      r->c.pair.rolling_friction = friction;
      r->c.pair.rolling_damping = 0.3;
    }
    const double below = std::atan(0.98 * friction), above = std::atan(1.02 * friction);
    rest.c.normal.holding *= std::cos(below);
    roll.c.normal.holding *= std::cos(above);
    double settled = 0, w_before = 0;
    for (int i = 0; i < 200000; ++i) {
      rest.step(below);
      roll.step(above);
      if (i == 149999) {
        settled = rest.angle;
        w_before = roll.w;
      }
    }
    EXPECT_LT(std::abs(rest.w), 1e-9) << friction;
    EXPECT_NEAR(rest.angle / settled, 1, 1e-9);
    EXPECT_NEAR(rest.moment / (rest.c.weight() * std::sin(below) * rest.c.radius), -1, 1e-9);
    // (5/7) g (sin θ − μ_r cos θ) over R
    const double faster = 5.0 / 7 * 9.81 * (std::sin(above) - friction * std::cos(above)) / 0.01;
    EXPECT_NEAR((roll.w - w_before) / (faster * 50000 * roll.c.dt), 1, 1e-9) << friction;
  }
}

// Round closed paths of rotation, at one pressure and at changing ones: what is put in is never less than what is
// stored, and there is a loss once the cap has been reached.
TEST(RollingSpring, ClosedPathsOfRotationCreateNoEnergy) {
  std::mt19937_64 engine(3);
  const auto in = [&](double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine); };
  int lossy = 0;
  for (int path = 0; path < 400; ++path) {
    OnPlane c;
    const bool presses = path % 2 == 1;
    const double reach = std::pow(10.0, in(-1, 1)) * 0.1 * 0.01 * c.weight() / kr(c);  // against the cap's angle
    std::vector<Vec3d> corners(6);
    for (auto& v : corners) v = {in(-reach, reach), in(-reach, reach), in(-reach, reach)};
    corners.front() = corners.back() = {};
    Memory s;
    const OnPlane first = c;
    double work = 0, scale = 0;
    Vec3d before{};
    double stored = 0, level = 1;
    for (std::size_t leg = 1; leg < corners.size(); ++leg) {
      const int steps = 400;
      const Vec3d by = (corners[leg] - corners[leg - 1]) * (1.0 / steps);
      const double to = presses ? (leg + 1 < corners.size() ? in(0.2, 1) : 1) : 1, from = level;
      for (int i = 1; i <= steps; ++i) {
        level = from + (to - from) * i / steps;  // of a
        c.normal.contact_radius = first.normal.contact_radius * level;
        c.normal.stiffness = first.normal.stiffness * level;
        c.normal.holding = first.normal.holding * level * level * level;
        const Moment<double> m = c.moment<RollingSpring>(by * (1 / c.dt), s);
        work -= 0.5 * dot(before + m.moment, by);
        before = m.moment;
        stored = m.energy;
        scale = std::max(scale, m.energy);
      }
    }
    // The trapezoidal rule is exact at one pressure, and of first order where the pressure changes.
    EXPECT_GE(work, stored - (presses ? 1e-3 : 1e-12) * scale) << path;
    if (work - stored > 1e-3 * scale) ++lossy;
  }
  EXPECT_GT(lossy, 100);
}

// What the option is for: turn at high pressure, release, turn back, press.
TEST(RollingSpring, ASpringThatSoftensGivesNothingAway) {
  for (const bool rescale : {true, false}) {
    OnPlane c;
    c.options.rescale = rescale;
    const double angle = 1e-7, k = kr(c);
    Memory s;
    double work = 0;
    Vec3d before{};
    const auto turn = [&](double by) {
      for (int i = 0; i < 1000; ++i) {
        const Moment<double> m = c.moment<RollingSpring>({0, by / 1000 / c.dt, 0}, s);
        work -= 0.5 * (before + m.moment).y * by / 1000;
        before = m.moment;
      }
    };
    turn(angle);
    c.normal.stiffness *= 0.5;
    before = c.moment<RollingSpring>({}, s).moment;
    turn(-angle);
    // kr θ²/2 is put in; back come kr θ²/4 from the spring that has lost half its moment, else (1 − ¼) kr θ².
    EXPECT_NEAR(work / (k * angle * angle), rescale ? 0.25 : -0.25, 1e-9);
  }
}

TEST(RollingSpring, NothingWithoutFrictionOrForce) { nothing_without_friction<RollingSpring>(1e100); }
TEST(RollingSpring, LanesAreTheScalarLaw) { lanes_are_the_scalar_law<RollingSpring>(); }
TEST(RollingSpring, ChangeOfUnitsKeepsTheBits) { scales_with_units<RollingSpring>(); }

}  // namespace
}  // namespace contact
