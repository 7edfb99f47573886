// Walls that are convex polygons of the plane: they bear what lines bear, at faces and corners, at rest and in motion,
// and the bits depend on nothing but the scene.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/libdem/same_bits.h"

namespace dem {
namespace {

WallSpec block(const std::string& name, const Vec3d& lower, const Vec3d& upper) {
  WallSpec w;
  w.name = name;
  w.kind = "polygon";
  w.material = "soft";
  w.vertices = {lower, {upper.x, lower.y, 0}, upper, {lower.x, upper.y, 0}};
  return w;
}

// Discs, ellipses and bricks (or arches, which are not convex) in a trough of three blocks, one of which turns and one
// comes nearer.
Scene trough(const char* third = "brick") {
  Scene s;
  s.dimension = 2;
  s.thickness = 0.01;
  s.law.name = LawName::spring_dashpot;
  s.gravity = {0, -10, 0};
  s.run.steps = 3000;
  s.materials = {scenes::material("soft", 0, 2500, 0.4, 0.4)};
  s.materials[0].stiffness = 2e4;
  ShapeSpec disc = scenes::sphere("disc", 0.004), ellipse, brick;
  disc.kind = "disc";
  ellipse.name = "egg";
  ellipse.kind = "ellipse";
  ellipse.semi_axis_a = 0.005;
  ellipse.semi_axis_b = 0.0035;
  brick.name = "brick";
  brick.kind = "polygon";
  brick.vertices = {{0, 0, 0}, {0.009, 0, 0}, {0.009, 0.006, 0}, {0, 0.006, 0}};
  ShapeSpec arch = brick;
  arch.name = "arch";
  arch.vertices = {{0, 0, 0},     {0.002, 0, 0}, {0.002, 0.003, 0}, {0.006, 0.003, 0},
                   {0.006, 0, 0}, {0.008, 0, 0}, {0.008, 0.005, 0}, {0, 0.005, 0}};
  s.shapes = {disc, ellipse, brick, arch};
  s.walls = {block("floor", {-0.05, -0.02, 0}, {0.05, 0, 0}), block("west", {-0.05, 0, 0}, {-0.03, 0.1, 0}),
             block("east", {0.035, 0.0, 0}, {0.05, 0.1, 0}), block("paddle", {-0.01, 0.012, 0}, {0.01, 0.018, 0})};
  s.walls[2].motion = WallMotion::translation;
  s.walls[2].velocity = {-0.05, 0, 0};
  s.walls[3].motion = WallMotion::rotation;
  s.walls[3].axis = {0, 0, 1};
  s.walls[3].centre = {0, 0.015, 0};
  s.walls[3].rate = 8;
  const char* const names[] = {"disc", "egg", third};
  for (int i = 0; i < 15; ++i) {
    const int row = i / 5;
    s.bodies.push_back(scenes::body(names[i % 3], "soft", {-0.024 + 0.012 * (i % 5), 0.036 + 0.013 * row, 0},
                                    {0.1 * (i % 3) - 0.1, -2, 0}, {0, 0, 5.0 * (i % 2)}));
  }
  return s;
}

TEST(PolygonWalls, CarryTheWeight) {
  Scene s = trough();
  s.walls.resize(3);
  s.walls[2].motion = WallMotion::fixed;
  const World w = scenes::run(s, 120000);
  double weight = 0;
  for (const double m : w.particles.mass) weight += 10 * m;
  EXPECT_NEAR(-w.walls[0].force.y - w.walls[1].force.y - w.walls[2].force.y, weight, 0.02 * weight);
  for (const Motion& m : w.particles.motion) {
    EXPECT_GT(m.position.y, 0.0029);
    EXPECT_GT(m.position.x, -0.03 + 0.0029);
    EXPECT_LT(m.position.x, 0.035 - 0.0029);
  }
}

// A body that falls on a face feels a line: the same motion to round-off, until it has bounced and turned.
TEST(PolygonWalls, AFaceIsALine) {
  for (const char* const shape : {"disc", "egg", "brick", "arch"}) {
    Scene s = trough();
    s.walls.resize(1);
    s.bodies = {
        scenes::body(shape, "soft", {0.004, 0.009, 0}, {0.3, -0.4, 0}, {0, 0, 9}, scenes::turn({0, 0, 1}, 0.3))};
    const World face = scenes::run(s, 4000);
    s.walls[0] = scenes::plane("floor", "soft", {0, 0, 0}, {0, 1, 0});
    s.walls[0].kind = "line";
    const World line = scenes::run(s, 4000);
    EXPECT_GT(face.counters.contact_steps, 20u) << shape;
    EXPECT_EQ(face.counters.contact_steps, line.counters.contact_steps) << shape;
    EXPECT_EQ(face.time_step.dt, line.time_step.dt);
    const Motion &a = face.particles.motion[0], &b = line.particles.motion[0];
    EXPECT_LT(norm(a.position - b.position), 1e-9 * 0.01) << shape;
    EXPECT_LT(norm(a.velocity - b.velocity), 1e-9) << shape;
    EXPECT_LT(norm(a.spin - b.spin), 1e-7) << shape;
  }
}

// A disc above a corner: the normal points from the corner to its centre.
TEST(PolygonWalls, CornersAreMet) {
  Scene s = trough();
  s.walls.resize(1);
  s.bodies = {scenes::body("disc", "soft", {0.05 + 0.0024, 0.0032 - 1e-5, 0})};
  s.run.max_initial_overlap = 0.1;
  const World w = build_world(s);
  const auto contacts = touching_contacts(w);
  ASSERT_EQ(contacts.size(), 1u);
  EXPECT_TRUE(contacts[0].wall);
  const Vec3d to_corner = normalized(Vec3d{-0.0024, -(0.0032 - 1e-5), 0});
  EXPECT_LT(norm(contacts[0].normal - to_corner), 1e-9);
  EXPECT_NEAR(contacts[0].overlap, 0.004 - norm(Vec3d{0.0024, 0.0032 - 1e-5, 0}), 1e-12);
}

TEST(PolygonWalls, SameBitsForThreadsSkinsRebuildsAndAResume) {
  EXPECT_NE(scenes::expect_same_bits(trough(), 6000).walls[3].load.impulse[0].value(), 0);
}

TEST(PolygonWalls, SameBitsWithBodiesThatAreNotConvex) { scenes::expect_same_bits(trough("arch"), 6000); }

TEST(PolygonWalls, UnitsScaleBitForBit) {
  const Scene s = trough();
  const World w = scenes::run(s, 6000);
  const double u = 0x1p10;  // all lengths, and gravity, speeds with them: time and mass as they are, density as u^-3
  Scene t = s;
  t.gravity = t.gravity * u;
  t.thickness *= u;
  t.materials[0].density *= 1 / (u * u * u);
  for (ShapeSpec& x : t.shapes) {
    x.radius *= u;
    x.semi_axis_a *= u;
    x.semi_axis_b *= u;
    for (Vec3d& v : x.vertices) v *= u;
  }
  for (WallSpec& x : t.walls) {
    for (Vec3d& v : x.vertices) v *= u;
    x.velocity *= u;
    x.centre *= u;
  }
  for (BodySpec& b : t.bodies) {
    b.position *= u;
    b.velocity *= u;
  }
  const World scaled = scenes::run(t, 6000);
  EXPECT_GT(w.counters.contact_steps, 2000u);
  EXPECT_EQ(scaled.time_step.dt, w.time_step.dt);
  EXPECT_EQ(scaled.counters.contact_steps, w.counters.contact_steps);
  for (std::size_t i = 0; i < w.particles.count(); ++i) {
    EXPECT_EQ(scaled.particles.motion[i].position, w.particles.motion[i].position * u);
    EXPECT_EQ(scaled.particles.motion[i].spin, w.particles.motion[i].spin);
  }
}

}  // namespace
}  // namespace dem
