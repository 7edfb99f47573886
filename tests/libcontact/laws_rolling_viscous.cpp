// Viscous rolling resistance: exponential decay, and a step that is too long for it.
#include "libcontact/laws/rolling/rolling_viscous.h"
#include "tests/libcontact/rolling_cases.h"

namespace contact {
namespace {

NoState<double> none;

TEST(RollingViscous, MomentInProportionToTheRate) {
  OnPlane c;
  const double per_rate = 0.5 * 0.01 * 0.01 * c.weight();
  const Vec3d m = c.moment<RollingViscous>({3, -4, 1000}, none).moment;
  EXPECT_NEAR(m.x / per_rate, -3, 1e-14);
  EXPECT_NEAR(m.y / per_rate, 4, 1e-14);
  EXPECT_NEAR(m.z / (0.2 * 2e-4 * c.weight()), -1, 1e-15);
}

// (7/5) m R² dω/dt = −η_r R² F ω: ω = ω0 exp(−(5/7) η_r g t).
TEST(RollingViscous, ARollingSphereDecaysExponentially) {
  double error[2];
  for (const int fine : {0, 1}) {
    OnPlane c;
    c.dt = fine == 1 ? 1e-4 : 2e-4;
    double w = 7, t = 0;
    for (int i = 0; i < (fine == 1 ? 10000 : 5000); ++i, t += c.dt)
      w += c.moment<RollingViscous>({0, w, 0}, none).moment.y / c.about_contact() * c.dt;
    error[fine] = std::abs(w / (7 * std::exp(-5.0 / 7 * 0.5 * 9.81 * t)) - 1);
  }
  EXPECT_LT(error[1], 7e-4);
  EXPECT_NEAR(error[0] / error[1], 2, 0.01);  // Euler's steps
}

TEST(RollingViscous, AStepTooLongForTheDecayDoesNotTurnTheBodyRound) {
  OnPlane c;
  c.pair.rolling_viscosity = 1e9;
  double w = 1;
  for (int i = 0; i < 50; ++i) {
    w += c.moment<RollingViscous>({0, w, 0}, none).moment.y / c.solid() * c.dt;
    EXPECT_GT(w, 0);
  }
  EXPECT_LT(w, 1e-6);
}

TEST(RollingViscous, NothingWithoutFrictionOrForce) { nothing_without_friction<RollingViscous>(); }
TEST(RollingViscous, LanesAreTheScalarLaw) { lanes_are_the_scalar_law<RollingViscous>(); }
TEST(RollingViscous, ChangeOfUnitsKeepsTheBits) { scales_with_units<RollingViscous>(); }

}  // namespace
}  // namespace contact
