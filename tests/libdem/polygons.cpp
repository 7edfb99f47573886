// Polygons in scenes of the plane: mass of prisms, flat faces at rest, the plane kept, the same bits for threads, skins
// and units.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/libdem/scenes_in_code.h"

namespace dem {
namespace {

ShapeSpec polygon(const std::string& name, const std::vector<Vec3d>& corners) {
  ShapeSpec s;
  s.name = name;
  s.kind = "polygon";
  s.vertices = corners;
  return s;
}

ShapeSpec regular(const std::string& name, int sides, double circumradius) {
  ShapeSpec s;
  s.name = name;
  s.kind = "regular_polygon";
  s.sides = sides;
  s.circumradius = circumradius;
  return s;
}

WallSpec line(const std::string& name, const Vec3d& point, const Vec3d& normal) {
  WallSpec w = scenes::plane(name, "soft", point, normal);
  w.kind = "line";
  return w;
}

Scene plane_scene(double restitution = 0.4, double friction = 0.4) {
  Scene s;
  s.dimension = 2;
  s.thickness = 0.01;
  s.law.name = LawName::spring_dashpot;
  s.gravity = {0, -9.81, 0};
  s.run.steps = 1000;
  MaterialSpec m = scenes::material("soft", 0, 2500, restitution, friction);
  m.stiffness = 2e4;
  s.materials = {m};
  return s;
}

// Discs, ellipses and polygons that fall and roll together in a tray.
Scene tray() {
  Scene s = plane_scene();
  s.gravity = {60, -250, 0};
  s.run.dt_fraction = 0.3;
  ShapeSpec disc = scenes::sphere("disc", 0.005), ellipse;
  disc.kind = "disc";
  ellipse.name = "egg";
  ellipse.kind = "ellipse";
  ellipse.semi_axis_a = 0.004;
  ellipse.semi_axis_b = 0.007;
  s.shapes = {disc, ellipse, regular("five", 5, 0.006),
              polygon("brick", {{0, 0, 0}, {0.014, 0, 0}, {0.014, 0.006, 0}, {0, 0.006, 0}}),
              polygon("wedge", {{1, 1, 0}, {1.015, 1.002, 0}, {1.003, 1.01, 0}})};
  s.walls = {line("floor", {0, 0, 0}, {0, 1, 0}), line("left", {-0.06, 0, 0}, {1, 0.1, 0}),
             line("right", {0.06, 0, 0}, {-1, 0.3, 0})};
  FillSpec fill;
  fill.lower = {-0.05, 0.001, 0};
  fill.upper = {0.05, 0.1, 0};
  fill.count = 40;
  fill.velocity = {1, -4, 0};
  for (const ShapeSpec& shape : s.shapes) fill.items.push_back({shape.name, "soft", 1, 0.6, 0.8});
  s.fills = {fill};
  return s;
}

TEST(Polygons, HaveTheMassOfPrismsAboutTheirCentroid) {
  Scene s = plane_scene();
  s.shapes = {polygon("brick", {{3, 1, 0}, {3.02, 1, 0}, {3.02, 1.01, 0}, {3, 1.01, 0}}), regular("hexagon", 6, 0.01)};
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
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(contacts[k].overlap, carried[k] / 5e3, 1e-6 * carried[k] / 5e3) << k;
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
  const Scene s = tray();
  Scene t = s;
  const double length = 0x1p10, mass = 0x1p6, time = 0x1p3;
  t.thickness *= length;
  t.gravity = t.gravity * (length / (time * time));
  t.materials[0].density *= mass / (length * length * length);
  t.materials[0].stiffness *= mass / (time * time);
  for (ShapeSpec& shape : t.shapes) {
    for (double* x : {&shape.radius, &shape.semi_axis_a, &shape.semi_axis_b, &shape.circumradius}) *x *= length;
    for (Vec3d& v : shape.vertices) v *= length;
  }
  for (WallSpec& w : t.walls) w.point = w.point * length;
  t.fills[0].lower *= length;
  t.fills[0].upper *= length;
  t.fills[0].velocity *= length / time;
  const World a = scenes::run(s, 1000), b = scenes::run(t, 1000);
  EXPECT_GT(a.counters.contact_steps, 10000u);
  EXPECT_EQ(a.counters.contact_steps, b.counters.contact_steps);
  for (std::uint64_t id = 0; id < a.particles.count(); ++id) {
    const Motion &x = scenes::motion(a, id), &y = scenes::motion(b, id);
    EXPECT_TRUE(x.position * length == y.position) << id;
    EXPECT_EQ(x.spin.z / time, y.spin.z) << id;
  }
}

}  // namespace
}  // namespace dem
