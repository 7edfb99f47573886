// Polyhedra with rounded edges in scenes: mass, rest on a plane, the same bits, units, and the limit of the step.
#include <gtest/gtest.h>

#include <numbers>

#include "libdem/build.h"
#include "shapes/polyhedron_build.h"
#include "shapes/rounded_polyhedron.h"
#include "tests/libdem/scenes_in_code.h"

namespace dem {
namespace {

ShapeSpec rounded(ShapeSpec s, double rounding) {
  s.rounding = rounding;
  return s;
}

// Bodies of each kind, rounded ones among them, that fall into a tray of planes and a mesh.
Scene tray(std::uint64_t count) {
  Scene s = scenes::every_shape(count);
  for (ShapeSpec& shape : s.shapes)
    if (shape.kind == "box" || shape.name == "grain") shape.rounding = 0.001;
  return s;
}

TEST(RoundedPolyhedra, VolumeByTheSteinerFormula) {
  const double a = 0.01, b = 0.02, c = 0.03, r = 0.002, pi = std::numbers::pi;
  const ShapeEntry e = make_shapes(rounded(scenes::box("b", {a, b, c}), r), {})[0];
  EXPECT_EQ(e.kind, shapes::Kind::rounded_polyhedron);
  const double volume = a * b * c + 2 * r * (a * b + b * c + c * a) + pi * r * r * (a + b + c) + 4 * pi / 3 * r * r * r;
  EXPECT_NEAR(e.volume / volume, 1, 1e-14);
  EXPECT_NEAR(e.circumradius / (0.5 * std::sqrt(a * a + b * b + c * c) + r), 1, 1e-14);
  EXPECT_NEAR(e.inscribed_radius / (0.5 * a + r), 1, 1e-14);
  ASSERT_TRUE(e.drawing);
  EXPECT_GT(e.drawn()->mass.volume, 0.95 * volume);
  EXPECT_LT(e.drawn()->mass.volume, volume);
}

TEST(RoundedPolyhedra, DiameterIsThatOfTheWhole) {
  ShapeSpec s = scenes::points("p", {{0, 0, 0}, {0.012, 0.001, 0}, {0.002, 0.013, 0.001}, {0.003, 0.004, 0.011}});
  s.diameter = 0.01;
  for (const double r : {1e-5, 0.001, 0.004, 0.00499}) {
    const ShapeEntry e = make_shapes(rounded(s, r), {})[0];
    EXPECT_NEAR(2 * e.equivalent_radius / s.diameter, 1, 1e-12) << r;
  }
  try {
    make_shapes(rounded(s, 0.005), {});
    FAIL() << "no refusal";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("rounding < diameter/2"), std::string::npos) << error.what();
  }
}

// A box dropped flat, and one on its edge: at rest on a face, sunk by what the law asks for, F = m g.
TEST(RoundedPolyhedra, BoxesComeToRestOnAPlane) {
  Scene s;
  s.gravity = {0, 0, -9.81};
  s.materials = {scenes::material("soft", 5e6, 2500, 0.3, 0.5)};
  s.shapes = {rounded(scenes::box("brick", {0.02, 0.016, 0.01}), 0.002)};
  s.walls = {scenes::plane("floor", "soft", {0, 0, 0}, {0, 0, 1})};
  s.run.time = 1;
  s.run.dt_fraction = 0.2;
  s.bodies = {scenes::body("brick", "soft", {0, 0, 0.009}),
              scenes::body("brick", "soft", {0.1, 0, 0.016}, {}, {}, scenes::turn({0, 1, 0}, 0.7))};
  World w = build_world(s);
  const std::uint64_t steps = total_steps(w);
  for (std::uint64_t i = 0; i < steps; ++i) advance(w, 1);
  const PairParameters& q = w.pairs[0];
  for (std::size_t i = 0; i < 2; ++i) {
    const Motion& m = w.particles.motion[i];
    EXPECT_LT(norm(m.velocity), 1e-4);
    EXPECT_LT(norm(m.spin), 1e-2);
    const double force = w.particles.mass[i] * 9.81;
    const double depth = std::pow(3 * force / (4 * q.young_eff * std::sqrt(m.equivalent_radius)), 2.0 / 3);
    EXPECT_NEAR(m.position.z, 0.007 - depth, 1e-5);
  }
}

TEST(RoundedPolyhedra, SameBitsForThreadsSkinAndRebuild) {
  Scene s = tray(90);
  const World one = scenes::run(s, 600, 1);
  EXPECT_GT(contacts_per_particle(one), 0.3);
  EXPECT_EQ(one.counters.not_converged, 0u);
  const std::uint64_t hash = state_hash(one);
  EXPECT_EQ(state_hash(scenes::run(s, 600, 4)), hash);
  s.run.skin = 0.0004;
  EXPECT_EQ(state_hash(scenes::run(s, 600, 2)), hash);
  s.run.rebuild_every = 1;
  EXPECT_EQ(state_hash(scenes::run(s, 600, 2)), hash);
  World resumed = build_world(tray(90));
  World first = scenes::run(tray(90), 200, 1);
  load_state(resumed, save_state(first));
  for (int i = 0; i < 400; ++i) advance(resumed, 1);
  EXPECT_EQ(state_hash(resumed), hash);
}

// Lengths × 2^7, times × 2^3, masses × 2^5: the same bits, scaled.
TEST(RoundedPolyhedra, SameBitsInOtherUnits) {
  const double length = 128, time = 8, mass = 32;
  Scene s;
  s.gravity = {0, 1, -16};
  s.materials = {scenes::material("soft", 5e6, 2500, 0.5, 0.4)};
  s.shapes = {
      rounded(scenes::box("brick", {0.012, 0.01, 0.008}), 0.001),
      rounded(scenes::points("wedge", {{0, 0, 0}, {0.012, 0.001, 0}, {0.002, 0.013, 0.001}, {0.003, 0.004, 0.011}}),
              0.0005)};
  s.shapes[1].diameter = 0.009;
  s.walls = {scenes::plane("floor", "soft", {0, 0, 0}, {0, 0, 1})};
  s.run.steps = 2000;
  for (int i = 0; i < 6; ++i)
    s.bodies.push_back(scenes::body(i % 2 ? "brick" : "wedge", "soft", {0.001 * i, 0, 0.012 + 0.02 * i}, {0, 0, -1},
                                    {1, 2, 3}, scenes::turn({0.6, 0, 0.8}, i)));
  const World before = scenes::run(s, 2000);
  for (auto& b : s.bodies) b.position *= length, b.velocity *= length / time, b.spin *= 1 / time;
  for (auto& shape : s.shapes) {
    shape.extents *= length;
    shape.rounding *= length;
    shape.diameter *= length;
    for (Vec3d& v : shape.vertices) v *= length;
  }
  s.materials[0].young *= mass / (length * time * time);
  s.materials[0].density *= mass / (length * length * length);
  s.gravity *= length / (time * time);
  const World after = scenes::run(s, 2000);
  EXPECT_GT(before.counters.contact_steps, 300u);
  for (std::uint64_t id = 0; id < 6; ++id) {
    EXPECT_EQ(scenes::motion(after, id).position, scenes::motion(before, id).position * length) << id;
    EXPECT_EQ(scenes::motion(after, id).velocity, scenes::motion(before, id).velocity * (length / time)) << id;
  }
}

}  // namespace
}  // namespace dem
