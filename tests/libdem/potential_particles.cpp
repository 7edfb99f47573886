// Potential particles in scenes: mass, rest on a plane, the same bits, units, clumps beside them, pairs without a
// method.
#include <gtest/gtest.h>

#include <numbers>

#include "libdem/build.h"
#include "shapes/potential_particle.h"
#include "tests/libdem/scenes_in_code.h"

namespace dem {
namespace {

using HalfSpaces = std::vector<std::array<double, 4>>;

HalfSpaces box_planes(const Vec3d& half) {
  return {{1, 0, 0, half.x},  {-1, 0, 0, half.x}, {0, 1, 0, half.y},
          {0, -1, 0, half.y}, {0, 0, 1, half.z},  {0, 0, -1, half.z}};
}

using scenes::potential;

ShapeSpec brick() { return potential("brick", box_planes({0.003, 0.004, 0.005}), 0.3, 0.002, 0.005); }
ShapeSpec lump() {
  return potential("lump", {{1, 1, 1, 0.005}, {1, -1, -1, 0.006}, {-1, 1, -1, 0.005}, {-1, -1, 1, 0.006}}, 0.4, 0.002,
                   0.005);
}

// Spheres, ellipsoids and potential particles that fall into a tray of planes and a mesh.
Scene tray(std::uint64_t count) {
  Scene s = scenes::every_shape(count);
  s.shapes.erase(s.shapes.begin() + 2, s.shapes.end());
  s.shapes.push_back(brick());
  s.shapes.push_back(lump());
  s.fills[0].items = {{"ball", "soft", 1, 0.7, 1.0},
                      {"egg", "hard", 1, 0.7, 1.0},
                      {"brick", "soft", 2, 0.8, 1.0},
                      {"lump", "hard", 2, 0.8, 1.0}};
  return s;
}

TEST(PotentialParticles, MassIsThatOfTheShape) {
  ShapeSpec s = potential("ball", box_planes({0.01, 0.01, 0.01}), 1, 0.001, 0.003);
  const ShapeEntry ball = make_shapes(s, {}).front();
  EXPECT_EQ(ball.kind, shapes::Kind::potential_particle);
  EXPECT_NEAR(ball.volume / (4 * std::numbers::pi / 3 * 2.7e-8), 1, 1e-12);
  EXPECT_NEAR(ball.equivalent_radius, 0.003, 1e-14);
  ASSERT_TRUE(ball.drawn());
  EXPECT_GT(ball.drawn()->mass.volume, 0.95 * ball.volume);
  s = brick();
  s.diameter = 0.008;
  const ShapeEntry sized = make_shapes(s, {}).front();
  EXPECT_NEAR(2 * sized.equivalent_radius / s.diameter, 1, 1e-12);
  EXPECT_LT(sized.inertia.z, sized.inertia.x);  // longest along z
}

// Dropped flat: at rest on the face, sunk by what the law asks for, F = m g.
TEST(PotentialParticles, ComeToRestOnAPlane) {
  Scene s;
  s.gravity = {0, 0, -9.81};
  s.materials = {scenes::material("soft", 5e6, 2500, 0.3, 0.5)};
  s.shapes = {brick()};
  s.walls = {scenes::plane("floor", "soft", {0, 0, 0}, {0, 0, 1})};
  s.run.time = 1;
  s.run.dt_fraction = 0.2;
  s.bodies = {scenes::body("brick", "soft", {0, 0, 0.0055}, {}, {}, scenes::turn({0, 1, 0}, 0.5 * std::numbers::pi))};
  World w = build_world(s);
  const double height = w.shapes[0].potential->inscribed_radius;  // of the centre over its broadest face
  const std::uint64_t steps = total_steps(w);
  for (std::uint64_t i = 0; i < steps; ++i) advance(w, 1);
  const Motion& m = w.particles.motion[0];
  const double force = w.particles.mass[0] * 9.81;
  const double depth = std::pow(3 * force / (4 * w.pairs[0].young_eff * std::sqrt(m.equivalent_radius)), 2.0 / 3);
  EXPECT_LT(norm(m.velocity), 1e-4);
  EXPECT_NEAR(m.position.z, height - depth, 1e-6);
}

TEST(PotentialParticles, SameBitsForThreadsSkinRebuildAndResume) {
  Scene s = tray(70);
  const World one = scenes::run(s, 300, 1);
  EXPECT_GT(contacts_per_particle(one), 0.2);
  EXPECT_EQ(one.counters.not_converged, 0u);
  const std::uint64_t hash = state_hash(one);
  World resumed = build_world(s);
  load_state(resumed, save_state(scenes::run(s, 150, 1)));
  for (int i = 0; i < 150; ++i) advance(resumed, 1);
  EXPECT_EQ(state_hash(resumed), hash);
  s.run.skin = 0.0004;
  EXPECT_EQ(state_hash(scenes::run(s, 300, 4)), hash);
  s.run.rebuild_every = 1;
  EXPECT_EQ(state_hash(scenes::run(s, 300, 2)), hash);
}

// Lengths × 2^7, times × 2^3, masses × 2^5: the same bits, scaled.
TEST(PotentialParticles, SameBitsInOtherUnits) {
  const double length = 128, time = 8, mass = 32;
  Scene s;
  s.gravity = {0, 1, -16};
  s.materials = {scenes::material("soft", 5e6, 2500, 0.5, 0.4)};
  s.shapes = {brick(), lump()};
  s.walls = {scenes::plane("floor", "soft", {0, 0, 0}, {0, 0, 1})};
  s.run.steps = 2500;
  for (int i = 0; i < 6; ++i)
    s.bodies.push_back(scenes::body(i % 2 ? "brick" : "lump", "soft", {0.001 * i, 0, 0.01 + 0.02 * i}, {0, 0, -1},
                                    {1, 2, 3}, scenes::turn({0.6, 0, 0.8}, i)));
  const World before = scenes::run(s, 2500);
  for (auto& b : s.bodies) b.position *= length, b.velocity *= length / time, b.spin *= 1 / time;
  for (auto& shape : s.shapes) {
    shape.r *= length;
    shape.R *= length;
    for (auto& plane : shape.half_spaces) plane[3] *= length;
  }
  s.materials[0].young *= mass / (length * time * time);
  s.materials[0].density *= mass / (length * length * length);
  s.gravity *= length / (time * time);
  const World after = scenes::run(s, 2500);
  EXPECT_GT(before.counters.contact_steps, 300u);
  for (std::uint64_t id = 0; id < 6; ++id) {
    EXPECT_EQ(scenes::motion(after, id).position, scenes::motion(before, id).position * length) << id;
    EXPECT_EQ(scenes::motion(after, id).velocity, scenes::motion(before, id).velocity * (length / time)) << id;
  }
}

// Without friction and damping an oblique impact keeps energy.
TEST(PotentialParticles, AnImpactKeepsItsEnergy) {
  Scene s;
  s.materials = {scenes::material("soft", 5e6, 2500, 1, 0)};
  s.shapes = {brick(), lump()};
  s.run.steps = 9000;
  s.run.dt_fraction = 0.02;
  s.bodies = {scenes::body("brick", "soft", {0, 0, 0}, {}, {20, 0, 5}, scenes::turn({0, 0.6, 0.8}, 1)),
              scenes::body("lump", "soft", {0.02, 0.002, 0.001}, {-1, 0, 0}, {0, 0, 9}, scenes::turn({1, 0, 0}, 2))};
  const World start = build_world(s);
  const World end = scenes::run(s, 9000);
  const auto total = [](const World& w) {
    const Energies e = energies(w);
    return e.translational + e.rotational + e.elastic;
  };
  EXPECT_GT(end.counters.contact_steps, 20u);
  EXPECT_LT(scenes::motion(end, 0).velocity.x, 0);
  // The law's stiffness is that of the equivalent spheres, at any point: the force has a potential.
  EXPECT_NEAR(total(end) / total(start), 1, 1e-3);
}

TEST(PotentialParticles, ClumpsOfSpheresMeetThem) {
  Scene s;
  s.gravity = {0, 0, -50};
  s.materials = {scenes::material("soft", 5e6, 2500, 0.5, 0.4)};
  s.shapes = {brick(), scenes::clump("pair", {{-0.003, 0, 0, 0.004}, {0.003, 0, 0, 0.004}})};
  s.walls = {scenes::plane("floor", "soft", {0, 0, 0}, {0, 0, 1})};
  s.bodies = {scenes::body("brick", "soft", {0, 0, 0.0075}), scenes::body("pair", "soft", {0.001, 0.001, 0.018})};
  const World w = scenes::run(s, 400);
  EXPECT_GT(w.counters.contact_steps, 20u);
  EXPECT_EQ(w.counters.not_converged, 0u);
}

// Bricks set down on a box and on a rounded one: each bears the weight above it.
TEST(PotentialParticles, RestOnBodiesWithFlatFaces) {
  Scene s = tray(0);
  s.gravity = {0, 0, -10};
  s.shapes = {brick(), scenes::box("box", {0.02, 0.02, 0.01}), scenes::box("stone", {0.02, 0.02, 0.01})};
  s.shapes[2].rounding = 0.002;
  s.walls = {scenes::plane("floor", "soft", {0, 0, 0}, {0, 0, 1})};
  s.fills.clear();
  const ShapeEntry top = make_shapes(brick(), s).front();
  const double height = 0.01 + top.potential->inscribed_radius + 1e-4;
  const Quatd flat = scenes::turn({0, 1, 0}, 0.5 * std::numbers::pi);
  s.bodies = {scenes::body("box", "soft", {0, 0, 0.005}), scenes::body("stone", "soft", {0.05, 0, 0.007}),
              scenes::body("brick", "soft", {0.001, 0.002, height}, {}, {}, flat),
              scenes::body("brick", "soft", {0.051, 0.002, height + 0.004}, {}, {}, flat)};
  const World w = scenes::run(s, 60000);
  EXPECT_EQ(w.counters.not_converged, 0u);
  EXPECT_EQ(w.counters.uncertified, 0u);
  int met = 0;
  for (const ContactReport& c : touching_contacts(w)) {
    if (c.wall) continue;
    ++met;
    const double up = c.normal.z;  // of a, the lower one, or of b
    EXPECT_NEAR(std::abs(up), 1, 1e-6);
    const std::vector<std::uint32_t> order = order_by_id(w);
    EXPECT_NEAR(std::abs(c.force.z), 10 * w.particles.mass[order[2]], 1e-3 * std::abs(c.force.z));
  }
  EXPECT_EQ(met, 2);
}

TEST(PotentialParticles, AMethodThatAnswersNoPairIsRefused) {
  Scene s;
  s.method = "perram_wertheim";
  s.materials = {scenes::material("soft", 5e6, 2500, 0.5, 0.4)};
  s.shapes = {brick(), scenes::box("box", {0.01, 0.01, 0.01})};
  s.bodies = {scenes::body("brick", "soft", {0, 0, 0.1}), scenes::body("box", "soft", {0, 0, 0.2})};
  try {
    build_world(s);
    FAIL() << "no refusal";
  } catch (const InputError& error) {
    for (const char* part : {"perram_wertheim", "does not answer the pair", "polyhedron–potential_particle"})
      EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace dem
