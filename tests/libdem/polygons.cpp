// Polygons in scenes of the plane: mass of prisms, flat faces at rest, the plane kept, the same bits for threads, skins
// and units.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/libdem/scenes_planar.h"

namespace dem {
namespace {

using scenes::line;
using scenes::plane_scene;
using scenes::polygon;

Scene tray() {
  return scenes::planar_tray(
      {scenes::disc("disc", 0.005), scenes::ellipse("egg", 0.004, 0.007), scenes::regular_polygon("five", 5, 0.006),
       polygon("brick", {{0, 0, 0}, {0.014, 0, 0}, {0.014, 0.006, 0}, {0, 0.006, 0}}),
       polygon("wedge", {{1, 1, 0}, {1.015, 1.002, 0}, {1.003, 1.01, 0}})},
      40);
}

TEST(Polygons, HaveTheMassOfPrismsAboutTheirCentroid) {
  Scene s = plane_scene();
  s.shapes = {polygon("brick", {{3, 1, 0}, {3.02, 1, 0}, {3.02, 1.01, 0}, {3, 1.01, 0}}),
              scenes::regular_polygon("hexagon", 6, 0.01)};
  s.bodies = {scenes::body("brick", "soft", {0, 1, 0}), scenes::body("hexagon", "soft", {1, 1, 0})};
  s.bodies[1].scale = 2;
  const World w = build_world(s);
  const double brick = 2500 * 0.01 * 0.02 * 0.01, side = 0.02, area = 1.5 * std::sqrt(3.0) * side * side;
  const double hexagon = 2500 * 0.01 * area;
  const std::size_t b = scenes::place(w, 0), h = scenes::place(w, 1);
  EXPECT_NEAR(w.particles.mass[b], brick, 1e-12 * brick);
  EXPECT_NEAR(w.particles.inertia[b].z, brick * (0.02 * 0.02 + 0.01 * 0.01) / 12, 1e-10 * brick * 1e-4);
  EXPECT_NEAR(w.particles.mass[h], hexagon, 1e-13 * hexagon);
  EXPECT_NEAR(w.particles.inertia[h].z, hexagon * side * side * 5 / 12, 1e-13 * hexagon * side * side);
  EXPECT_NEAR(w.particles.motion[h].equivalent_radius, std::sqrt(area / 3.14159265358979324), 1e-15);
}

// Squares on a floor, not quite in line: they come to rest flat, at the overlap that the weight above asks for.
TEST(Polygons, AStackOfSquaresComesToRest) {
  Scene s = plane_scene(0.1, 0.5);
  s.materials[0].stiffness = 5e3;
  const double side = 0.01;
  s.shapes = {polygon("square", {{0, 0, 0}, {side, 0, 0}, {side, side, 0}, {0, side, 0}})};
  s.walls = {line("floor", {0, 0, 0}, {0, 1, 0})};
  for (int i = 0; i < 3; ++i)
    s.bodies.push_back(scenes::body("square", "soft", {0.0002 * (i % 2), side * (0.5 + 1.001 * i) + 1e-5, 0}));
  World w = build_world(s);
  const double weight = w.particles.mass[0] * 9.81;
  while (w.time() < 1.5) advance(w, 1);
  for (int i = 0; i < 3; ++i) {
    const Motion& m = scenes::motion(w, static_cast<std::uint64_t>(i));
    EXPECT_LE(norm(m.velocity), 1e-8) << i;
    EXPECT_LE(std::abs(m.spin.z), 1e-6) << i;
    EXPECT_LE(std::abs(m.position.x - 0.0002 * (i % 2)), 1e-5) << i;
    EXPECT_LE(std::abs(w.particles.rotation[scenes::place(w, static_cast<std::uint64_t>(i))].z), 2e-4) << i;
  }
  const auto contacts = touching_contacts(w);  // 0 on 1, 0 on the floor, 1 on 2
  ASSERT_EQ(contacts.size(), 3u);
  const double carried[] = {2 * weight, 3 * weight, weight};
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_NEAR(norm(contacts[k].force), carried[k], 1e-6 * carried[k]) << k;
    // They rest out of line, and lean: the ends of the faces are as far above and below their middle.
    const bool floor = contacts[k].wall;
    const auto lean = [&](std::uint64_t id) { return w.particles.rotation[scenes::place(w, id)].z; };
    const double turn = lean(contacts[k].a) - (floor ? 0 : lean(contacts[k].b)), length = floor ? side : side - 0.0002;
    EXPECT_NEAR(contacts[k].overlap, std::hypot(carried[k] / 5e3, 0.5 * length * turn), 1e-5 * carried[k] / 5e3) << k;
  }
  EXPECT_NEAR(-w.walls[0].force.y, 3 * weight, 1e-6 * weight);
}

TEST(Polygons, NothingLeavesThePlane) {
  Scene s = tray();
  const World w = scenes::run(s, 3000);
  EXPECT_GT(w.counters.contact_steps, 50000u);
  EXPECT_EQ(w.counters.not_converged, 0u);
  for (std::size_t i = 0; i < w.particles.count(); ++i) {
    const Motion& m = w.particles.motion[i];
    EXPECT_TRUE(m.position.z == 0 && m.velocity.z == 0 && m.spin.x == 0 && m.spin.y == 0) << i;
    EXPECT_TRUE(w.particles.orientation[i].x == 0 && w.particles.orientation[i].y == 0) << i;
  }
}

TEST(Polygons, SameBitsForThreadsSkinsAndResume) {
  Scene s = tray();
  const std::uint64_t hash = state_hash(scenes::run(s, 1200));
  EXPECT_EQ(state_hash(scenes::run(s, 1200, 3)), hash);
  World first = scenes::run(s, 500);
  World second = build_world(s);
  load_state(second, save_state(first));
  while (second.step < 1200) advance(second, 1);
  EXPECT_EQ(state_hash(second), hash);
  s.run.skin = 0.003;
  EXPECT_EQ(state_hash(scenes::run(s, 1200)), hash);
  s.run.rebuild_every = 1;
  EXPECT_EQ(state_hash(scenes::run(s, 1200)), hash);
}

// Lengths times 2^10, masses times 2^6, times times 2^3: every number scales exactly.
TEST(Polygons, UnitsScaleBitForBit) {
  const Scene s = tray(), t = scenes::planar_restated(s, 10, 6, 3);
  const World a = scenes::run(s, 1000), b = scenes::run(t, 1000);
  EXPECT_GT(a.counters.contact_steps, 10000u);
  EXPECT_EQ(a.counters.contact_steps, b.counters.contact_steps);
  for (std::uint64_t id = 0; id < a.particles.count(); ++id) {
    const Motion &x = scenes::motion(a, id), &y = scenes::motion(b, id);
    EXPECT_TRUE(x.position * 0x1p10 == y.position) << id;
    EXPECT_EQ(x.spin.z / 0x1p3, y.spin.z) << id;
  }
}

}  // namespace
}  // namespace dem
