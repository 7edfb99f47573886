// Thornton & Ning's elastic-plastic contact against its formulas in extended precision, and impacts.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "libcontact/laws/normal/hertz.h"
#include "libcontact/laws/normal/thornton_ning.h"
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
using Contact = paths::Walk<ThorntonNing>;

PairParameters yielding(double pressure = 1e9) {
  PairParameters p;
  p.young_eff = 1.1e11;
  p.shear_eff = 0.2e11;
  p.yield_pressure = pressure;
  return p;
}

double yield_overlap(const PairParameters& p) {
  return std::pow(std::numbers::pi * p.yield_pressure / (2 * p.young_eff), 2) * radius_eff;
}

double yield_speed(const PairParameters& p) {
  return std::pow(std::numbers::pi / (2 * p.young_eff), 2) *
         std::sqrt(8 * std::numbers::pi * std::pow(radius_eff, 3) / (15 * mass_eff)) * std::pow(p.yield_pressure, 2.5);
}

double restitution(double x) {  // of x = V_y/V
  return std::sqrt(6 * std::sqrt(3.0) / 5) * std::sqrt(1 - x * x / 6) *
         std::pow(x / (x + 2 * std::sqrt(6.0 / 5 - x * x / 5)), 0.25);
}

#if TEST_HAS_BOOST
using Wide = boost::multiprecision::cpp_bin_float_50;

// The paper's own expressions, with Fm and R_p in the history.
struct Exact {
  Wide e, py, r, pi = boost::math::constants::pi<Wide>();
  explicit Exact(const PairParameters& p) : e(p.young_eff), py(p.yield_pressure), r(radius_eff) {}
  Wide ay() const { return pi * py * r / (2 * e); }
  Wide fy() const { return pow(pi, 3) * r * r * pow(py, 3) / (6 * e * e); }
  Wide loading(const Wide& d) const {
    const Wide y = ay() * ay() / r;
    return d <= y ? Wide(4 * e * sqrt(r * d) * d / 3) : Wide(fy() + pi * py * r * (d - y));
  }
  Wide flattened(const Wide& fm) const { return 4 * e / (3 * fm) * pow((2 * fm + fy()) / (2 * pi * py), Wide(3) / 2); }
  Wide residual(const Wide& dm) const {
    const Wide fm = loading(dm);
    return dm - pow(3 * fm / (4 * e * sqrt(flattened(fm))), Wide(2) / 3);
  }
  Wide unloading(const Wide& d, const Wide& dm) const {
    const Wide x = d - residual(dm);
    return x > 0 ? Wide(4 * e * sqrt(flattened(loading(dm))) * pow(x, Wide(3) / 2) / 3) : Wide(0);
  }
};

TEST(ThorntonNing, LoadingAndUnloadingAreThoseOfTheEquations) {
  const PairParameters p = yielding();
  const Exact exact(p);
  const double y = yield_overlap(p);
  for (double deepest = 0.03 * y; deepest < 1e4 * y; deepest *= 1.71) {
    Contact c{p};
    const auto top = c.to(deepest);
    const double fm = static_cast<double>(exact.loading(deepest));
    EXPECT_NEAR(top.force / fm, 1, 1e-15) << deepest / y;
    EXPECT_NEAR(top.contact_radius, std::sqrt(radius_eff * deepest), 1e-15 * top.contact_radius);
    const Wide gone = deepest > y ? exact.residual(deepest) : Wide(0);
    for (const double share : {0.999, 0.9, 0.6, 0.3, 0.01}) {
      const double x = static_cast<double>(gone + share * (deepest - gone));
      const auto f = c.to(x);
      const Wide force = deepest > y ? exact.unloading(x, deepest) : exact.loading(x);
      EXPECT_NEAR(f.force, static_cast<double>(force), 4e-15 * fm * std::sqrt(deepest / y + 1)) << deepest / y;
      const Wide flat = deepest > y ? exact.flattened(exact.loading(deepest)) : exact.r;
      const double a = static_cast<double>(sqrt(flat * (x - gone)));
      EXPECT_NEAR(f.contact_radius / a, 1, 2e-15 * std::sqrt(deepest / y + 1) / share);
      EXPECT_DOUBLE_EQ(f.stiffness, 2 * p.young_eff * f.contact_radius);
      EXPECT_DOUBLE_EQ(f.stiffness_t, 8 * p.shear_eff * f.contact_radius);
      EXPECT_EQ(f.holding, f.force);
      EXPECT_EQ(f.damping, 0);
    }
    EXPECT_NEAR(c.to(deepest).force / fm, 1, 1e-15);
    if (deepest > y) {
      EXPECT_EQ(c.to(static_cast<double>(0.99 * gone)).force, 0);
      EXPECT_EQ(c.state.overlap_max, deepest);
    }
  }
}

// δm, Fm, δ_p and R_p of an impact at 5 V_y, from the energy 1/2 m* V².
TEST(ThorntonNing, DepthForceAndResidueOfAnImpactAtFiveTimesTheYieldSpeed) {
  const PairParameters p = yielding();
  const Exact exact(p);
  const Wide m = mass_eff;
  const Wide vy =
      pow(exact.pi / (2 * exact.e), 2) * sqrt(8 * exact.pi * pow(exact.r, 3) / (15 * m)) * pow(exact.py, Wide(5) / 2);
  EXPECT_NEAR(static_cast<double>(vy), 0.0459485, 5.1e-8);
  // Work up to δ: (2/5) F_y δ_y + F_y (δ − δ_y) + π p_y R* (δ − δ_y)²/2.
  const Wide y = exact.ay() * exact.ay() / exact.r, slope = exact.pi * exact.py * exact.r;
  const Wide rest = m * 25 * vy * vy / 2 - Wide(2) / 5 * exact.fy() * y;
  const Wide deepest = y + (-exact.fy() + sqrt(exact.fy() * exact.fy() + 2 * slope * rest)) / slope;
  const Wide fm = exact.loading(deepest);
  EXPECT_NEAR(static_cast<double>(deepest), 0.810088e-6, 5.1e-13);
  EXPECT_NEAR(static_cast<double>(fm), 2.33142, 5.1e-6);
  EXPECT_NEAR(static_cast<double>(exact.residual(deepest)), 0.251587e-6, 5.1e-13);
  EXPECT_NEAR(static_cast<double>(exact.flattened(fm)), 1.45047e-3, 5.1e-9);
  const auto hit = paths::impact<ThorntonNing>(p, static_cast<double>(5 * vy), 2e-10, 0.5);
  EXPECT_NEAR(hit.deepest, static_cast<double>(deepest), 1e-7 * hit.deepest);
  Contact c{p};
  const auto f = c.to(static_cast<double>(deepest));
  EXPECT_NEAR(f.force, static_cast<double>(fm), 1e-15 * f.force);
  EXPECT_NEAR(f.contact_radius * f.contact_radius / (2.5 * f.energy / f.force),
              static_cast<double>(exact.flattened(fm)), 1e-17);  // R_p = am²/D, U = (2/5) F D
}
#endif

TEST(ThorntonNing, RestitutionOfImpacts) {
  const PairParameters p = yielding();
  const double vy = yield_speed(p);
  const double printed[][2] = {{2, 0.930626}, {5, 0.773337}, {20, 0.557109}, {100, 0.374299}};
  for (const auto& [ratio, e] : printed) {
    EXPECT_NEAR(restitution(1 / ratio), e, 5.1e-7);
    const double dt = 3e-9;
    const auto hit = paths::impact<ThorntonNing>(p, ratio * vy, dt, 0.3);
    EXPECT_NEAR(hit.restitution / restitution(1 / ratio), 1, 1e-5) << ratio;
  }
  EXPECT_NEAR(restitution(1), 1, 1e-15);
  EXPECT_NEAR(paths::impact<ThorntonNing>(p, 0.9 * vy, 1e-8, 0.3).restitution, 1, 1e-5);
}

TEST(ThorntonNing, ContinuousAtYieldAndAtTheTurn) {
  const PairParameters p = yielding();
  const double y = yield_overlap(p);
  Contact c{p};
  const double at = c.to(y * (1 - 1e-12)).force;
  EXPECT_NEAR(c.to(y * (1 + 1e-12)).force / at, 1, 4e-12);
  const double top = c.to(30 * y).force;
  EXPECT_NEAR(c.to(30 * y * (1 - 1e-12)).force / top, 1, 1e-11);
}

TEST(ThorntonNing, WithoutYieldItIsHertz) {
  Contact c{yielding(std::numeric_limits<double>::infinity())};
  c.to(3e-5);
  Hertz::State<double> none;
  double before = 3e-5;
  for (double x = 3e-5; x > 1e-10; x *= 0.6) {
    const auto f = c.to(x);
    const auto h = Hertz::update<double>(c.p, pressed(x, before), LawOptions{}, none);
    each_of_normal_force(f, h, [](double a, double b) { EXPECT_NEAR(a, b, 2e-15 * std::abs(b)); });
    before = x;
  }
}

TEST(ThorntonNing, SpringShortensWithTheRadius) {
  const PairParameters p = yielding();
  const double y = yield_overlap(p);
  Contact c{p};
  const double wide = c.to(20 * y).contact_radius;
  const auto f = c.to(18 * y);
  EXPECT_NEAR(f.shrink, f.contact_radius / wide, 1e-15);
  const auto g = c.to(16 * y);
  EXPECT_NEAR(g.shrink, g.contact_radius / f.contact_radius, 1e-15);
  EXPECT_EQ(c.to(17 * y).shrink, 1);
  EXPECT_EQ(c.to(1 * y).shrink, 0);
  EXPECT_EQ(c.to(0.5 * y).shrink, 1);  // nothing left to shorten
  LawOptions keep;
  keep.rescale = false;
  c.to(30 * y);
  EXPECT_EQ(ThorntonNing::update<double>(p, pressed(28 * y, 30 * y), keep, c.state).shrink, 1);
}

TEST(ThorntonNing, ForceIsTheSlopeOfTheEnergyBelowTheLargestOverlap) {
  const PairParameters p = yielding();
  const double y = yield_overlap(p);
  for (const double deepest : {0.8, 3.0, 40.0}) {
    Contact c{p};
    const double top = c.to(deepest * y).force;
    for (const double share : {0.99, 0.9, 0.8}) {
      const double x = share * deepest * y;
      EXPECT_NEAR(paths::slope_of_energy(c, x, 1e-5 * x), Contact(c).to(x).force, 1e-8 * top);
    }
  }
}

TEST(ThorntonNing, StiffnessBoundsBothSlopes) {
  const PairParameters p = yielding();
  const double y = yield_overlap(p);
  for (double d = 0.1; d < 1e3; d *= 1.7) {
    Contact c{p};
    const auto f = c.to(d * y);
    const double h = 1e-6 * d * y;
    const double unloading = (f.force - Contact(c).to(d * y - h).force) / h;
    const double loading = (Contact(c).to(d * y + h).force - f.force) / h;
    EXPECT_NEAR(unloading / f.stiffness, 1, 2e-6 * std::sqrt(d + 1));
    EXPECT_LT(loading, f.stiffness * (1 + 1e-6));
  }
}

TEST(ThorntonNing, PathsNeverGain) {
  const PairParameters p = yielding();
  const double y = yield_overlap(p), high = 30 * y;
  const double scale = 0.5 * std::numbers::pi * p.yield_pressure * radius_eff * high * high;
  EXPECT_GT(paths::expect_paths_lose<ThorntonNing>(p, 1e-4 * high, high, scale), 0.3 * scale);
  paths::expect_paths_lose<ThorntonNing>(yielding(1e10), 1e-4 * high, high, scale);
}

TEST(ThorntonNing, LanesEqualScalarsAndUnitsDoNotMatter) {
  const double y = yield_overlap(yielding());
  for (const double pressure : {1e9, std::numeric_limits<double>::infinity()}) {
    paths::expect_lanes_equal_scalars<ThorntonNing>(yielding(pressure), 1e-4 * y, 20 * y);
    paths::expect_units_do_not_matter<ThorntonNing>(yielding(pressure), 1e-4 * y, 20 * y);
  }
}

}  // namespace
}  // namespace contact
