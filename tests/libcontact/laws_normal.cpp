// Normal forces against closed forms, and the damping ratio that hits a restitution.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "libcontact/laws/mix.h"
#include "libcontact/laws/normal/hertz.h"
#include "libcontact/laws/normal/linear.h"

namespace contact {
namespace {

Kinematics<double> pressed(double overlap, double closing_speed = 0) {
  Kinematics<double> k{};
  k.overlap = overlap;
  k.normal = {0, 0, 1};
  k.closing_speed = closing_speed;
  k.radius_eff = 0.0125;
  k.mass_eff = 0.02;
  return k;
}

// A normal law without memory; parameter: young_eff of Hertz, stiffness_n of Linear.
template <class Law>
NormalForce<double> answer(double parameter, double damping, const Kinematics<double>& k, bool clip = true) {
  PairOf<double> p;
  p.young_eff = p.stiffness_n = parameter;
  p.damping = damping;
  NoState<double> none;
  return Law::update(p, k, {.clip = clip}, none);
}

// N at depth 10 µm, R* 12.5 mm, of the sheet's micro-slip loop; E* of E = 38 GPa.
TEST(Hertz, ForceOfAKnownContact) {
  const auto f = answer<Hertz>(38e9, 0.0, pressed(10e-6));
  EXPECT_NEAR(f.force, 179.134, 5e-4);
  EXPECT_NEAR(f.contact_radius, 0.353553e-3, 5e-10);
  EXPECT_EQ(f.force, f.elastic);
}

TEST(Hertz, StiffnessIsTheSlopeOfTheForceAndTheForceMinusTheSlopeOfTheEnergy) {
  const double d = 3e-5, h = 1e-9;
  const auto force = [&](double x) { return answer<Hertz>(5e6, 0, pressed(x)).force; };
  const auto energy = [&](double x) { return 4.0 / 15.0 * answer<Hertz>(5e6, 0, pressed(x)).stiffness * x * x; };
  EXPECT_NEAR((force(d + h) - force(d - h)) / (2 * h), answer<Hertz>(5e6, 0, pressed(d)).stiffness, 1e-6 * 2e3);
  EXPECT_NEAR((energy(d + h) - energy(d - h)) / (2 * h) / force(d), 1, 1e-7);
}

TEST(Linear, SpringAndDashpot) {
  const auto f = answer<Linear>(1e4, 0.1, pressed(1e-4, 0.3));
  EXPECT_DOUBLE_EQ(f.elastic, 1.0);
  EXPECT_DOUBLE_EQ(f.damping, 0.2 * std::sqrt(0.02 * 1e4));
  EXPECT_DOUBLE_EQ(f.force, 1.0 + f.damping * 0.3);
}

TEST(NormalLaws, NeverPullAndAnIdleLaneGivesNothing) {
  EXPECT_EQ(answer<Hertz>(5e6, 0.5, pressed(1e-6, -10)).force, 0);
  EXPECT_EQ(answer<Linear>(1e4, 0.5, pressed(1e-6, -10)).force, 0);
  EXPECT_EQ(answer<Hertz>(5e6, 0.5, pressed(0, 0)).force, 0);
  EXPECT_EQ(answer<Linear>(1e4, 0.5, pressed(0, 0)).force, 0);
}

TEST(NormalLaws, PullAgainstASeparationWhenNotClipped) {
  const auto hertz = answer<Hertz>(5e6, 0.5, pressed(1e-6, -10), false);
  const auto linear = answer<Linear>(1e4, 0.5, pressed(1e-6, -10), false);
  EXPECT_DOUBLE_EQ(hertz.force, hertz.elastic - 10 * hertz.damping);
  EXPECT_DOUBLE_EQ(linear.force, linear.elastic - 10 * linear.damping);
  EXPECT_LT(hertz.force, 0);
  EXPECT_LT(linear.force, 0);
}

// One root for the dashpot of a finite step, where its definition takes two and a division.
TEST(Damping, OfAFiniteStepIsTheFactorTimesTheDashpot) {
  double largest = 0;
  for (const double beta : {0.0, 1e-3, 0.3, 1.0, 20.0})
    for (const double stiffness : {1e-3, 1e4, 1e12})
      for (const double mass : {1e-15, 2e-2, 1e6})
        for (const double part : {0.0, 1e-3, 0.1, 1.0})  // of the time sqrt(m/k)
          for (const double p : {1.0, 10.0 / 11.0}) {
            const double dt = part * std::sqrt(mass / stiffness), c0 = beta * std::sqrt(mass * stiffness);
            const double x = 0.25 * p * c0 * dt / mass;
            largest = std::max(largest, x);
            EXPECT_NEAR(lagging_dashpot(beta, stiffness, mass, dt, p), c0 * lag_factor(c0, mass, dt, p),
                        1e-15 * c0 * (1 + x));
          }
  EXPECT_GT(largest, 4);
}

TEST(Damping, ClippedRestitutionOfTheClassicalRatio) {  // β = −ln e/sqrt(π² + ln² e) used with the clipped end
  const double input[][2] = {{0.9, 0.90203}, {0.75, 0.76265}, {0.5, 0.55028}, {0.25, 0.36076}, {0.1, 0.25273}};
  for (const auto& [e, clipped] : input) {
    const double l = std::log(e), beta = -l / std::sqrt(M_PI * M_PI + l * l);
    EXPECT_NEAR(clipped_restitution(beta), clipped, 5.1e-6) << e;
  }
}

TEST(Damping, InverseAgainstTheTable) {
  const double table[][2] = {{0.9, 0.0342652}, {0.7, 0.1222148}, {0.5, 0.2552756},
                             {0.3, 0.4972394}, {0.2, 0.7312469}, {0.1, 1.2431879}};
  for (const auto& [e, beta] : table) EXPECT_NEAR(clipped_damping(e), beta, 1e-7) << e;  // its last digit
  EXPECT_EQ(clipped_damping(1), 0);
}

TEST(Damping, InverseReturnsAndIsSmoothThroughCriticalDamping) {
  for (double e = 0.01; e < 1; e += 0.0037) EXPECT_NEAR(clipped_restitution(clipped_damping(e)) / e, 1, 4e-14) << e;
  EXPECT_DOUBLE_EQ(clipped_restitution(1), std::exp(-2));
  for (const double x : {0.9e-3, 1.1e-3})  // either side of the series
    for (const double beta : {1 - x, 1 + x}) {
      const double d = std::abs((1 - beta) * (1 + beta));
      const double ratio = beta < 1 ? std::acos(beta) / std::sqrt(d) : std::acosh(beta) / std::sqrt(d);
      EXPECT_NEAR(clipped_restitution(beta) / std::exp(-2 * beta * ratio), 1, 1e-12) << beta;
    }
}

// No clipped dashpot is strong enough for e = 0: e → 1/(4β²). What the least one that is allowed costs.
TEST(Damping, ClippedRestitutionIsNeverZeroAndItsPriceIsTheStep) {
  for (const double beta : {1e2, 1e4, 1e6})
    EXPECT_NEAR(clipped_restitution(beta) * 4 * beta * beta, 1, 50 / beta) << beta;
  const double beta = clipped_damping(least_clipped_restitution);
  EXPECT_NEAR(beta, 4.807, 5e-4);
  EXPECT_NEAR(std::sqrt(1 + beta * beta) - beta, 0.1029, 5e-5);  // of the step of an undamped contact
}

TEST(Damping, UnclippedReturnsFromCriticalDampingToNone) {
  EXPECT_EQ(unclipped_damping(0), 1);
  EXPECT_EQ(unclipped_damping(1), 0);
  const double table[][2] = {{0.9, 0.0335184}, {0.5, 0.2154538}, {0.1, 0.5911550}};  // −ln e/sqrt(π² + ln² e)
  for (const auto& [e, beta] : table) EXPECT_NEAR(unclipped_damping(e), beta, 1e-7) << e;
  for (double e = 1e-6; e < 1; e *= 1.7) {
    const double beta = unclipped_damping(e);
    EXPECT_NEAR(std::exp(-M_PI * beta / std::sqrt((1 - beta) * (1 + beta))) / e, 1, 1e-12) << e;
  }
}

// Fourth-order integration of m* δ'' = −F up to the clipped end, with a step far below the contact's time scale.
template <class Force>
double restitution_of(const Force& force, double mass, double speed, double h) {
  double x = 0, v = speed;
  const auto a = [&](double d, double u) { return -force(d, u) / mass; };
  for (;;) {
    const double k1 = a(x, v), k2 = a(x + 0.5 * h * v, v + 0.5 * h * k1),
                 k3 = a(x + 0.5 * h * (v + 0.5 * h * k1), v + 0.5 * h * k2),
                 k4 = a(x + h * (v + 0.5 * h * k2), v + h * k3);
    const double x1 = x + h * v + h * h / 6 * (k1 + k2 + k3), v1 = v + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
    if (v1 < 0 && (x1 <= 0 || force(x1, v1) == 0)) return -v1 / speed;  // a force of exactly 0 is a clipped one
    x = x1;
    v = v1;
  }
}

TEST(Damping, BothLawsReboundAsAskedAtEverySpeed) {
  for (const double e : {0.9, 0.5, 0.2, 0.1})
    for (const double speed : {0.01, 1.0}) {
      const double beta = clipped_damping(e);
      const auto linear = [&](double d, double u) { return answer<Linear>(1e4, beta, pressed(d, u)).force; };
      EXPECT_NEAR(restitution_of(linear, 0.02, speed, 1e-7), e, 2e-5) << "linear";
      const auto hertz = [&](double d, double u) {
        return answer<Hertz>(5e6, beta, pressed(std::max(d, 0.0), u)).force;
      };
      EXPECT_NEAR(restitution_of(hertz, 0.02, speed, speed < 0.1 ? 1e-6 : 4e-7), e, 2e-4) << "hertz";
    }
}

TEST(Damping, BothLawsReboundAsAskedUnclipped) {
  for (const double e : {0.9, 0.5, 0.1, 0.01}) {
    const double beta = unclipped_damping(e);
    const auto linear = [&](double d, double u) { return answer<Linear>(1e4, beta, pressed(d, u), false).force; };
    EXPECT_NEAR(restitution_of(linear, 0.02, 1, 1e-7), e, 2e-5) << "linear";
    const auto hertz = [&](double d, double u) {
      return answer<Hertz>(5e6, beta, pressed(std::max(d, 0.0), u), false).force;
    };
    EXPECT_NEAR(restitution_of(hertz, 0.02, 1, 4e-7), e, 2e-4) << "hertz";
  }
}

TEST(Mix, ModuliOfThePairAndOfARigidPartner) {
  Material glass{.young = 48e9, .poisson = 0.2, .friction = 0.3}, rigid = glass;
  const PairParameters like = mix(glass, glass);
  EXPECT_DOUBLE_EQ(like.young_eff, 25e9);
  EXPECT_NEAR(like.young_eff / (4 * like.shear_eff), (2 - 0.2) / (2 * (1 - 0.2)), 1e-15);  // κ
  rigid.rigid = true;
  const PairParameters wall = mix(glass, rigid);  // out of both moduli: κ stays
  EXPECT_DOUBLE_EQ(wall.young_eff, 2 * like.young_eff);
  EXPECT_DOUBLE_EQ(wall.shear_eff, 2 * like.shear_eff);
  glass.stiffness = 1e5;
  EXPECT_NEAR(mix(glass, glass).stiffness_t / mix(glass, glass).stiffness_n, 2 * 0.8 / 1.8, 1e-15);  // (9.23)
}

}  // namespace
}  // namespace contact
