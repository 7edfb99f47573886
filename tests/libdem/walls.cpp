// Walls with prescribed motion: places and velocities against closed forms, what they do to bodies, gates.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/libdem/scenes_in_code.h"

namespace dem {
namespace {

Scene with_wall(const WallSpec& wall) {
  Scene s;
  s.materials = {scenes::material("m", 5e6, 2500, 0.5, 0.5)};
  s.shapes = {scenes::sphere("ball", 0.01)};
  s.walls = {wall};
  s.run.dt_auto = false;
  s.run.dt = 1e-4;
  s.run.steps = 1;
  return s;
}

void expect_near(const Vec3d& a, const Vec3d& b, double size) {
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(a[k], b[k], 1e-12 * size) << "component " << k;
}

TEST(Walls, Translation) {
  WallSpec m = scenes::plane("w", "m", {1, 2, 3}, {0, 0, 1});
  m.motion = WallMotion::translation;
  m.velocity = {0.5, -0.25, 2};
  m.start = 0.01;
  m.stop = 0.05;
  World w = build_world(with_wall(m));
  while (w.time() < 0.08) {
    advance(w, 1);
    const double moved = std::clamp(w.time(), m.start, m.stop) - m.start;
    expect_near(w.walls[0].position, m.point + m.velocity * moved, 3);
    const bool moves = w.time() >= m.start && w.time() < m.stop;
    expect_near(w.walls[0].velocity, m.velocity * (moves ? 1.0 : 0.0), 2);
  }
}

TEST(Walls, Rotation) {
  WallSpec m = scenes::random_floor("w", "m", 0.1, 3, 0, 5);
  m.motion = WallMotion::rotation;
  m.axis = {1, 2, 2};
  m.centre = {0.3, 0, -0.1};
  m.rate = 7;
  World w = build_world(with_wall(m));
  const Vec3d axis = Vec3d{1, 2, 2} * (1.0 / 3), arm = -m.centre;
  while (w.time() < 1) {
    advance(w, 1);
    const double a = m.rate * w.time();
    const Vec3d turned =
        arm * std::cos(a) + cross(axis, arm) * std::sin(a) + axis * (dot(axis, arm) * (1 - std::cos(a)));
    expect_near(w.walls[0].position, m.centre + turned, 1);
    expect_near(w.walls[0].velocity, cross(axis * m.rate, turned), 7);
    expect_near(w.walls[0].spin, axis * m.rate, 7);
    const Vec3d x{0.02, -0.05, 0.01};
    const Vec3d expected = x * std::cos(a) + cross(axis, x) * std::sin(a) + axis * (dot(axis, x) * (1 - std::cos(a)));
    expect_near(rotate(w.walls[0].orientation, x), expected, 1);
  }
}

TEST(Walls, Oscillation) {
  WallSpec m = scenes::plane("w", "m", {0, 0, -1}, {0, 0, 1});
  m.motion = WallMotion::oscillation;
  m.amplitude = {0.01, 0, 0.02};
  m.frequency = 25;
  m.phase = 0.4;
  World w = build_world(with_wall(m));
  const double omega = 2 * M_PI * m.frequency;
  while (w.time() < 0.5) {
    advance(w, 1);
    const double a = omega * w.time() + m.phase;
    expect_near(w.walls[0].position, m.point + m.amplitude * std::sin(a), 1);
    const double middle = a - 0.5 * omega * w.time_step.dt;  // of the step, where contacts see the bodies' velocities
    expect_near(w.walls[0].velocity, m.amplitude * (omega * std::cos(middle)), omega);
  }
}

// A belt drags a sphere along until it moves with it; a turntable carries one round.
TEST(Walls, AMovingWallDragsBodies) {
  WallSpec belt = scenes::plane("belt", "m", {0, 0, 0}, {0, 0, 1});
  belt.motion = WallMotion::translation;
  belt.velocity = {0.3, 0, 0};
  Scene s = with_wall(belt);
  s.gravity = {0, 0, -9.81};
  s.shapes.push_back(scenes::box("block", {0.02, 0.02, 0.01}));
  s.bodies = {scenes::body("block", "m", {0, 0, 0.005})};
  World w = build_world(s);
  while (w.time() < 0.03) advance(w, 1);
  EXPECT_NEAR(w.particles.motion[0].velocity.x / (0.5 * 9.81 * w.time()), 1, 0.1);  // sliding: μ g t
  while (w.time() < 0.4) advance(w, 1);
  EXPECT_NEAR(w.particles.motion[0].velocity.x / 0.3, 1, 1e-6);
}

// Γ = amplitude ω²/g below 1: the sphere never leaves the plate; above: it flies.
TEST(Walls, AVibratingPlateThrowsOnlyAboveGravity) {
  for (const double gamma : {0.9, 1.3}) {
    WallSpec plate = scenes::plane("plate", "m", {0, 0, 0}, {0, 0, 1});
    plate.motion = WallMotion::oscillation;
    plate.frequency = 20;
    const double omega = 2 * M_PI * plate.frequency;
    plate.amplitude = {0, 0, gamma * 9.81 / (omega * omega)};
    Scene s = with_wall(plate);
    s.run.dt = 2e-5;
    s.gravity = {0, 0, -9.81};
    // The plate starts with the upward speed A ω: so does the sphere, at its depth of rest.
    const double weight = 2500 * 4.0 / 3.0 * M_PI * 1e-6 * 9.81,
                 stiff = 4.0 / 3.0 * (0.5 * 5e6 / 0.91) * std::sqrt(0.01);
    s.bodies = {scenes::body("ball", "m", {0, 0, 0.01 - std::pow(weight / stiff, 2.0 / 3.0)},
                             {0, 0, plate.amplitude.z * omega})};
    World w = build_world(s);
    int flying = 0;
    while (w.time() < 0.5) {
      advance(w, 1);
      flying += touching_contacts(w).empty() ? 1 : 0;
    }
    EXPECT_EQ(flying > 0, gamma > 1) << gamma;
  }
}

// A body that rides on a vibrating plate is pressed in by m (g + a) / k, whatever its dashpot: the plate's velocity is
// that of the same instant as the body's. At the lowest point, where the acceleration does not change.
TEST(Walls, ABodyRidesOnAVibratingPlate) {
  WallSpec plate = scenes::plane("plate", "m", {0, 0, 0}, {0, 0, 1});
  plate.motion = WallMotion::oscillation;
  plate.frequency = 20;
  plate.phase = -0.5 * M_PI;
  const double omega = 2 * M_PI * plate.frequency, strength = 0.5;
  plate.amplitude = {0, 0, strength * 9.81 / (omega * omega)};
  Scene s = with_wall(plate);
  s.law.name = LawName::spring_dashpot;
  s.materials[0].stiffness = 1e6;
  s.materials[0].restitution = 0.1;
  s.run.dt = 5e-6;
  s.gravity = {0, 0, -9.81};
  s.bodies = {scenes::body("ball", "m", {0, 0, 0.01 - plate.amplitude.z})};
  World w = build_world(s);
  while (w.step < 20000) advance(w, 1);  // two periods
  const auto contacts = touching_contacts(w);
  ASSERT_EQ(contacts.size(), 1u);
  EXPECT_NEAR(contacts[0].overlap * 1e6 / (w.particles.mass[0] * 9.81 * (1 + strength)), 1, 3e-3);
}

TEST(Walls, AGateIsRemovedAtItsTime) {
  WallSpec gate = scenes::plane("gate", "m", {0, 0, 0}, {0, 0, 1});
  gate.remove_at = 0.2;
  Scene s = with_wall(gate);
  s.gravity = {0, 0, -9.81};
  s.bodies = {scenes::body("ball", "m", {0, 0, 0.00999})};
  World w = build_world(s);
  while (w.time() < 0.1995) advance(w, 1);
  EXPECT_EQ(touching_contacts(w).size(), 1u);
  const double height = w.particles.motion[0].position.z;
  while (w.time() < 0.3) advance(w, 1);
  EXPECT_FALSE(w.walls[0].present);
  EXPECT_TRUE(touching_contacts(w).empty());
  EXPECT_NEAR((height - w.particles.motion[0].position.z) / (0.5 * 9.81 * 0.1 * 0.1), 1, 5e-3);
}

}  // namespace
}  // namespace dem
