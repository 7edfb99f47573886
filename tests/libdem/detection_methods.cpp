// Every approximate method in the catalogue drives a scene: two bodies that it answers for meet off their centres and
// part again. Other pairs of the scene are answered by exact methods.
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "libdem/detection.h"
#include "tests/libcontact/catalogue.h"
#include "tests/libdem/same_bits.h"
#include "tests/libdem/scenes_planar.h"

namespace dem {
namespace {

using contact::MethodInfo;
using shapes::Kind;

ShapeSpec sample(Kind kind) {
  switch (kind) {
    case Kind::sphere:
      return scenes::sphere("grain", 0.008);
    case Kind::disc:
      return scenes::disc("grain", 0.008);
    case Kind::rounded_polyhedron: {
      ShapeSpec s = scenes::box("grain", {0.016, 0.008, 0.012});
      s.rounding = 0.002;
      return s;
    }
    case Kind::ellipse:
      return scenes::ellipse("grain", 0.01, 0.006);
    case Kind::ellipsoid:
      return scenes::ellipsoid("grain", {0.01, 0.006, 0.008});
    case Kind::polygon:
      return scenes::regular_polygon("grain", 5, 0.01);
    case Kind::polyhedron:
      return scenes::box("grain", {0.02, 0.012, 0.016});
    case Kind::potential_particle: {
      ShapeSpec s;
      s.name = "grain";
      s.kind = "potential_particle";
      s.half_spaces = {{1, 0, 0, 0.008},  {-1, 0, 0, 0.008}, {0, 1, 0, 0.006},
                       {0, -1, 0, 0.006}, {0, 0, 1, 0.008},  {0, 0, -1, 0.008}};
      s.k = 0.3;
      s.r = 0.003;
      s.R = 0.01;
      return s;
    }
    default:
      throw std::logic_error("no sample of this kind");
  }
}

Scene meeting(const MethodInfo& m) {
  Scene s;
  const bool flat = shapes::dimension_of(m.a) == 2;
  s.dimension = flat ? 2 : 3;
  s.thickness = flat ? 0.01 : 0;
  s.disc_model = DiscModel::prism;
  s.law.name = LawName::spring_dashpot;
  s.method = m.name;
  s.run.steps = 1;
  MaterialSpec soft = scenes::material("soft", 5e6, 2500, 1, 0);
  soft.stiffness = 2e4;
  s.materials = {soft};
  s.shapes = {sample(m.a)};
  const Vec3d axis = flat ? Vec3d{0, 0, 1} : Vec3d{0.6, 0, 0.8};
  s.bodies = {scenes::body("grain", "soft", {0, 0, 0}, {0.25, 0, 0}, {}, scenes::turn(axis, 0.375)),
              scenes::body("grain", "soft", {0.026, 0.003, 0}, {-0.25, 0, 0}, {}, scenes::turn(axis, -0.25))};
  WallSpec far = scenes::plane("far", "soft", {0, -1, 0}, {0, 1, 0});
  if (flat) far.kind = "line";
  s.walls = {far};
  return s;
}

std::vector<MethodInfo> approximate() {
  std::vector<MethodInfo> list = catalogue::of_whole_bodies();
  std::erase_if(list, [](const MethodInfo& m) { return m.exact || m.a != m.b; });
  return list;
}

class DetectionMethods : public testing::TestWithParam<MethodInfo> {};

TEST_P(DetectionMethods, bodies_meet_and_part) {
  const MethodInfo& m = GetParam();
  const Scene scene = meeting(m);
  EXPECT_EQ(detection::choose(m.a, m.b, scene)->name, m.name);
  // A wall that it does not answer has an exact method.
  const Kind wall = shapes::dimension_of(m.a) == 2 ? Kind::line : Kind::plane;
  EXPECT_TRUE(detection::choose(m.a, wall, scene)->exact || contact::choose(m.a, wall, m.name) != nullptr);
  EXPECT_FALSE(detection::closed_form(m.a, m.b, scene));
  World world = build_world(scene);
  const auto& motion = world.particles.motion;
  double closest = 1;
  for (int i = 0; i < 200000 && motion[1].velocity.x - motion[0].velocity.x < 0; ++i) {
    advance(world, 1);
    closest = std::min(closest, motion[1].position.x - motion[0].position.x);
  }
  EXPECT_GT(motion[1].velocity.x - motion[0].velocity.x, 0);
  EXPECT_GT(closest, 0.008);  // hardly an overlap
  EXPECT_GT(world.counters.contact_steps, 10u);
  EXPECT_EQ(world.counters.not_converged, 0u);
  const Vec3d momentum = motion[0].velocity + motion[1].velocity;
  EXPECT_LE(scenes::length(momentum), 1e-14);
}

INSTANTIATE_TEST_SUITE_P(Catalogue, DetectionMethods, testing::ValuesIn(approximate()), catalogue::entry_name);

TEST(DetectionMethods, a_method_that_answers_no_pair_is_refused) {
  Scene s = meeting(*contact::choose(Kind::ellipsoid, Kind::ellipsoid, "common_normal"));
  s.method = "sat";
  EXPECT_THROW(build_world(s), InputError);
}

}  // namespace
}  // namespace dem
