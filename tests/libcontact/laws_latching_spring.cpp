// Walton & Braun's latching spring: both lines, its memory, what it loses, the restitution of impacts.
#include <gtest/gtest.h>

#include <cmath>

#include "libcontact/laws/normal/latching_spring.h"
#include "tests/libcontact/law_paths.h"

namespace contact {
namespace {

using paths::mass_eff;
using Contact = paths::Walk<LatchingSpring>;

PairParameters latching(double restitution) {
  PairParameters p;
  p.stiffness_n = 1e4;
  p.stiffness_t = 0.8e4;
  p.loading_ratio = restitution * restitution;
  return p;
}

TEST(LatchingSpring, LoadsAlongOneLineAndUnloadsAlongTheSteeperOne) {
  Contact c{latching(0.5)};  // k2 = 4 k1, δ0 = (3/4) δmax; all of it exact in doubles but for k1 δ
  const double d = 0x1p-16;
  EXPECT_EQ(c.to(d).force, 1e4 * d);
  EXPECT_EQ(c.to(0.875 * d).force, 4e4 * 0.125 * d);
  EXPECT_EQ(c.to(0.75 * d).force, 0);
  EXPECT_EQ(c.to(0.25 * d).force, 0);  // within the flattened part: no force, but not forgotten
  EXPECT_EQ(c.state.overlap_max, d);
  EXPECT_EQ(c.to(0.875 * d).force, 4e4 * 0.125 * d);
  EXPECT_EQ(c.to(d).force, 1e4 * d);
  const auto f = c.to(2 * d);
  EXPECT_EQ(f.force, 1e4 * 2 * d);
  EXPECT_EQ(f.elastic, f.force);
  EXPECT_EQ(f.holding, f.force);
  EXPECT_EQ(f.stiffness, 4e4);
  EXPECT_EQ(f.stiffness_t, 0.8e4);
  EXPECT_EQ(f.damping, 0);
  EXPECT_EQ(f.damping_t, 0);
  EXPECT_EQ(f.shrink, 1);
  EXPECT_EQ(f.energy, f.force * f.force / 8e4);
  EXPECT_EQ(c.to(1.5 * d).force, 0);
}

TEST(LatchingSpring, ContinuousAtTheTurnAndSpeedDoesNotMatter) {
  Contact c{latching(0.3)};
  const double d = 3e-6, turn = c.to(d).force;
  EXPECT_NEAR(c.to(d * (1 - 1e-12)).force / turn, 1, 1.2e-11);  // k2/k1 = 11.1
  LatchingSpring::State<double> s{d};
  EXPECT_EQ(LatchingSpring::update<double>(c.p, paths::pressed(d, d, -9.0), LawOptions{}, s).force, turn);
}

TEST(LatchingSpring, WithoutLossItIsALinearSpring) {
  Contact c{latching(1)};
  c.to(5e-6);
  for (double x = 5e-6; x > 1e-8; x *= 0.7) {
    const auto f = c.to(x);
    EXPECT_NEAR(f.force, 1e4 * x, 2e-16 * 1e4 * 5e-6);
    EXPECT_NEAR(f.energy, 0.5e4 * x * x, 4e-16 * 0.5e4 * 5e-6 * x);
  }
}

TEST(LatchingSpring, NothingComesBackAtZeroRestitution) {
  Contact c{latching(0)};
  EXPECT_EQ(c.to(2e-6).force, 1e4 * 2e-6);
  EXPECT_EQ(c.to(2e-6).force, 1e4 * 2e-6);
  const auto f = c.to(1.9999e-6);
  EXPECT_EQ(f.force, 0);
  EXPECT_EQ(f.energy, 0);
}

// Exact at every speed; the turning point that a step finds is off by its square.
TEST(LatchingSpring, RestitutionIsSquareRootOfTheRatioOfTheLines) {
  for (const double e : {0.9, 0.6, 0.3})
    for (const double speed : {1e-3, 1.0, 7.0})
      for (const double phase : {0.2, 0.7}) {
        const PairParameters p = latching(e);
        const double dt = e * std::sqrt(mass_eff / p.stiffness_n) / 40;
        const double miss = std::abs(paths::impact<LatchingSpring>(p, speed, dt, phase).restitution / e - 1);
        const double finer = std::abs(paths::impact<LatchingSpring>(p, speed, dt / 8, phase).restitution / e - 1);
        EXPECT_LT(miss, 1e-3) << e << ' ' << speed;
        EXPECT_LT(finer, 2e-5) << e << ' ' << speed;
      }
}

TEST(LatchingSpring, ForceIsTheSlopeOfTheEnergyBelowTheLargestOverlap) {
  Contact c{latching(0.6)};
  c.to(1e-5);
  for (const double x : {0.99e-5, 0.8e-5, 0.66e-5})
    EXPECT_NEAR(paths::slope_of_energy(c, x, 1e-9), Contact(c).to(x).force, 1e-8 * 0.1);
}

TEST(LatchingSpring, PathsNeverGainAndOneThatComesBackLosesTheAreaBetweenTheLines) {
  const PairParameters p = latching(0.7);
  paths::expect_paths_lose<LatchingSpring>(p, 1e-9, 1e-5, 0.5e4 * 1e-10);
  Contact c{p};
  double work = 0, x = 0, last = 0;
  const auto walk = [&](double to, int steps) {
    const double from = x;
    for (int i = 1; i <= steps; ++i) {
      const double next = from + (to - from) * i / steps, f = c.to(next).force;
      work += 0.5 * (f + last) * (next - x);
      x = next;
      last = f;
    }
  };
  walk(1e-5, 100);
  walk(0.8e-5, 100);
  walk(0.9e-5, 100);
  walk(1e-9, 200'000);
  EXPECT_NEAR(work / (0.5e4 * 1e-10 * (1 - 0.49)), 1, 1e-6);
}

TEST(LatchingSpring, LanesEqualScalarsAndUnitsDoNotMatter) {
  paths::expect_lanes_equal_scalars<LatchingSpring>(latching(0.6), 1e-9, 1e-5);
  paths::expect_units_do_not_matter<LatchingSpring>(latching(0.6), 1e-9, 1e-5);
}

}  // namespace
}  // namespace contact
