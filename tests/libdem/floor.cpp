// A body over a randomly triangulated flat floor does what it does over a plane: edges inside a flat region do not
// exist.
// The floor is at height 0: elsewhere the rounding of coordinates, one part in 10^16 of the height, shows in a grazing
// overlap.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

#include "tests/libdem/scenes_in_code.h"

namespace dem {
namespace {

struct Case {
  const char* name;
  ShapeSpec shape;
  BodySpec body;
};

std::vector<Case> cases() {
  return {
      {"sphere_rolling", scenes::sphere("s", 0.01),
       scenes::body("s", "m", {-0.05, -0.03, 0.01}, {1, 0.6, 0}, {-60, 100, 5})},
      {"sphere_sliding", scenes::sphere("s", 0.01),
       scenes::body("s", "m", {-0.05, -0.03, 0.01}, {1, 0.6, 0}, {0, -80, 30})},
      {"ellipsoid_rolling", scenes::ellipsoid("s", {0.01, 0.012, 0.015}),
       scenes::body("s", "m", {-0.05, -0.03, 0.01}, {0.3, 1, 0}, {0, 100, 0}, scenes::turn({0, 1, 0}, 1.57))},
      {"ellipsoid_sliding", scenes::ellipsoid("s", {0.01, 0.012, 0.015}),
       scenes::body("s", "m", {-0.05, -0.03, 0.01501}, {1, 0.6, 0}, {0, 0, 20})},
      {"box_sliding", scenes::box("s", {0.02, 0.016, 0.01}),
       scenes::body("s", "m", {-0.05, -0.03, 0.005}, {1, 0.6, 0}, {0, 0, 25}, scenes::turn({0, 0, 1}, 0.4))},
      {"box_tumbling", scenes::box("s", {0.02, 0.016, 0.014}),
       scenes::body("s", "m", {-0.05, -0.03, 0.0125}, {1, 0.6, -0.2}, {-40, 70, 5}, scenes::turn({0.6, 0.8, 0}, 0.5))}};
}

Scene over(const Case& c, bool mesh) {
  Scene s;
  s.gravity = {0, 0, -9.81};
  s.materials = {scenes::material("m", 5e6, 2500, 0.6, 0.3)};
  s.shapes = {c.shape};
  s.bodies = {c.body};
  s.run.steps = 1;
  s.walls = {mesh ? scenes::random_floor("floor", "m", 0.3, 60, 0, 11)
                  : scenes::plane("floor", "m", {0, 0, 0}, {0, 0, 1})};
  return s;
}

double relative(const Vec3d& a, const Vec3d& b) {
  const double size = std::max(scenes::length(a), scenes::length(b));
  return size == 0 ? 0 : scenes::length(a - b) / size;
}

class Floor : public testing::TestWithParam<int> {};

TEST_P(Floor, ATriangulatedPlaneIsThePlane) {
  const Case c = cases()[static_cast<std::size_t>(GetParam())];
  World plane = build_world(over(c, false)), mesh = build_world(over(c, true));
  const World fresh = mesh;
  ASSERT_DOUBLE_EQ(plane.time_step.dt, mesh.time_step.dt);
  const double radius = plane.shapes[0].equivalent_radius, v0 = scenes::length(plane.particles.motion[0].velocity);
  const Vec3d start = plane.particles.motion[0].position;
  double apart = 0, turned = 0, force = 0, torque = 0;
  int touching = 0, breaks = 0, parts = 0;
  for (int i = 0; i < 2000; ++i) {
    if (i % 20 == 0) {  // the same pose, velocity and history on either floor
      World on_plane = plane, on_mesh = fresh;
      load_state(on_mesh, save_state(plane));
      advance(on_plane, 1);
      advance(on_mesh, 1);
      force = std::max(force, relative(on_plane.particles.force[0], on_mesh.particles.force[0]));
      const Vec3d dt = on_plane.particles.torque[0] - on_mesh.particles.torque[0];
      const double arm = scenes::length(on_plane.particles.force[0]) * radius;
      if (arm > 0) torque = std::max(torque, scenes::length(dt) / arm);
    }
    advance(plane, 1);
    advance(mesh, 1);
    const auto on_plane = touching_contacts(plane), on_mesh = touching_contacts(mesh);
    touching += on_plane.empty() ? 0 : 1;
    breaks += on_plane.size() != on_mesh.size() ? 1 : 0;
    for (const ContactReport& r : on_mesh) parts += r.part != 0 ? 1 : 0;
    apart = std::max(apart, scenes::length(plane.particles.motion[0].position - mesh.particles.motion[0].position));
    turned = std::max(turned, scenes::length(plane.particles.rotation[0] - mesh.particles.rotation[0]));
  }
  const double travelled = scenes::length(plane.particles.motion[0].position - start);
  std::printf("  %-18s dt %.2e s, touching in %d of 2000 steps, went %.1f mm over triangles of 10 mm\n", c.name,
              plane.time_step.dt, touching, 1e3 * travelled);
  std::printf("    equal poses: force %.1e, torque %.1e (of F R); paths part by %.1e R and %.1e rad\n", force, torque,
              apart / radius, turned);
  EXPECT_GT(touching, 50);
  EXPECT_EQ(breaks, 0);  // neither doubled nor missing: the history goes on across every edge
  EXPECT_EQ(parts, 0);
  EXPECT_LT(force, 1e-12);
  EXPECT_LT(torque, 1e-12);
  EXPECT_LT(apart, 1e-9 * radius);
  EXPECT_LT(turned, 1e-9);
  EXPECT_GT(travelled, 0.5 * v0 * plane.time());
}

INSTANTIATE_TEST_SUITE_P(Bodies, Floor, testing::Range(0, 6),
                         [](const auto& p) { return cases()[static_cast<std::size_t>(p.param)].name; });

}  // namespace
}  // namespace dem
