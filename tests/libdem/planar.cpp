// Scenes of the plane: nothing leaves it, spheres that move in a plane are spheres, prisms have the mass of prisms.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/libdem/scenes_in_code.h"

namespace dem {
namespace {

Scene bed(DiscModel model, int dimension) {
  Scene s;
  s.dimension = dimension;
  s.disc_model = model;
  s.thickness = model == DiscModel::prism ? 0.01 : 0;
  s.law.name = model == DiscModel::prism ? LawName::spring_dashpot : LawName::hertz_mindlin;
  s.gravity = {0, -9.81, 0};
  s.run.steps = 2000;
  MaterialSpec m = scenes::material("soft", 5e6, 2500, 0.5, 0.4);
  m.stiffness = 2e4;
  s.materials = {m};
  ShapeSpec ball = scenes::sphere("ball", 0.005);
  if (dimension == 2) ball.kind = "disc";
  s.shapes = {ball};
  for (const auto& [name, point, normal] :
       {std::tuple{"floor", Vec3d{0, 0, 0}, Vec3d{0, 1, 0}}, std::tuple{"left", Vec3d{-0.03, 0, 0}, Vec3d{1, 0, 0}},
        std::tuple{"slope", Vec3d{0.03, 0, 0}, Vec3d{-1, 0.5, 0}}}) {
    WallSpec w = scenes::plane(name, "soft", point, normal);
    if (dimension == 2) w.kind = "line";
    s.walls.push_back(w);
  }
  for (int i = 0; i < 12; ++i)
    s.bodies.push_back(scenes::body("ball", "soft",
                                    {-0.02 + 0.0125 * (i % 4), 0.006 + 0.0115 * (i / 4) + 0.0005 * i, 0},
                                    {0.02 * (i % 3) - 0.01, 0, 0}, {0, 0, 3.0 * (i % 2)}));
  return s;
}

World after(const Scene& scene, int steps, int threads = 1) {
  World w = build_world(scene);
  for (int i = 0; i < steps; ++i) advance(w, threads);
  return w;
}

TEST(Planar, NothingLeavesThePlane) {
  const World w = after(bed(DiscModel::prism, 2), 20000);
  EXPECT_GT(w.counters.contact_steps, 5000u);
  int turned = 0;
  for (std::size_t i = 0; i < w.particles.count(); ++i) {
    const Motion& m = w.particles.motion[i];
    EXPECT_EQ(m.position.z, 0);
    EXPECT_EQ(m.velocity.z, 0);
    EXPECT_EQ(m.spin.x, 0);
    EXPECT_EQ(m.spin.y, 0);
    turned += w.particles.rotation[i].z != 0 ? 1 : 0;
    EXPECT_EQ(w.particles.orientation[i].x, 0);
    EXPECT_EQ(w.particles.orientation[i].y, 0);
  }
  EXPECT_GE(turned, 6);
}

// Spheres in a plane, said in two ways: walls differ in how their frames are turned, so the last bits may.
TEST(Planar, SphereDiscsMoveAsSpheres) {
  const World flat = after(bed(DiscModel::sphere, 2), 2000), solid = after(bed(DiscModel::sphere, 3), 2000);
  ASSERT_EQ(flat.time_step.dt, solid.time_step.dt);
  for (const auto i : order_by_id(flat)) {
    const Motion &a = flat.particles.motion[i], &b = solid.particles.motion[order_by_id(solid)[flat.particles.id[i]]];
    EXPECT_EQ(flat.particles.mass[i], solid.particles.mass[i]);
    EXPECT_LE(norm(a.position - b.position), 1e-9 * 0.005) << i;
  }
}

TEST(Planar, PrismsHaveTheirMassAndInertia) {
  Scene s = bed(DiscModel::prism, 2);
  s.bodies.resize(1);
  s.bodies[0].position = {0, 0.05, 0};
  s.bodies[0].scale = 2;
  const World w = build_world(s);
  const std::uint32_t i = order_by_id(w)[0];
  const double m = 2500 * std::numbers::pi * 0.01 * 0.01 * 0.01;  // ρ π R² h
  EXPECT_NEAR(w.particles.mass[i], m, 1e-14 * m);
  EXPECT_NEAR(w.particles.inertia[i].z, 0.5 * m * 1e-4, 1e-14 * m * 1e-4);
}

TEST(Planar, SameBitsForThreadsAndSkins) {
  Scene s = bed(DiscModel::prism, 2);
  const std::uint64_t hash = state_hash(after(s, 1500));
  EXPECT_EQ(state_hash(after(s, 1500, 3)), hash);
  s.run.skin = 0.004;
  EXPECT_EQ(state_hash(after(s, 1500)), hash);
  s.run.rebuild_every = 1;
  EXPECT_EQ(state_hash(after(s, 1500)), hash);
}

// Lengths times 2^10, masses times 2^6, times times 2^3: every number scales exactly.
TEST(Planar, UnitsScaleBitForBit) {
  const Scene s = bed(DiscModel::prism, 2);
  Scene t = s;
  const double length = 0x1p10, mass = 0x1p6, time = 0x1p3;
  t.thickness *= length;
  t.gravity = t.gravity * (length / (time * time));
  t.materials[0].density *= mass / (length * length * length);
  t.materials[0].stiffness *= mass / (time * time);
  t.shapes[0].radius *= length;
  for (WallSpec& w : t.walls) w.point = w.point * length;
  for (BodySpec& b : t.bodies) {
    b.position = b.position * length;
    b.velocity = b.velocity * (length / time);
    b.spin = b.spin * (1 / time);
  }
  const World a = after(s, 1000), b = after(t, 1000);
  for (std::size_t i = 0; i < a.particles.count(); ++i) {
    EXPECT_EQ(a.particles.motion[i].position.x * length, b.particles.motion[i].position.x);
    EXPECT_EQ(a.particles.motion[i].position.y * length, b.particles.motion[i].position.y);
    EXPECT_EQ(a.particles.motion[i].spin.z / time, b.particles.motion[i].spin.z);
  }
}

}  // namespace
}  // namespace dem
