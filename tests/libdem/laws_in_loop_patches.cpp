// Contacts over patches under every law: a square floor answers the same however it is cut, and as a plane; the force
// of a face on a face does not know of how many corners it has.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

#include "tests/libdem/laws_in_loop.h"

namespace dem {
namespace {

enum class Floor { plane, one_diagonal, other_diagonal };

WallSpec floor_of(Floor kind) {
  if (kind == Floor::plane) return scenes::plane("floor", "m", {0, 0, 0}, {0, 0, 1});
  WallSpec w;
  w.name = "floor";
  w.kind = "mesh";
  w.material = "m";
  const double half = 8 * law_loop::radius;
  w.vertices = {{-half, -half, 0}, {half, -half, 0}, {half, half, 0}, {-half, half, 0}};
  w.triangles = {{0, 1, 2}, {0, 2, 3}};
  if (kind == Floor::other_diagonal) w.triangles = {{0, 1, 3}, {1, 2, 3}};
  return w;
}

// Thrown down askew across both diagonals, it lands, slides, rolls.
World thrown(const LawSpec& law, const ShapeSpec& shape, Floor kind, double height) {
  Scene s;
  s.law = law;
  s.gravity = {0, 0, -9.81};
  s.materials = {law_loop::material()};
  s.shapes = {shape};
  s.walls = {floor_of(kind)};
  s.run.steps = 1;
  s.run.dt_fraction = 0.25;
  const double r = law_loop::radius;
  s.bodies = {scenes::body("body", "m", {-0.4 * r, 0.9 * r, height}, {0.5, -0.7, -0.3}, {3, 20, -10},
                           scenes::turn({0.6, 0.8, 0}, 0.05))};
  World w = build_world(s);
  for (int i = 0; i < 500; ++i) advance(w, 1);
  return w;
}

class LawPatches : public testing::TestWithParam<std::size_t> {
 protected:
  LawSpec law() const { return law_loop::every_law()[GetParam()]; }
};

TEST_P(LawPatches, AFloorIsTheSameHoweverItIsCut) {
  const double r = law_loop::radius;
  // Where Box 9.1 and Thornton's sliding begin to stick anew, their forces go with the root of what has slipped since,
  // and so does what rounding leaves.
  const bool rooted = law().name == LawName::hertz_mindlin_deresiewicz || law().name == LawName::jkr_thornton;
  const double bar = rooted ? 1e-6 : 1e-12;
  const std::pair<ShapeSpec, double> bodies[] = {{scenes::sphere("body", r), 1.0001 * r},
                                                 {scenes::ellipsoid("body", {r, 0.9 * r, 0.8 * r}), 0.82 * r},
                                                 {scenes::box("body", {2 * r, 1.8 * r, 1.6 * r}), 0.9 * r}};
  for (const auto& [shape, height] : bodies) {
    const World plane = thrown(law(), shape, Floor::plane, height);
    EXPECT_GT(plane.counters.contact_steps, 10u) << shape.kind;
    for (const Floor kind : {Floor::one_diagonal, Floor::other_diagonal}) {
      const World mesh = thrown(law(), shape, kind, height);
      const Motion &a = plane.particles.motion[0], &b = mesh.particles.motion[0];
      EXPECT_LT(scenes::length(a.position - b.position), bar * r) << shape.kind;
      EXPECT_LT(scenes::length(plane.particles.rotation[0] - mesh.particles.rotation[0]), bar) << shape.kind;
      EXPECT_EQ(plane.counters.contact_steps, mesh.counters.contact_steps) << shape.kind;
    }
  }
}

// Prisms of 3 to 40 sides, pressed flat on a plane to the same overlap: what the law gives for their radius.
TEST_P(LawPatches, TheForceOfAFaceDoesNotKnowItsCorners) {
  const double r = law_loop::radius, overlap = 2e-3 * r;
  for (const int sides : {3, 4, 6, 12, 40}) {
    ShapeSpec shape;
    shape.name = "body";
    shape.kind = "prism";
    shape.sides = sides;
    shape.circumradius = r;
    shape.height = 2 * r;
    Scene s;
    s.law = law();
    s.law.ledger = true;  // memory holds the stored energy
    s.materials = {law_loop::material()};
    s.shapes = {shape};
    s.walls = {scenes::plane("floor", "m", {0, 0, 0}, {0, 0, 1})};
    s.run.steps = 1;
    s.bodies = {scenes::body("body", "m", {0, 0, r - overlap}, {}, {}, scenes::turn({0, 0, 1}, 0.2))};
    const World w = build_world(s);
    ASSERT_EQ(touching_contacts(w).size(), 1u);
    double energy = 0;
    const double expected = law_loop::force_of(w, w.particles.motion[0].equivalent_radius, overlap, &energy);
    const Vec3d force = touching_contacts(w)[0].force;
    EXPECT_NEAR(force.z / expected, 1, 1e-9) << sides;
    EXPECT_LT(std::abs(force.x) + std::abs(force.y), 1e-12 * std::abs(force.z)) << sides;
    EXPECT_NEAR(energies(w).elastic / energy, 1, 1e-9) << sides;
  }
}

INSTANTIATE_TEST_SUITE_P(Every, LawPatches, testing::Range(std::size_t(0), law_loop::every_law().size()),
                         [](const auto& p) { return law_loop::test_name(law_loop::every_law()[p.param]); });

}  // namespace
}  // namespace dem
