// Johnson, Kendall & Roberts: radius, force, pull-off and work of separation against the formulas in extended
// precision.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "libcontact/laws/normal/hertz.h"
#include "libcontact/laws/normal/jkr.h"
#include "tests/libcontact/law_paths.h"

#if TEST_HAS_BOOST
#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#endif

namespace contact {
namespace {

using paths::mass_eff;
using paths::pressed;
using paths::radius_eff;
using Contact = paths::Walk<Jkr>;

PairParameters sticky(double work = 0.2) {
  PairParameters p;
  p.young_eff = 1.1e9;
  p.shear_eff = 0.2e9;
  p.work_of_adhesion = work;
  return p;
}

double pull_off(const PairParameters& p) { return 1.5 * std::numbers::pi * p.work_of_adhesion * radius_eff; }

#if TEST_HAS_BOOST
using Wide = boost::multiprecision::cpp_bin_float_50;
const Wide wide_pi = boost::math::constants::pi<Wide>();

struct Exact {
  Wide e, w, r;
  explicit Exact(const PairParameters& p) : e(p.young_eff), w(p.work_of_adhesion), r(radius_eff) {}
  Wide overlap(const Wide& a) const { return a * a / r - sqrt(2 * wide_pi * w * a / e); }  // (9.13)
  Wide force(const Wide& a) const { return 4 * e * a * a * a / (3 * r) - sqrt(8 * wide_pi * w * e * a * a * a); }
  Wide release() const { return -Wide(3) / 4 * cbrt(wide_pi * wide_pi * w * w * r / (e * e)); }
  Wide a0() const { return cbrt(9 * wide_pi * w * r * r / (2 * e)); }
  // The larger root of (9.13) by bisection between the fold and a bound.
  Wide radius(const Wide& depth) const {
    Wide low = a0() / cbrt(Wide(36)), high = sqrt(r * (depth > 0 ? depth : Wide(0))) + 4 * a0();
    for (int i = 0; i < 190; ++i) {
      const Wide middle = (low + high) / 2;
      (overlap(middle) < depth ? low : high) = middle;
    }
    return low;
  }
};

TEST(Jkr, CubeRoot) {
  for (double x = 1e-40; x < 1e40; x *= 1.731) {
    EXPECT_NEAR(static_cast<double>(Wide(shapes::cube_root(x)) / cbrt(Wide(x)) - 1), 0, 4.5e-16) << x;
    EXPECT_LT(abs(shapes::cube_root(Wide(x)) / cbrt(Wide(x)) - 1), Wide(1e-29)) << x;
  }
  EXPECT_EQ(shapes::cube_root(0.0), 0);
}

TEST(Jkr, RadiusAndForceAreThoseOfTheEquations) {
  for (const double work : {1e-6, 1e-3, 0.2, 50.0}) {
    const PairParameters p = sticky(work);
    const Exact exact(p);
    const double end = static_cast<double>(exact.release()), pull = pull_off(p);
    std::vector<double> depths = {0};
    for (double x = -1e-4 * end; x < -1e5 * end; x *= 1.37) depths.push_back(x);
    for (const double depth : depths) {
      Contact c{p};
      const auto f = c.to(depth);
      const Wide a = exact.radius(depth);
      EXPECT_NEAR(static_cast<double>(f.contact_radius / a - 1), 0, 5e-16) << work << ' ' << depth;
      EXPECT_NEAR(f.force, static_cast<double>(exact.force(a)), 2e-15 * (pull + std::abs(f.force))) << depth;
      EXPECT_EQ(f.bond, 1);
    }
    for (double share = 0.03; share < 1; share += 0.97 * (1 - share) * 0.2) {  // across the gap, towards the end
      Contact c{p};
      c.to(0);
      const auto f = c.to(share * end);
      const Wide a = f.contact_radius;
      EXPECT_NEAR(static_cast<double>((exact.overlap(a) - share * end) / end), 0, 1.5e-15) << share;
      EXPECT_NEAR(f.force, static_cast<double>(exact.force(exact.radius(share * end))),
                  2e-15 * pull / std::sqrt(1 - share));
      if (share > 1 - 1e-9) break;
    }
  }
}

// Both forms of the law's table: D = δ/|δf| = 6^⅓(2x² − (4/3)√x), F/Fc = 4(x³ − x^{3/2}), x = a/a0.
TEST(Jkr, TableInUnitsOfTheBranchAndThePullOff) {
  const PairParameters p = sticky();
  const Exact exact(p);
  const double printed[][3] = {{-0.8, -0.917174, 0.502401}, {-0.5, -0.999772, 0.623598}, {-0.2, -0.958814, 0.712542},
                               {0, -0.888889, 0.763143},    {0.2, -0.792345, 0.809145},  {0.5, -0.605578, 0.871810},
                               {1, -0.201195, 0.964265},    {2, 0.885107, 1.120755},     {5, 5.740016, 1.478673},
                               {10, 17.559825, 1.916932},   {50, 203.447464, 3.882214}};
  const Wide end = -exact.release(), pull = Wide(1.5) * wide_pi * exact.w * exact.r, six = cbrt(Wide(6));
  for (const auto& [d, force, radius] : printed) {
    Contact c{p};
    c.to(0);
    const auto f = c.to(static_cast<double>(d * end));
    Wide low = 1 / (six * six), high = 8;
    for (int i = 0; i < 190; ++i) {
      const Wide x = (low + high) / 2;
      (six * (2 * x * x - 4 * sqrt(x) / 3) < d ? low : high) = x;
    }
    const Wide reduced = 4 * (low * low * low - low * sqrt(low));
    EXPECT_NEAR(static_cast<double>(f.contact_radius / exact.a0()), static_cast<double>(low), 2e-15) << d;
    EXPECT_NEAR(static_cast<double>(f.force / pull), static_cast<double>(reduced), 4e-15 * (1 + std::abs(force))) << d;
    EXPECT_NEAR(static_cast<double>(reduced), force, 5.1e-7) << d;  // the digits in print
    EXPECT_NEAR(static_cast<double>(low), radius, 5.1e-7) << d;
  }
}

TEST(Jkr, PullOffForceAndTheForcesAtTouchAndAtTheEnd) {
  const PairParameters p = sticky();
  const Exact exact(p);
  const double pull = pull_off(p), end = static_cast<double>(exact.release());
  Contact c{p};
  EXPECT_NEAR(c.to(0).force / pull, -8.0 / 9, 1e-15);
  const Wide a = exact.a0() / cbrt(Wide(4)), least = -a * a / (3 * exact.r);
  EXPECT_NEAR(c.to(static_cast<double>(least)).force / pull, -1, 2e-15);
  double lowest = 0;
  for (double x = 0; x > end; x += end / 1000) lowest = std::min(lowest, c.to(x).force);
  EXPECT_NEAR(lowest / pull, -1, 1e-6);
  EXPECT_GE(lowest / pull, -1 - 2e-15);
  EXPECT_NEAR(c.to(end * (1 - 1e-14)).force / pull, -5.0 / 9, 1e-6);
  const Wide zero = exact.a0() * exact.a0() / (3 * exact.r);
  EXPECT_NEAR(c.to(static_cast<double>(zero)).force / pull, 0, 2e-15);
}

TEST(Jkr, WorkToPartTheBodiesAndTheSpeedThatSticks) {
  const PairParameters p = sticky();
  const Exact exact(p);
  // −U(0) by the equation in a, from the end's radius to that at touch.
  const Wide af = exact.a0() / cbrt(Wide(36)), at = exact.a0() * cbrt(Wide(4) / 9);
  const auto integral = [&](const Wide& a) {
    return 8 * exact.e * pow(a, 5) / (15 * exact.r * exact.r) -
           4 * sqrt(2 * wide_pi * exact.w * exact.e) * pow(a, Wide(7) / 2) / (3 * exact.r) + wide_pi * exact.w * a * a;
  };
  const Wide lost = integral(af) - integral(at);
  const Wide group = cbrt(pow(exact.w, 5) * pow(exact.r, 4) / (exact.e * exact.e));
  EXPECT_NEAR(static_cast<double>(lost / group), 7.092196, 5.1e-7);
  EXPECT_NEAR(static_cast<double>(sqrt(2 * lost / group)), 3.766217, 5.1e-7);
  Contact c{p};
  EXPECT_NEAR(c.to(0).energy, -static_cast<double>(lost), 4e-15 * static_cast<double>(lost));
  EXPECT_NEAR(c.to(0.999999999999 * static_cast<double>(exact.release())).energy / static_cast<double>(lost), 0, 1e-11);
}

TEST(Jkr, RangeIsTheWidestGap) {
  for (const double work : {1e-6, 0.2, 50.0}) {
    const PairParameters p = sticky(work);
    const double range = Jkr::range(p, radius_eff);
    EXPECT_NEAR(static_cast<double>(-range / Exact(p).release()), 1, 1e-15);
    Contact c{p};
    c.to(0);
    EXPECT_EQ(c.to(-range).bond, 1);
    EXPECT_EQ(c.to(-range * (1 + 1e-15)).bond, 0);
  }
}
#endif

TEST(Jkr, IsMadeAtTouchLetsGoAtTheEndAndIsNotMadeAcrossAGap) {
  const PairParameters p = sticky();
  const double range = Jkr::range(p, radius_eff);
  Contact c{p};
  auto f = c.to(-0.5 * range);
  EXPECT_EQ(f.force, 0);
  EXPECT_EQ(f.bond, 0);
  EXPECT_EQ(f.holding, 0);
  EXPECT_EQ(f.energy, 0);
  EXPECT_LT(c.to(0).force, 0);
  EXPECT_LT(c.to(-0.5 * range).force, 0);
  f = c.to(-1.001 * range);
  EXPECT_EQ(f.force, 0);
  EXPECT_EQ(f.bond, 0);
  EXPECT_EQ(c.state.bonded, 0);
  EXPECT_EQ(c.state.radius, 0);
  EXPECT_EQ(c.to(-0.5 * range).force, 0);
  EXPECT_GT(c.to(10 * range).force, 0);
}

TEST(Jkr, ForceIsTheSlopeOfTheEnergy) {
  const PairParameters p = sticky();
  const double range = Jkr::range(p, radius_eff);
  for (const double d : {-0.99, -0.9, -0.5, -0.1, 0.0, 0.3, 1.0, 7.0, 300.0}) {
    Contact c{p};
    c.to(0);
    const auto f = c.to(d * range);
    const double h = 1e-5 * range * std::min(1.0, 1 + d) * (1 + std::abs(d));
    EXPECT_NEAR(paths::slope_of_energy(c, d * range, h), f.elastic, 2e-8 * (pull_off(p) + std::abs(f.elastic))) << d;
  }
}

TEST(Jkr, StiffnessBoundsEverySlopeThatRises) {
  const PairParameters p = sticky();
  const double range = Jkr::range(p, radius_eff);
  Contact c{p};
  c.to(0);
  for (double d = -0.999; d < 100; d += 0.01 * (1 + std::abs(d))) {
    const double h = 1e-5 * range * (1 + std::min(d, 0.0));
    const auto f = c.to(d * range);
    const double slope = (c.to(d * range + h).force - c.to(d * range - h).force) / (2 * h);
    EXPECT_LT(slope, f.stiffness) << d;
    EXPECT_NEAR(f.holding, f.force + 2 * pull_off(p), 1e-15 * (f.holding + pull_off(p)));
    EXPECT_GT(f.holding, 0);
  }
}

TEST(Jkr, WithoutAdhesionItIsHertz) {
  PairParameters p = sticky(0);
  p.damping = 0.2;
  for (const bool clip : {true, false})
    for (double x = 1e-9; x < 1e-5; x *= 3)
      for (const double v : {0.0, 0.3, -0.3, -30.0}) {
        LawOptions o;
        o.clip = clip;
        Jkr::State<double> state{1, 0};
        Hertz::State<double> none;
        Kinematics<double> k = pressed(x, x, v);
        k.dt = 1e-7;
        const auto a = Jkr::update<double>(p, k, o, state);
        const auto b = Hertz::update<double>(p, k, o, none);
        const double scale = b.elastic + b.damping * std::abs(v);
        EXPECT_NEAR(a.force, b.force, 1e-15 * scale);
        EXPECT_NEAR(a.energy, b.energy, 1e-15 * b.energy);
        EXPECT_NEAR(a.holding, b.holding, 1e-15 * scale);
        EXPECT_DOUBLE_EQ(a.contact_radius, b.contact_radius);
      }
  Contact c{p};
  c.to(1e-6);
  EXPECT_EQ(c.to(-1e-12).bond, 0);
  EXPECT_EQ(Jkr::range(p, radius_eff), 0);
}

TEST(Jkr, SpringShortensWithTheRadiusUnlessToldNotTo) {
  const PairParameters p = sticky();
  const double range = Jkr::range(p, radius_eff);
  Contact c{p};
  const double wide = c.to(3 * range).contact_radius;
  const auto f = c.to(-0.3 * range);
  EXPECT_DOUBLE_EQ(f.shrink, f.contact_radius / wide);
  EXPECT_EQ(c.to(range).shrink, 1);
  LawOptions keep;
  keep.rescale = false;
  EXPECT_EQ(Jkr::update<double>(p, pressed(-0.3 * range, range), keep, c.state).shrink, 1);
}

TEST(Jkr, TheDashpotAloneDoesNotPullWhenClipped) {
  PairParameters p = sticky();
  p.damping = 0.3;
  Jkr::State<double> s{1, 0};
  LawOptions o;
  const auto clipped = Jkr::update<double>(p, pressed(0, 1e-9, -1.0), o, s);
  EXPECT_EQ(clipped.force, clipped.elastic);
  const auto closing = Jkr::update<double>(p, pressed(0, 1e-9, 1.0), o, s);
  EXPECT_DOUBLE_EQ(closing.force, closing.elastic + closing.damping);
  o.clip = false;
  const auto free = Jkr::update<double>(p, pressed(0, 1e-9, -1.0), o, s);
  EXPECT_DOUBLE_EQ(free.force, free.elastic - free.damping);
}

double sticking_speed(const PairParameters& p) {
  Contact c{p};
  return std::sqrt(-2 * c.to(0).energy / mass_eff);
}

// e = sqrt(1 − (Vs/V)²), and bodies that come slower stay.
TEST(Jkr, RestitutionOfAnImpactAndSticking) {
  const PairParameters p = sticky();
  const double limit = sticking_speed(p), range = Jkr::range(p, radius_eff);
  for (const double v : {1.1, 1.5, 2.0, 4.0})
    for (const double phase : {0.1, 0.5, 0.9}) {
      const double exact = std::sqrt(1 - 1 / (v * v)), dt = range / (v * limit) / 100;
      const auto coarse = paths::impact<Jkr>(p, v * limit, dt, phase);
      const auto fine = paths::impact<Jkr>(p, v * limit, dt / 16, phase);
      ASSERT_FALSE(coarse.stuck || fine.stuck);
      EXPECT_NEAR(coarse.restitution, exact, 1e-4) << v;
      EXPECT_NEAR(fine.restitution, exact, 2e-6) << v;  // 1/64 of it, at order 1.5
    }
  Jkr::State<double> s{};
  double x = 0, v = 0.97 * limit, force = 0, widest = 0;
  const double dt = range / v / 500;
  for (int i = 0; i < 200'000; ++i) {
    v -= 0.5 * dt * force / mass_eff;
    x += v * dt;
    const auto f = Jkr::update<double>(p, pressed(x, x, v), LawOptions{}, s);
    ASSERT_EQ(f.bond, 1) << i;
    force = f.force;
    widest = std::min(widest, x);
    v -= 0.5 * dt * force / mass_eff;
  }
  EXPECT_LT(widest, -0.5 * range);
  EXPECT_GT(widest, -range);
}

TEST(Jkr, PathsNeverGain) {
  const PairParameters p = sticky();
  const double range = Jkr::range(p, radius_eff);
  Contact c{p};
  c.to(0);
  const double scale = c.to(10 * range).energy - c.to(0).energy;
  paths::expect_paths_lose<Jkr>(p, -0.9 * range, 10 * range, scale);
}

TEST(Jkr, LanesEqualScalarsAndUnitsDoNotMatter) {
  PairParameters p = sticky();
  const double range = Jkr::range(p, radius_eff);
  paths::expect_lanes_equal_scalars<Jkr>(p, -1.2 * range, 4 * range);
  paths::expect_units_do_not_matter<Jkr>(p, -0.99 * range, 4 * range);
  p.damping = 0.3;
  paths::expect_lanes_equal_scalars<Jkr>(p, -1.2 * range, 4 * range);
  paths::expect_units_do_not_matter<Jkr>(p, -1.2 * range, 4 * range);
  p.work_of_adhesion = 0;
  paths::expect_lanes_equal_scalars<Jkr>(p, -1.2 * range, 4 * range);
}

}  // namespace
}  // namespace contact
