// Luding's springs: each of the lines, the memory along them, what they lose and the restitution of impacts.
#include <gtest/gtest.h>

#include <cmath>

#include "libcontact/laws/normal/adhesive_plastic_spring.h"
#include "libcontact/laws/normal/linear.h"
#include "tests/libcontact/law_paths.h"

#if TEST_HAS_BOOST
#include <boost/multiprecision/cpp_bin_float.hpp>
#endif

namespace contact {
namespace {

using paths::mass_eff;
using paths::pressed;
using paths::radius_eff;
using Contact = paths::Walk<AdhesivePlasticSpring>;

constexpr double k1 = 1e4, kp = 5e4, kc = 2e4, depth = 0.05;
constexpr double limit = kp / (kp - k1) * depth * 2 * radius_eff;  // δp

PairParameters clay(double pull = kc) {
  PairParameters p;
  p.stiffness_n = k1;
  p.stiffness_t = 0.8 * k1;
  p.plastic_stiffness = kp;
  p.adhesive_stiffness = pull;
  p.plastic_depth = depth;
  return p;
}

double unloading(double deepest) { return k1 + (kp - k1) * deepest / limit; }

#if TEST_HAS_BOOST
TEST(AdhesivePlasticSpring, LinesAreThoseOfTheEquations) {
  using Wide = boost::multiprecision::cpp_bin_float_50;
  const Wide wide_limit = Wide(kp) / (Wide(kp) - k1) * depth * 2 * radius_eff;
  for (const double deepest : {0.01 * limit, 0.3 * limit, 0.999 * limit}) {
    const Wide m = deepest, k2 = k1 + (Wide(kp) - k1) * m / wide_limit, free = (1 - k1 / k2) * m;
    const Wide turn = (k2 - k1) / (k2 + kc) * m;  // where the pulling line begins
    Contact c{clay()};
    const auto top = c.to(deepest);
    const double scale = k1 * deepest;
    EXPECT_NEAR(top.force / scale, 1, 2e-16);
    EXPECT_NEAR(top.stiffness / static_cast<double>(k2), 1, 4e-16);
    for (const double share : {0.9, 0.4, 0.1}) {
      const double x = static_cast<double>(turn + share * (m - turn));
      EXPECT_NEAR(c.to(x).force, static_cast<double>(k2 * (x - free)), 1e-15 * kp * deepest);
      EXPECT_EQ(c.state.overlap_max, deepest);
    }
    EXPECT_NEAR(c.to(static_cast<double>(free)).force, 0, 1e-15 * kp * deepest);
    EXPECT_NEAR(c.to(static_cast<double>(turn)).force, static_cast<double>(-kc * turn), 1e-15 * kp * deepest);
    for (double x = static_cast<double>(turn); x > 1e-6 * deepest; x *= 0.6) {
      const auto f = c.to(x);
      EXPECT_NEAR(f.force, -kc * x, 1e-14 * k1 * c.state.overlap_max * kp / k1);
      EXPECT_NEAR(f.holding, 0, 1e-14 * kp * c.state.overlap_max);
      EXPECT_GE(f.holding, 0);
    }
  }
}
#endif

TEST(AdhesivePlasticSpring, LoadingAgainFromThePullingLineRunsAlongTheSmallerMemory) {
  Contact c{clay()};
  const double deepest = 0.5 * limit;
  c.to(deepest);
  const double turn = (unloading(deepest) - k1) / (unloading(deepest) + kc) * deepest;
  c.to(0.7 * turn);
  const double m = c.state.overlap_max, x = 0.7 * turn;
  EXPECT_LT(m, deepest);
  EXPECT_NEAR(k1 * m - unloading(m) * (m - x), -kc * x, 1e-13 * kp * m);
  EXPECT_NEAR(c.to(0.5 * (x + m)).force, k1 * m - unloading(m) * 0.5 * (m - x), 1e-14 * kp * m);
  EXPECT_DOUBLE_EQ(c.to(m).force, k1 * m);
  EXPECT_DOUBLE_EQ(c.to(1.1 * m).force, 1.1 * k1 * m);
}

TEST(AdhesivePlasticSpring, ElasticBeyondTheLargestFlatteningWhichIsThePlasticDepth) {
  Contact c{clay()};
  const double top = c.to(1.5 * limit).force;
  EXPECT_NEAR(top, k1 * limit + kp * 0.5 * limit, 1e-15 * top);
  EXPECT_NEAR(c.to(2 * limit).force, k1 * limit + kp * limit, 1e-15 * 2 * kp * limit);
  EXPECT_NEAR(c.to(1.5 * limit).force, top, 1e-15 * top);
  EXPECT_NEAR(c.to(depth * 2 * radius_eff).force, 0, 1e-15 * kp * limit);
}

TEST(AdhesivePlasticSpring, WithoutHardeningItIsTheLinearSpring) {
  PairParameters p = clay(0);
  p.plastic_stiffness = k1;
  p.damping = 0.2;
  for (const bool clip : {true, false})
    for (const double v : {0.0, 0.1, -0.1, -9.0}) {
      AdhesivePlasticSpring::State<double> s{};
      Linear::State<double> none;
      LawOptions o;
      o.clip = clip;
      for (double x = 1e-4; x > 1e-7; x *= 0.5) {
        Kinematics<double> k = pressed(x, 2 * x, v);
        k.dt = 1e-7;
        const auto a = AdhesivePlasticSpring::update<double>(p, k, o, s);
        const auto b = Linear::update<double>(p, k, o, none);
        EXPECT_EQ(a.force, b.force);
        EXPECT_EQ(a.elastic, b.elastic);
        EXPECT_EQ(a.holding, b.force > 0 ? b.force : 0);
        EXPECT_DOUBLE_EQ(a.energy, b.energy);
        EXPECT_EQ(a.damping, b.damping);
        EXPECT_EQ(a.damping_t, b.damping_t);
      }
    }
  p = clay(0);
  p.plastic_depth = 0;  // nothing flattens: elastic along kp
  Contact c{p};
  EXPECT_EQ(c.to(1e-5).force, kp * 1e-5);
  EXPECT_EQ(c.to(0.3e-5).force, kp * 0.3e-5);
}

TEST(AdhesivePlasticSpring, TheDashpotAloneDoesNotPullWhenClipped) {
  PairParameters p = clay();
  p.damping = 0.4;
  AdhesivePlasticSpring::State<double> s{0.5 * limit};
  LawOptions o;
  const double x = 0.2 * limit;
  const auto clipped = AdhesivePlasticSpring::update<double>(p, pressed(x, x, -1.0), o, s);
  EXPECT_LT(clipped.elastic, 0);
  EXPECT_EQ(clipped.force, clipped.elastic);
  o.clip = false;
  const auto free = AdhesivePlasticSpring::update<double>(p, pressed(x, x, -1.0), o, s);
  EXPECT_DOUBLE_EQ(free.force, free.elastic - free.damping);
  EXPECT_GE(free.holding, 0);
}

// e² = k1/k2 − (kc/k1)(k2 − k1)²/(k2 (k2 + kc)) with the k2 of the depth that is reached.
TEST(AdhesivePlasticSpring, RestitutionOfImpactsAndSticking) {
  for (const double pull : {0.0, 0.5e4, kc})
    for (const double deepest : {0.05 * limit, 0.15 * limit, 0.3 * limit}) {
      const double k2 = unloading(deepest);
      const double square = k1 / k2 - pull / k1 * (k2 - k1) * (k2 - k1) / (k2 * (k2 + pull));
      ASSERT_GT(square, 0);
      const double v = deepest * std::sqrt(k1 / mass_eff), dt = std::sqrt(mass_eff / k2) / 200;
      const auto hit = paths::impact<AdhesivePlasticSpring>(clay(pull), v, dt, 0.4);
      EXPECT_NEAR(hit.restitution / std::sqrt(square), 1, 1e-4) << pull << ' ' << deepest / limit;
    }
  const double deepest = 0.9 * limit, k2 = unloading(deepest);
  ASSERT_LT(k1 / k2 - kc / k1 * (k2 - k1) * (k2 - k1) / (k2 * (k2 + kc)), 0);
  const double v = deepest * std::sqrt(k1 / mass_eff), dt = std::sqrt(mass_eff / k2) / 100;
  AdhesivePlasticSpring::State<double> s{};
  double x = 0, u = v, force = 0;
  for (int i = 0; i < 100'000; ++i) {
    u -= 0.5 * dt * force / mass_eff;
    x += u * dt;
    ASSERT_GT(x, 0) << i;
    force = AdhesivePlasticSpring::update<double>(clay(), pressed(x, x, u), LawOptions{}, s).force;
    u -= 0.5 * dt * force / mass_eff;
  }
}

TEST(AdhesivePlasticSpring, ForceIsTheSlopeOfTheEnergyBetweenTheLines) {
  Contact c{clay()};
  c.to(0.5 * limit);
  for (const double share : {0.99, 0.8, 0.6, 0.45}) {
    const double x = 0.5 * share * limit;
    EXPECT_NEAR(paths::slope_of_energy(c, x, 1e-4 * x), Contact(c).to(x).force, 1e-9 * k1 * limit);
  }
  c.to(2 * limit);
  EXPECT_NEAR(paths::slope_of_energy(c, 1.7 * limit, 1e-4 * limit) / Contact(c).to(1.7 * limit).force, 1, 1e-9);
}

TEST(AdhesivePlasticSpring, ContinuousAlongAnyPath) {
  Contact c{clay()};
  double last = 0, before = 0;
  for (const double x : paths::wandering(1e-6 * limit, 1.4 * limit, 40, 3000, 3)) {
    const double f = c.to(x).force;
    EXPECT_LE(std::abs(f - last), kp * std::abs(x - before) * (1 + 1e-9) + 1e-12 * kp * limit);
    last = f;
    before = x;
  }
}

TEST(AdhesivePlasticSpring, PathsNeverGain) {
  const double scale = 0.5 * kp * limit * limit;
  for (const double pull : {0.0, kc, 4e4}) {
    EXPECT_GT(paths::expect_paths_lose<AdhesivePlasticSpring>(clay(pull), 1e-6 * limit, 0.9 * limit, scale), 0);
    paths::expect_paths_lose<AdhesivePlasticSpring>(clay(pull), 1e-6 * limit, 1.5 * limit, scale);
    paths::expect_paths_lose<AdhesivePlasticSpring>(clay(pull), 1e-6 * limit, 0.4 * limit, scale);
  }
}

TEST(AdhesivePlasticSpring, LanesEqualScalarsAndUnitsDoNotMatter) {
  for (const double damping : {0.0, 0.3}) {
    PairParameters p = clay();
    p.damping = damping;
    paths::expect_lanes_equal_scalars<AdhesivePlasticSpring>(p, 1e-6 * limit, 1.2 * limit);
    paths::expect_units_do_not_matter<AdhesivePlasticSpring>(p, 1e-6 * limit, 1.2 * limit);
  }
}

}  // namespace
}  // namespace contact
