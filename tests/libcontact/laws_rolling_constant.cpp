// Constant rolling and twisting friction: where a rolling or spinning sphere stops, and that it stays.
#include "libcontact/laws/rolling/rolling_constant.h"
#include "tests/libcontact/rolling_cases.h"

namespace contact {
namespace {

NoState<double> none;

TEST(RollingConstant, MomentAgainstTheRotationAtTheCaps) {
  OnPlane c;
  const Vec3d m = c.moment<RollingConstant>({30, 40, -120}, none).moment;
  const double rolling = 0.1 * 0.01 * c.weight(), twisting = 0.2 * 2e-4 * c.weight();
  EXPECT_NEAR(m.x / rolling, -0.6, 1e-15);
  EXPECT_NEAR(m.y / rolling, -0.8, 1e-15);
  EXPECT_NEAR(m.z / twisting, 1, 1e-15);
  c.normal.contact_radius = 0;  // a law that has none
  EXPECT_NEAR(c.moment<RollingConstant>({0, 0, -1200}, none).moment.z / (0.2 * 0.01 * c.weight()), 1, 1e-15);
  EXPECT_EQ(c.moment<RollingConstant>({}, none).moment, Vec3d{});
  c.dt = 0;  // the moment as it stands: no ramp
  EXPECT_NEAR(c.moment<RollingConstant>({1e-12, 0, 0}, none).moment.x / -rolling, 1, 1e-15);
}

TEST(RollingConstant, TheRampTakesAQuarterOfTheRotationInAStep) {
  const OnPlane c;
  const Vec3d m = c.moment<RollingConstant>({1e-6, 0, 1e-6}, none).moment;
  EXPECT_NEAR(m.x * c.dt / c.solid() / -1e-6, 0.25, 1e-15);
  EXPECT_NEAR(m.z * c.dt / c.solid() / -1e-6, 0.25, 1e-15);
}

// Rolls without slip: (7/5) m R² dω/dt = M. It stops after v²/(2 · 5/7 μ_r g) and v/(5/7 μ_r g).
TEST(RollingConstant, ARollingSphereStopsWhereTheClosedFormSays) {
  double error[2];
  for (const int fine : {0, 1}) {
    OnPlane c;
    c.dt = fine == 1 ? 1e-5 : 2e-5;
    const double slow = 5.0 / 7 * 0.1 * 9.81, x_end = 1 / (2 * slow), t_end = 1 / slow;
    double x = 0, v = 1, t = 0, t_half = 0;
    while (t < 1.1 * t_end) {
      const double before = v;
      v += c.moment<RollingConstant>({0, v / c.radius, 0}, none).moment.y / c.about_contact() * c.radius * c.dt;
      ASSERT_LE(v, before);
      ASSERT_GE(v, 0);
      x += 0.5 * (before + v) * c.dt;
      t += c.dt;
      if (v >= 0.5) t_half = t;
    }
    EXPECT_NEAR(t_half / (0.5 * t_end), 1, 5e-5);
    EXPECT_LT(v, 1e-30);  // at rest, not only slow
    error[fine] = std::abs(x - x_end) / x_end;
    EXPECT_NEAR(x_end, 0.713558, 5e-7);
    EXPECT_NEAR(t_end, 1.427115, 1e-6);
  }
  EXPECT_LT(error[1], 2e-8);
  EXPECT_NEAR(error[0] / error[1], 4, 0.1);  // that of the ramp: speed and time of it are both in proportion to dt
}

// (2/5) m R² dω/dt = −μ_tw m g a: ω = ω0 − (5 μ_tw g a/(2 R²)) t until it stands.
TEST(RollingConstant, ASpinningSphereSlowsDownInProportionToTime) {
  OnPlane c;
  const double slow = 2.5 * 0.2 * 9.81 * 2e-4 / (0.01 * 0.01), start = 5;
  double w = start;
  const int steps = 100000;
  for (int i = 1; i <= steps; ++i) {
    w += c.moment<RollingConstant>({0, 0, w}, none).moment.z / c.solid() * c.dt;
    ASSERT_GE(w, 0);
    if (i == 20000) {
      EXPECT_NEAR((start - w) / (slow * 20000 * c.dt), 1, 1e-11);
    }
  }
  EXPECT_LT(w, 1e-30);
}

TEST(RollingConstant, ManyContactsDoNotTurnABodyRound) {
  const OnPlane c;
  double w = 1e-3;
  for (int i = 0; i < 100; ++i) {
    const double next = w + 4 * c.moment<RollingConstant>({0, w, 0}, none).moment.y / c.solid() * c.dt;
    EXPECT_GE(next, -1e-18);
    w = next;
  }
}

TEST(RollingConstant, NothingWithoutFrictionOrForce) { nothing_without_friction<RollingConstant>(); }
TEST(RollingConstant, LanesAreTheScalarLaw) { lanes_are_the_scalar_law<RollingConstant>(); }
TEST(RollingConstant, ChangeOfUnitsKeepsTheBits) { scales_with_units<RollingConstant>(); }

}  // namespace
}  // namespace contact
