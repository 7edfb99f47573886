// Drag in the loop: it reaches the terminal velocity, by the curve of Stokes to second order, and its books close.
#include <gtest/gtest.h>

#include <cmath>

#include "libdem/build.h"
#include "tests/libdem/scenes_in_code.h"

namespace dem {
namespace {

constexpr double radius = 50e-6, density = 2000, viscosity = 1.8e-5, air = 1.2;

Scene falling(const char* law, double dt) {
  Scene s;
  s.gravity = {0, 0, -9.81 * (1 - air / density)};  // less buoyancy
  s.materials = {scenes::material("m", 5e6, density, 1, 0)};
  s.shapes = {scenes::sphere("ball", radius)};
  s.bodies = {scenes::body("ball", "m", {0, 0, 0})};
  s.drag.law = law;
  s.drag.density = air;
  s.drag.viscosity = viscosity;
  s.run.dt_auto = false;
  s.run.dt = dt;
  s.run.steps = 1;
  return s;
}

double speed_after(Scene s, double time) {
  World w = build_world(s);
  for (int i = 0, n = static_cast<int>(std::lround(time / s.run.dt)); i < n; ++i) advance(w, 1);
  return w.particles.motion[0].velocity.z;
}

TEST(DragInTheLoop, ReachesTheTerminalVelocity) {  // published digits
  EXPECT_NEAR(-speed_after(falling("schiller_naumann", 1e-3), 3), 0.457536, 1e-6);
  EXPECT_NEAR(-speed_after(falling("stokes", 1e-3), 3), 0.605192, 1e-6);
}

// v = v∞ (1 − exp(−t/τ)), τ = ρ d²/(18 η).
TEST(DragInTheLoop, FollowsStokesToSecondOrder) {
  const double tau = density * 4 * radius * radius / (18 * viscosity), final = 9.81 * (1 - air / density) * tau;
  const auto error = [&](double share) {
    const Scene s = falling("stokes", share * tau);
    return std::abs(-speed_after(s, tau) - final * (1 - std::exp(-1.0)));
  };
  const double coarse = error(1.0 / 20), fine = error(1.0 / 40);
  EXPECT_LT(coarse, 1e-4 * final);
  EXPECT_NEAR(std::log2(coarse / fine), 2, 0.05);
}

// A step far beyond 2 τ, at which a force by the velocity of half a step ago would throw the body about.
TEST(DragInTheLoop, IsStableAtAnyStep) {
  const double v = speed_after(falling("stokes", 1), 50);
  EXPECT_LT(std::abs(v), 1.3);
}

TEST(DragInTheLoop, FlowThatShearsCarriesBodiesAndTheBooksClose) {
  Scene s = falling("schiller_naumann", 1e-3);
  s.gravity = {};
  s.drag.velocity = {0.1, 0, 0};
  s.drag.gradient = {{0, 0, 5}, {0, 0, 0}, {0, 0, 0}};
  s.bodies.push_back(scenes::body("ball", "m", {0, 0, 0.02}));
  World w = build_world(s);
  const Vec3d before = momentum(w);
  for (int i = 0; i < 2000; ++i) advance(w, 1);
  EXPECT_NEAR(scenes::motion(w, 0).velocity.x, 0.1, 1e-9);
  EXPECT_NEAR(scenes::motion(w, 1).velocity.x, 0.1 + 5 * 0.02, 1e-9);
  const Vec3d gained = momentum(w) - before;
  const double scale = norm(gained);
  EXPECT_GT(scale, 0);
  EXPECT_NEAR(gained.x / scale, w.balance.impulse[0].value() / scale, 1e-12);
}

TEST(DragInTheLoop, SameBitsForThreadsAndAcrossARestart) {
  Scene s = scenes::every_shape(40);
  s.drag = falling("schiller_naumann", 1).drag;
  s.drag.velocity = {0.5, 0.1, 0};
  const World whole = scenes::run(s, 300);
  const World without = scenes::run(scenes::every_shape(40), 300);
  EXPECT_NE(state_hash(whole), state_hash(without));
  EXPECT_EQ(state_hash(scenes::run(s, 300, 2)), state_hash(whole));
  World half = scenes::run(s, 150), rest = build_world(s);
  load_state(rest, save_state(half));
  for (int i = 0; i < 150; ++i) advance(rest, 1);
  EXPECT_EQ(state_hash(rest), state_hash(whole));
  EXPECT_EQ(rest.balance.impulse[0].value(), whole.balance.impulse[0].value());
}

}  // namespace
}  // namespace dem
