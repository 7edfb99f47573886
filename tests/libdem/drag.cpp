// Drag on a sphere: the formulas in 50 digits, terminal velocities, a flow that shears.
#include "libdem/fields/drag.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#if TEST_HAS_BOOST
#include <boost/multiprecision/cpp_bin_float.hpp>
#endif

namespace dem {
namespace {

Flow air() {
  Flow f;
  f.density = 1.2;
  f.viscosity = 1.8e-5;
  f.drag_coefficient = 0.44;
  return f;
}

TEST(Drag, LawsByName) {
  for (const DragLawInfo& info : drag_laws) EXPECT_EQ(find_drag_law(info.name), &info);
  EXPECT_EQ(find_drag_law("wen_yu"), nullptr);
}

TEST(Drag, AlongTheRelativeVelocityAndNothingAtRest) {
  for (const DragLawInfo& info : drag_laws) {
    EXPECT_EQ(drag(info.law, air(), 1e-3, {}), Vec3d{});
    const Vec3d f = drag(info.law, air(), 1e-3, {3, -4, 12});
    EXPECT_GT(f.x, 0);
    EXPECT_NEAR(f.y / f.x, -4.0 / 3, 1e-15);
    EXPECT_NEAR(f.z / f.x, 4, 1e-15);
    EXPECT_EQ(norm(f), norm(drag(info.law, air(), 1e-3, {-3, 4, -12})));
  }
}

#if TEST_HAS_BOOST
using Wide = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>, boost::multiprecision::et_off>;

struct Formulas {
  Wide stokes, schiller_naumann, quadratic;  // N
};
Formulas formulas(const Flow& f, double diameter, const Wide& speed) {
  const Wide pi = boost::math::constants::pi<Wide>(), d = diameter, density = f.density, viscosity = f.viscosity;
  const Wide re = density * speed * d / viscosity, stokes = 3 * pi * viscosity * d * speed;
  const Wide growing = 1 + Wide(15) / 100 * pow(re, Wide(687) / 1000), newton = Wide(44) / 100 * re / 24;
  return {stokes, stokes * (growing > newton ? growing : newton),
          pi / 8 * Wide(f.drag_coefficient) * density * d * d * speed * speed};
}

TEST(Drag, FollowsTheFormulas) {
  for (double re = 1e-9; re < 2e5; re *= 1.7) {
    const double diameter = 1e-4, speed = re * 1.8e-5 / (1.2 * diameter);
    const Formulas want = formulas(air(), diameter, speed);
    const auto got = [&](DragLaw law) { return drag(law, air(), diameter, {0, speed, 0}).y; };
    EXPECT_NEAR(double(got(DragLaw::stokes) / want.stokes), 1, 4 * 0x1p-52) << re;
    EXPECT_NEAR(double(got(DragLaw::schiller_naumann) / want.schiller_naumann), 1, 8 * 0x1p-52) << re;
    EXPECT_NEAR(double(got(DragLaw::quadratic) / want.quadratic), 1, 4 * 0x1p-52) << re;
  }
}

// The speed at which the law carries `weight`, by bisection in 50 digits.
template <class F>
Wide terminal(F&& force, const Wide& weight) {
  Wide low = 0, high = 1000;
  for (int i = 0; i < 200; ++i) {
    const Wide middle = (low + high) / 2;
    (force(middle) < weight ? low : high) = middle;
  }
  return low;
}

// A grain of 0.1 mm and 2000 kg/m³ that falls in air until it falls no faster.
TEST(Drag, TerminalVelocities) {
  const double diameter = 1e-4, mass = 2000 * std::numbers::pi / 6 * diameter * diameter * diameter;
  const double weight = mass * (1 - 1.2 / 2000) * 9.81;
  const auto falls = [&](DragLaw law) {
    double v = 0;
    const double dt = 0.02;  // a shorter one stalls farther from the end, at rounding
    for (int i = 0; i < 5000; ++i) v += dt / mass * (weight - drag(law, air(), diameter, {0, 0, v}).z);
    return v;
  };
  const Wide w = Wide(weight);
  const auto stokes = [&](const Wide& v) { return formulas(air(), diameter, v).stokes; };
  const auto schiller = [&](const Wide& v) { return formulas(air(), diameter, v).schiller_naumann; };
  const auto quadratic = [&](const Wide& v) { return formulas(air(), diameter, v).quadratic; };
  EXPECT_NEAR(double(falls(DragLaw::stokes) / terminal(stokes, w)), 1, 1e-14);
  EXPECT_NEAR(double(falls(DragLaw::schiller_naumann) / terminal(schiller, w)), 1, 1e-14);
  EXPECT_NEAR(double(falls(DragLaw::quadratic) / terminal(quadratic, w)), 1, 1e-14);
  // The equation sheet's numbers, to their last digit.
  EXPECT_NEAR(falls(DragLaw::stokes), 0.605192, 5e-7);
  EXPECT_NEAR(falls(DragLaw::schiller_naumann), 0.457536, 5e-7);
  EXPECT_NEAR(1.2 * falls(DragLaw::schiller_naumann) * diameter / 1.8e-5, 3.050, 5e-4);
}
#endif

TEST(Drag, NewtonsRangeBeginsWithoutAJump) {
  Flow f = air();
  f.density = f.viscosity = 1;
  const auto force = [&](double re) { return drag_per_speed(DragLaw::schiller_naumann, f, 1, re); };
  const double at = 988.94785;
  EXPECT_NEAR(force(at + 0.001) / force(at - 0.001), 1, 3e-6);
  EXPECT_GT(force(at - 0.001) / (3 * std::numbers::pi), 0.44 / 24 * (at - 0.001));
  EXPECT_DOUBLE_EQ(force(at + 0.001) / (3 * std::numbers::pi), 0.44 / 24 * (at + 0.001));
}

TEST(Drag, AFlowThatShears) {
  Flow f;
  f.velocity = {1, 0, -2};
  f.gradient = {{{0, 3, 0}, {0, 0, 0}, {0.5, 0, -1}}};
  EXPECT_EQ(f.velocity_at({}), (Vec3d{1, 0, -2}));
  EXPECT_EQ(f.velocity_at({2, 4, 6}), (Vec3d{13, 0, -7}));
}

TEST(Drag, ChangeOfUnitsByPowersOfTwoKeepsTheBits) {
  const Vec3d u{0.3, -0.1, 0.7};
  for (const DragLawInfo& info : drag_laws)
    for (const auto& [length, mass, time] : {Vec3d{8, 1, 1}, Vec3d{1, 0.5, 1}, Vec3d{1, 1, 32}, Vec3d{0.25, 2, 16}}) {
      Flow other = air();
      other.density *= mass / (length * length * length);
      other.viscosity *= mass / (length * time);
      const Vec3d one = drag(info.law, air(), 3e-4, u);
      EXPECT_EQ(drag(info.law, other, 3e-4 * length, u * (length / time)), one * (mass * length / (time * time)));
    }
}

}  // namespace
}  // namespace dem
