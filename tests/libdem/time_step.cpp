// Stability of the step: one contact of the linear law just below and just above its limit; dt = auto; the monitor.
#include <gtest/gtest.h>

#include <cstdio>
#include <limits>
#include <numbers>

#include "libcontact/laws/mix.h"
#include "tests/libdem/scenes_in_code.h"

namespace dem {
namespace {

constexpr double radius = 0.01, stiffness = 1e4;
const double mass = 2500 * 4.0 / 3.0 * std::numbers::pi * radius * radius * radius;

// Spheres of one undamped or damped material, no friction; the bodies and walls are the test's.
Scene spheres_of(double restitution, double dt) {
  Scene s;
  s.law.name = LawName::spring_dashpot;
  s.materials = {scenes::material("m", 0, 2500, restitution, 0)};
  s.materials[0].stiffness = stiffness;
  s.shapes = {scenes::sphere("ball", radius)};
  s.run.dt_auto = false;
  s.run.dt = dt;
  s.run.steps = 1;
  s.run.dt_contacts = 1;
  return s;
}

// A sphere resting on a plane under its weight, pushed a little: the height's deviation in the last quarter of `steps`
// over that in the second; infinite when the run stops.
double growth(double restitution, double dt, int steps) {
  Scene s = spheres_of(restitution, dt);
  const double weight = 0.02 * radius * stiffness;  // sinks by 2 % of the radius
  s.gravity = {0, 0, -weight / mass};
  s.walls = {scenes::plane("floor", "m", {0, 0, 0}, {0, 0, 1})};
  s.bodies = {scenes::body("ball", "m", {0, 0, 0.98 * radius + 1e-9 * radius})};
  World w = build_world(s);
  double early = 0, late = 0;
  for (int i = 0; i < steps; ++i) {
    try {
      advance(w, 1);
    } catch (const RunError&) {  // it grew until the ball came off the plane, and fell on it again
      return std::numeric_limits<double>::infinity();
    }
    const double off = std::abs(w.particles.motion[0].position.z - 0.98 * radius);
    if (i >= steps / 4 && i < steps / 2) early = std::max(early, off);
    if (i >= steps - steps / 4) late = std::max(late, off);
  }
  return late / early;
}

// The dashpot sees the velocity of half a step ago and is made less by the factor that this asks for (kinematics.h):
// the limit of a single contact is (2/ω)/sqrt(1 + 2β), a little above the (2/ω)(sqrt(1 + β²) − β) that dt goes by.
TEST(TimeStep, OneContactIsStableJustBelowItsLimitAndUnstableJustAbove) {
  for (const double e : {1.0, 0.9, 0.5, 0.2, 0.1}) {
    const double beta = contact::clipped_damping(e), omega = std::sqrt(stiffness / mass);
    const double limit = 2 / omega / std::sqrt(1 + 2 * beta), used = 2 / omega * (std::sqrt(1 + beta * beta) - beta);
    const double below = growth(e, 0.99 * limit, 60), above = growth(e, 1.02 * limit, 60);
    std::printf("  e %.1f: limit %.4f/omega (used %.4f): growth of a push %.1e just below, %.1e just above\n", e,
                limit * omega, used * omega, below, above);
    EXPECT_LE(used, limit * (1 + 1e-15));
    EXPECT_LT(below, 1.05);
    EXPECT_GT(above, 1.5);
  }
}

// What build_world finds for that contact: spheres of one kind against each other (m* = m/2) are stiffer than against
// the plane.
TEST(TimeStep, AutomaticStepIsTheStatedFractionOfTheLimit) {
  for (const double e : {1.0, 0.5}) {
    Scene s = spheres_of(e, 0);
    s.run.dt_auto = true;
    s.run.dt_fraction = 0.125;
    s.bodies = {scenes::body("ball", "m", {0, 0, 0}), scenes::body("ball", "m", {0, 0, 3 * radius})};
    const World w = build_world(s);
    const double beta = contact::clipped_damping(e), omega = std::sqrt(2 * stiffness / mass);
    EXPECT_NEAR(w.time_step.limit * omega / 2 / (std::sqrt(1 + beta * beta) - beta), 1, 1e-12);
    EXPECT_EQ(w.time_step.dt, 0.125 * w.time_step.limit);
    EXPECT_NE(w.time_step.limited_by.find("ball"), std::string::npos);
  }
}

// With friction the stick mode of two solid spheres, ω² = (7/2) kt/m*, is the stiffer one at ν = 0.3.
TEST(TimeStep, TheStickModeIsSeen) {
  Scene s = spheres_of(1, 0);
  s.run.dt_auto = true;
  s.materials[0].friction = 0.5;
  s.bodies = {scenes::body("ball", "m", {0, 0, 0}), scenes::body("ball", "m", {0, 0, 3 * radius})};
  const World w = build_world(s);
  const double kt = stiffness * 2 * (1 - 0.3) / (2 - 0.3);
  EXPECT_NEAR(w.time_step.limit / (2 / std::sqrt(3.5 * kt * 2 / mass)), 1, 1e-12);
}

// Six contacts about a body: its stiffness rows are summed.
TEST(TimeStep, MoreContactsShortenIt) {
  Scene s = spheres_of(1, 0);
  s.run.dt_auto = true;
  s.bodies = {scenes::body("ball", "m", {0, 0, 0}), scenes::body("ball", "m", {0, 0, 3 * radius})};
  const double one = build_world(s).time_step.limit;
  s.run.dt_contacts = 8;
  EXPECT_NEAR(one / build_world(s).time_step.limit, 2, 1e-12);
}

TEST(TimeStep, TheMonitorStopsARunPastItsLimit) {
  Scene s = spheres_of(1, 2.05 / std::sqrt(stiffness / mass));
  s.walls = {scenes::plane("floor", "m", {0, 0, 0}, {0, 0, 1})};
  s.gravity = {0, 0, -0.02 * radius * stiffness / mass};
  s.bodies = {scenes::body("ball", "m", {0, 0, 0.98 * radius})};
  World w = build_world(s);
  const auto run = [&] {
    for (int i = 0; i < 64; ++i) advance(w, 1);
  };
  EXPECT_THROW(run(), RunError);
  EXPECT_LT(w.tightest_limit, w.time_step.dt);
}

}  // namespace
}  // namespace dem
