// Elliptical Hertz contacts against the integrals in 50 digits.
#include <gtest/gtest.h>

#include <limits>

#include "libcontact/laws/elliptical.h"

#if TEST_HAS_BOOST
#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/ellint_2.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#endif

namespace contact {
namespace {

TEST(EllipticalHertz, RoundContactsAreHertzs) {
  for (const double q : {1.0, 0.5, std::numeric_limits<double>::quiet_NaN()}) {
    const EllipticalHertz e = elliptical_hertz(q);
    EXPECT_EQ(e.axis_ratio, 1);
    EXPECT_EQ(e.factor, 1);
    EXPECT_EQ(e.size, 1);
  }
  const EllipticalHertz near = elliptical_hertz(1 + 1e-9);
  EXPECT_NEAR((1 - near.axis_ratio) / 1e-9, 2.0 / 3, 1e-6);
  EXPECT_NEAR(near.factor, 1, 1e-15);
  EXPECT_NEAR(near.size, 1, 1e-15);
}

TEST(EllipticalHertz, NumbersOfTheEquationSheet) {  // R1/R2; b/a, δ/δ0, sqrt(ab)/a0
  const double table[][4] = {{1.5, .763299, .997724, .997730},
                             {2, .630596, .993393, .993436},
                             {4, .399887, .974314, .974931},
                             {10, .222250, .933330, .937098},
                             {50, .082842, .833997, .852913}};
  for (const auto& [q, axes, depth, size] : table) {
    const EllipticalHertz e = elliptical_hertz(q);
    EXPECT_NEAR(e.axis_ratio, axes, 5.1e-7) << q;
    EXPECT_NEAR(std::pow(e.factor, -2.0 / 3), depth, 5.1e-7) << q;
    EXPECT_NEAR(e.size, size, 5.1e-7) << q;
  }
  // An ellipsoid of 2, 1, 1 mm on a flat: radii 4 and 1 mm, E* 38.46 GPa, 10 N: to its last digit.
  const double force = 10, young = 38.46e9, least = 0.5 / 4e-3, most = 0.5 / 1e-3;
  const double radius = 0.5 / std::sqrt(least * most);
  const EllipticalHertz e = elliptical_hertz(most / least);
  const double depth = std::pow(force / (e.factor * 4.0 / 3 * young * std::sqrt(radius)), 2.0 / 3);
  const double mean = e.size * std::cbrt(3 * force * radius / (4 * young));
  EXPECT_NEAR(depth, 2.60050e-6, 0.5e-11);
  EXPECT_NEAR(mean / std::sqrt(e.axis_ratio), 112.642e-6, 0.5e-9);
  EXPECT_NEAR(mean * std::sqrt(e.axis_ratio), 45.0440e-6, 0.5e-10);
  EXPECT_NEAR(3 * force / (2 * std::numbers::pi * mean * mean), 941.034e6, 0.5e3);
}

#if TEST_HAS_BOOST
using Wide = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<100>, boost::multiprecision::et_off>;

struct Reference {
  Wide ratio, factor, size;  // q, φ, sqrt(ab)/a0 of β
};
// Straight from K and E by the arithmetic-geometric mean, in 100 digits: those that the differences lose do not matter.
Reference reference(const Wide& x) {
  const Wide m = 1 - x * x;
  Wide a = 1, b = x, sum = m / 2, power = Wide(1) / 2;
  for (int n = 0; n < 40; ++n) {
    const Wide c = (a - b) / 2, mean = (a + b) / 2;
    b = sqrt(a * b);
    a = mean;
    power *= 2;
    sum += power * c * c;
  }
  const Wide pi = boost::math::constants::pi<Wide>();
  const Wide k = pi / (2 * a), e = k * (1 - sum), d = (k - e) / m;
  const Wide q = (e / (x * x) - k) / (k - e);
  // δ = p0 b K/E* with p0 = 3F/(2π a b), a³ = 3F(K − E)/(2π E* m A), at F = E* = A = 1
  const Wide axis = cbrt(Wide(3) * d / (2 * pi)), depth = Wide(3) * k / (2 * pi * axis);
  const Wide radius = 1 / (2 * sqrt(q)), round = cbrt(Wide(9) / (16 * radius));
  const Wide size = sqrt(axis * axis * x) / cbrt(3 * radius / 4);
  return {q, pow(depth / round, Wide(-3) / 2), size};
}

TEST(EllipticalHertz, TheMeanGivesTheIntegrals) {
  for (const double x : {0.999, 0.7, 0.1, 1e-3, 1e-6}) {
    using Narrow =
        boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>, boost::multiprecision::et_off>;
    const Narrow modulus = sqrt(1 - Narrow(x) * Narrow(x));
    const EllipticIntegrals i = elliptic_integrals(x);
    const Narrow k = boost::math::ellint_1(modulus), e = boost::math::ellint_2(modulus);
    EXPECT_NEAR(double(i.k / k), 1, 4e-16) << x;
    EXPECT_NEAR(double(i.sum / ((k - e) / (modulus * modulus * k) - 0.5)), 1, 4e-16) << x;
  }
}

TEST(EllipticalHertz, AgainstTheFormulasFromRoundToALine) {
  double worst_axes = 0, worst_factor = 0, worst_size = 0;
  // From 1 − 1e-9 down to ratios of curvature of 1e30.
  for (double away = 1e-9; away < 5e15; away *= 1.37) {
    const double x = 1 / (1 + away);
    const Reference want = reference(Wide(x));
    const double q = static_cast<double>(want.ratio);
    // q is rounded: move β along with it, dβ/dq by a difference in 100 digits.
    const Wide h = Wide(x) * Wide("1e-30"), slope = (reference(Wide(x) + h).ratio - want.ratio) / h;
    const Wide axes = Wide(x) + (Wide(q) - want.ratio) / slope;
    const Reference at = reference(axes);
    ASSERT_LT(abs(at.ratio / Wide(q) - 1), Wide("1e-28")) << x;
    const EllipticalHertz e = elliptical_hertz(q);
    worst_axes = std::max(worst_axes, std::abs(double(e.axis_ratio / axes - 1)));
    worst_factor = std::max(worst_factor, std::abs(double(e.factor / at.factor - 1)));
    worst_size = std::max(worst_size, std::abs(double(e.size / at.size - 1)));
  }
  EXPECT_LT(worst_axes, 1e-14);
  EXPECT_LT(worst_factor, 2e-15);
  EXPECT_LT(worst_size, 1e-14);
}
#endif

}  // namespace
}  // namespace contact
