// Attraction between bodies: closed forms, energies against work done, bridges that form, hold and rupture.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "libcontact/laws/cohesion/constant_cohesion.h"
#include "libcontact/laws/cohesion/dmt.h"
#include "libcontact/laws/cohesion/liquid_bridge.h"
#include "libcontact/laws/cohesion/liquid_bridge_rabinovich.h"
#include "shapes/math/arc_tangent.h"
#include "shapes/math/pack.h"

#if TEST_HAS_BOOST
#include <boost/math/quadrature/gauss.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#endif

namespace contact {
namespace {

template <class T>
PairOf<T> sample_pair() {
  PairOf<T> p;
  p.cohesion = T(0.25);
  p.work_of_adhesion = T(0.0625);
  const double angle = std::numbers::pi / 18;
  p.contact_angle = T(angle);
  p.wetting = T(std::cos(angle));
  return p;
}

LawOptions water() {
  LawOptions o;
  o.surface_tension = 0.0728;
  o.bridge_volume = 1e-11;
  return o;
}

template <class T>
Kinematics<T> at(const T& overlap) {
  Kinematics<T> k;
  k.overlap = overlap;
  k.normal = {T(0), T(0), T(1)};
  k.radius_eff = T(0.5e-3);
  k.mass_eff = T(1e-5);
  return k;
}

template <class Law, class T = double>
Pull<T> pull_at(double overlap, typename Law::template State<T>& s, const LawOptions& o = water()) {
  return Law::update(sample_pair<T>(), at<T>(T(overlap)), NormalForce<T>{}, o, s);
}

template <class Law>
Pull<double> wet_pull(double overlap, const LawOptions& o = water()) {
  typename Law::template State<double> s;
  pull_at<Law>(0, s, o);
  return pull_at<Law>(overlap, s, o);
}

TEST(Cohesion, ConstantAndDmtPullWhereBodiesOverlapAndNowhereElse) {
  NoState<double> none;
  EXPECT_EQ(pull_at<ConstantCohesion>(1e-6, none).force, 0.25);
  EXPECT_EQ(pull_at<ConstantCohesion>(1e-6, none).energy, -0.25e-6);
  const double dmt = 2 * std::numbers::pi * 0.0625 * 0.5e-3;
  EXPECT_DOUBLE_EQ(pull_at<Dmt>(1e-6, none).force, dmt);
  EXPECT_DOUBLE_EQ(pull_at<Dmt>(1e-6, none).energy, -dmt * 1e-6);
  for (const double apart : {0.0, -1e-9}) {
    for (const Pull<double>& p : {pull_at<ConstantCohesion>(apart, none), pull_at<Dmt>(apart, none)}) {
      EXPECT_EQ(p.force, 0);
      EXPECT_EQ(p.energy, 0);
      EXPECT_EQ(p.bond, 0);
    }
  }
}

// 4πγR of two equal spheres of radius R, as the pull-off force is written with γ of one surface: R* = R/2, W = 2γ.
TEST(Cohesion, DmtPullOffOfASphereOnAPlane) {
  PairOf<double> p;
  p.work_of_adhesion = 2 * 0.05;
  NoState<double> none;
  auto k = at(1e-9);
  k.radius_eff = 1e-3;
  EXPECT_DOUBLE_EQ(Dmt::update(p, k, {}, {}, none).force, 4 * std::numbers::pi * 0.05 * 1e-3);
}

#if TEST_HAS_BOOST
using Wide = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>, boost::multiprecision::et_off>;

struct Bridge {  // the formulas, in 50 digits, from the numbers that the law is given
  Wide radius, volume, gamma, cosine, rupture;
};
Bridge sample_bridge(const LawOptions& o = water()) {
  const auto p = sample_pair<double>();
  return {Wide(2) * Wide(0.5e-3), Wide(o.bridge_volume), Wide(o.surface_tension), Wide(p.wetting),
          (1 + Wide(p.contact_angle) / 2) * cbrt(Wide(o.bridge_volume))};
}
Wide most(const Bridge& b) { return 2 * boost::math::constants::pi<Wide>() * b.radius * b.gamma * b.cosine; }
Wide willett(const Bridge& b, const Wide& h) {
  const Wide s = h * sqrt(b.radius / b.volume);
  return most(b) / (1 + s * (Wide(105) / 100 + s * 5 / 2));
}
Wide pitois(const Bridge& b, const Wide& h) {
  if (h == 0) return most(b);
  return most(b) * (1 - 1 / sqrt(1 + 2 * b.volume / (boost::math::constants::pi<Wide>() * b.radius * h * h)));
}
template <class F>
Wide work(const Bridge& b, const Wide& from, F&& force) {  // Gauss's rule, 30 points in each of 16 parts
  const Wide step = (b.rupture - from) / 16;
  Wide sum = 0;
  for (int i = 0; i < 16; ++i)
    sum += boost::math::quadrature::gauss<Wide, 30>::integrate([&](const Wide& h) { return force(b, h); },
                                                               Wide(from + step * i), Wide(from + step * (i + 1)));
  return sum;
}

template <class Law, class F>
void follows(F&& force, double printed_1, double printed_10, double printed_100) {
  for (const double volume : {1e-11, 1e-13, 1e-9}) {
    LawOptions o = water();
    o.bridge_volume = volume;
    const Bridge b = sample_bridge(o);
    for (const double part : {0.0, 1e-3, 0.1, 0.5, 0.99}) {
      const double gap = part * Law::range({sample_pair<double>()}, o, 0.5e-3);
      const Pull<double> p = wet_pull<Law>(-gap, o);
      EXPECT_EQ(p.bond, 1);
      EXPECT_NEAR(double(p.force / force(b, Wide(gap)) - 1), 0, 1e-15) << volume << " " << part;
      EXPECT_NEAR(double(-p.energy / work(b, Wide(gap), force) - 1), 0, part > 0.9 ? 1e-13 : 4e-15)
          << volume << " " << part;
    }
  }
  EXPECT_NEAR(wet_pull<Law>(-1e-6).force, printed_1, 0.5e-8);
  EXPECT_NEAR(wet_pull<Law>(-1e-5).force, printed_10, 0.5e-8);
  EXPECT_NEAR(wet_pull<Law>(-1e-4).force, printed_100, 0.5e-9);
  // The same struct over an extended-precision number.
  typename Law::template State<Wide> s;
  pull_at<Law, Wide>(0, s);
  const Pull<Wide> wide = pull_at<Law, Wide>(-1e-4, s);
  const Pull<double> narrow = wet_pull<Law>(-1e-4);
  EXPECT_NEAR(double(wide.force / narrow.force), 1, 1e-15);
  EXPECT_NEAR(double(wide.energy / narrow.energy), 1, 1e-14);
}

TEST(Cohesion, WillettsBridgeFollowsTheFormulaAndItsEnergyTheWork) {
  follows<LiquidBridge>(willett, 4.4568e-4, 3.9864e-4, 9.9004e-5);
}
TEST(Cohesion, TheClosedFormBridgeFollowsTheFormulaAndItsEnergyTheWork) {
  follows<LiquidBridgeRabinovich>(pitois, 4.4482e-4, 3.9445e-4, 9.8348e-5);
}

TEST(Cohesion, RangeIsTheRuptureDistance) {
  for (const double volume : {1e-30, 1e-18, 1e-11, 1e-9, 1e-3})
    for (const double radius : {1e-9, 0.5e-3, 3.0}) {
      LawOptions o = water();
      o.bridge_volume = volume;
      const double r = LiquidBridge::range({sample_pair<double>()}, o, radius);
      if (volume / (radius * radius * radius) < 1e-30 || volume / (radius * radius * radius) > 1e30) continue;
      EXPECT_NEAR(double(r / sample_bridge(o).rupture), 1, 1e-15) << volume << " " << radius;
    }
  EXPECT_NEAR(LiquidBridge::range({sample_pair<double>()}, water(), 0.5e-3), 0.23424e-3, 0.5e-8);
  EXPECT_EQ(LiquidBridge::range({sample_pair<double>()}, {}, 0.5e-3), 0);
}

TEST(Cohesion, ArcTangentToAFewUnitsOfTheLastPlace) {
  for (double x = 1e-12; x < 1e12; x *= 1.3) {
    EXPECT_NEAR(double(shapes::arc_tangent(x) / atan(Wide(x))), 1, 4 * 0x1p-52) << x;
    EXPECT_EQ(shapes::arc_tangent(-x), -shapes::arc_tangent(x));
    EXPECT_NEAR(double(shapes::arc_tangent(Wide(x)) / atan(Wide(x)) - 1), 0, 1e-48) << x;
  }
  EXPECT_EQ(shapes::arc_tangent(0.0), 0);
}
#endif

template <class Law>
void slope_is_force() {
  for (const double d : {-2e-4, -1e-4, -1e-5, 1e-6, 1e-5}) {
    const double h = 1e-9;
    const double slope = (wet_pull<Law>(d + h).energy - wet_pull<Law>(d - h).energy) / (2 * h);
    EXPECT_NEAR(-slope / wet_pull<Law>(d).force, 1, 1e-7) << d;
  }
}

TEST(Cohesion, PullIsTheSlopeOfTheEnergy) {
  slope_is_force<LiquidBridge>();
  slope_is_force<LiquidBridgeRabinovich>();
}

template <class Law>
void forms_holds_ruptures() {
  const double reach = Law::range({sample_pair<double>()}, water(), 0.5e-3);
  BridgeState<double> s;
  const auto nothing = [](const Pull<double>& p) { return p.force == 0 && p.energy == 0 && p.bond == 0; };
  EXPECT_TRUE(nothing(pull_at<Law>(-1e-9, s)));  // comes near: dry
  const Pull<double> touch = pull_at<Law>(0, s);
  EXPECT_GT(touch.force, 0);
  EXPECT_EQ(touch.bond, 1);
  const Pull<double> deep = pull_at<Law>(1e-6, s);
  EXPECT_EQ(deep.force, touch.force);
  EXPECT_DOUBLE_EQ(deep.energy, touch.energy - 1e-6 * touch.force);
  double before = touch.force;
  for (int i = 1; i < 100; ++i) {
    const Pull<double> p = pull_at<Law>(-reach * i / 100, s);
    EXPECT_EQ(p.bond, 1);
    EXPECT_LT(p.force, before);
    EXPECT_GT(p.force, 0);
    EXPECT_LT(p.energy, 0);
    before = p.force;
  }
  EXPECT_EQ(pull_at<Law>(-std::nextafter(reach, 0), s).bond, 1);
  EXPECT_NEAR(pull_at<Law>(-std::nextafter(reach, 0), s).energy, 0, 1e-15 * std::abs(touch.energy));
  EXPECT_TRUE(nothing(pull_at<Law>(-reach, s)));
  EXPECT_TRUE(nothing(pull_at<Law>(-0.5 * reach, s)));  // and does not come back
  EXPECT_EQ(pull_at<Law>(1e-7, s).bond, 1);             // until they touch again
  BridgeState<double> dry;
  EXPECT_TRUE(nothing(pull_at<Law>(1e-6, dry, {})));  // no liquid, no bridge
  EXPECT_EQ(dry.wet, 0);
  PairOf<double> repelling = sample_pair<double>();
  repelling.wetting = -0.5;
  EXPECT_EQ(Law::update(repelling, at(1e-6), {}, water(), dry).force, 0);
}

TEST(Cohesion, ABridgeFormsOnTouchAndHoldsUntilItRuptures) {
  forms_holds_ruptures<LiquidBridge>();
  forms_holds_ruptures<LiquidBridgeRabinovich>();
}

// A sphere on a plane in the plane's own form.
TEST(Cohesion, TheClosedFormBridgeOnAPlane) {
  const double r1 = 2e-3, h = 3e-5;
  auto k = at(-h);
  k.radius_eff = r1;
  BridgeState<double> s{1};
  const LawOptions o = water();
  const double d = -h + std::sqrt(h * h + o.bridge_volume / (std::numbers::pi * r1));
  const double plane = 4 * std::numbers::pi * r1 * o.surface_tension * std::cos(std::numbers::pi / 18) / (1 + h / d);
  EXPECT_NEAR(LiquidBridgeRabinovich::update(sample_pair<double>(), k, {}, o, s).force / plane, 1, 1e-14);
}

// Lengths, masses and times in other units, by powers of two: the same bits, scaled.
template <class Law>
void scales() {
  for (const int by : {-9, 3, 10}) {
    const double l = std::ldexp(1.0, by);
    BridgeState<double> s, t;
    LawOptions o = water(), large = o;
    large.bridge_volume *= l * l * l;
    pull_at<Law>(0, s, o);
    t = s;
    auto k = at(-1.3e-4);
    const Pull<double> small = Law::update(sample_pair<double>(), k, {}, o, s);
    k.overlap *= l;
    k.radius_eff *= l;
    const Pull<double> big = Law::update(sample_pair<double>(), k, {}, large, t);
    EXPECT_EQ(big.force, small.force * l);  // N = N/m · m
    EXPECT_EQ(big.energy, small.energy * l * l);
  }
}
TEST(Cohesion, ChangeOfUnitsByPowersOfTwoKeepsTheBits) {
  scales<LiquidBridge>();
  scales<LiquidBridgeRabinovich>();
}

template <class Law>
void lanes() {
  using shapes::Pack;
  std::mt19937_64 engine(7);
  std::uniform_real_distribution<double> overlap(-3e-4, 1e-4), radius(1e-4, 1e-2);
  constexpr bool remembers = !std::is_empty_v<typename Law::template State<double>>;
  for (int round = 0; round < 200; ++round) {
    Kinematics<Pack> k;
    typename Law::template State<Pack> s;
    if constexpr (remembers) s.wet = Pack([](auto i) { return i % 2 == 0 ? 1.0 : 0.0; });
    k.overlap = Pack([&](auto) { return overlap(engine); });
    k.radius_eff = Pack([&](auto) { return radius(engine); });
    const auto before = s;
    const Pull<Pack> out = Law::update(sample_pair<Pack>(), k, NormalForce<Pack>{}, water(), s);
    for (std::size_t i = 0; i < Pack::size(); ++i) {
      auto one = at(double(k.overlap[i]));
      one.radius_eff = k.radius_eff[i];
      typename Law::template State<double> memory;
      if constexpr (remembers) memory.wet = before.wet[i];
      const Pull<double> p = Law::update(sample_pair<double>(), one, {}, water(), memory);
      EXPECT_EQ(p.force, out.force[i]);
      EXPECT_EQ(p.energy, out.energy[i]);
      EXPECT_EQ(p.bond, out.bond[i]);
      if constexpr (remembers) {
        EXPECT_EQ(memory.wet, s.wet[i]);
      }
    }
  }
}
TEST(Cohesion, LanesAreTheScalarLaw) {
  lanes<ConstantCohesion>();
  lanes<Dmt>();
  lanes<LiquidBridge>();
  lanes<LiquidBridgeRabinovich>();
}

}  // namespace
}  // namespace contact
