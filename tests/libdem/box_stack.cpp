// Flat faces on flat faces: a stack of boxes comes to rest and stays; so does a box dropped on a face, an edge, a
// corner.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

#include "tests/libdem/scenes_in_code.h"

namespace dem {
namespace {

constexpr double gravity = 9.81;

Scene on_the_floor(const Vec3d& extents) {
  Scene s;
  s.gravity = {0, 0, -gravity};
  s.materials = {scenes::material("soft", 5e6, 2500, 0.3, 0.5)};
  s.shapes = {scenes::box("block", extents)};
  s.walls = {scenes::plane("floor", "soft", {0, 0, 0}, {0, 0, 1})};
  s.run.steps = 1;
  s.run.dt_fraction = 0.5;
  return s;
}

double kinetic(const World& w) {
  const Energies e = energies(w);
  return e.translational + e.rotational;
}

TEST(BoxStack, FiveBoxesComeToRestAndStay) {
  const double height = 0.01;
  Scene s = on_the_floor({0.02, 0.02, height});
  const double turns[] = {0, 10, 25, 40, 5};
  for (int i = 0; i < 5; ++i)
    s.bodies.push_back(scenes::body("block", "soft", {0, 0, (i + 0.5) * height}, {}, {},
                                    scenes::turn({0, 0, 1}, turns[i] * M_PI / 180)));
  World w = build_world(s);
  while (w.time() < 1) advance(w, 1);
  std::vector<Vec3d> at_rest;
  for (std::uint64_t i = 0; i < 5; ++i) at_rest.push_back(scenes::motion(w, i).position);
  const double scale = w.particles.mass[0] * gravity * height;
  double worst = 0;
  std::size_t contacts = 0;
  while (w.time() < 2) {
    advance(w, 1);
    worst = std::max(worst, kinetic(w) / scale);
    contacts = std::max(contacts, touching_contacts(w).size());
  }
  const auto touching = touching_contacts(w);
  ASSERT_EQ(touching.size(), 5u);
  EXPECT_EQ(contacts, 5u);
  double least = height, drift = 0;
  for (const ContactReport& c : touching) least = std::min(least, c.overlap);
  for (std::uint64_t i = 0; i < 5; ++i)
    drift = std::max(drift, scenes::length(scenes::motion(w, i).position - at_rest[i]));
  std::printf("  dt %.2e s; from 1 s to 2 s: kinetic energy <= %.1e m g L, drift %.1e of the least overlap (%.2e m)\n",
              w.time_step.dt, worst, drift / least, least);
  EXPECT_LT(worst, 1e-10);
  EXPECT_LT(drift, 0.01 * least);
  for (const ContactReport& c : touching) {  // each carries what stands above it
    const double above = c.wall ? 5 : 4 - static_cast<double>(std::min(c.a, c.b));
    EXPECT_NEAR(std::abs(c.force.z) / (above * w.particles.mass[0] * gravity), 1, 1e-6);
  }
}

struct Drop {
  const char* name;
  Quatd orientation;
};

class DroppedBox : public testing::TestWithParam<int> {};

std::vector<Drop> drops() {
  return {{"flat", {}},
          {"on_an_edge", scenes::turn({0, 1, 0}, 0.9)},
          {"on_a_corner", scenes::turn({0.6, 0.8, 0}, 0.8) * scenes::turn({0, 0, 1}, 0.3)}};
}

TEST_P(DroppedBox, ComesToRestOnAFace) {
  Scene s = on_the_floor({0.02, 0.016, 0.012});
  const Drop d = drops()[static_cast<std::size_t>(GetParam())];
  double lowest = 0;
  for (int i = 0; i < 8; ++i)
    lowest = std::min(
        lowest, rotate(d.orientation, Vec3d{i & 1 ? 0.01 : -0.01, i & 2 ? 0.008 : -0.008, i & 4 ? 0.006 : -0.006}).z);
  s.bodies = {scenes::body("block", "soft", {0, 0, 0.002 - lowest}, {}, {}, d.orientation)};
  World w = build_world(s);
  while (w.time() < 1) advance(w, 1);
  const Vec3d before = w.particles.motion[0].position;
  double worst = 0;
  while (w.time() < 1.5) {
    advance(w, 1);
    worst = std::max(worst, kinetic(w) / (w.particles.mass[0] * gravity * 0.012));
  }
  const auto r = shapes::rotation_matrix(w.particles.orientation[0]);
  const double upright = shapes::max_abs(r.row[2]), overlap = touching_contacts(w).at(0).overlap;
  const double drift = scenes::length(w.particles.motion[0].position - before) / overlap;
  std::printf("  %-12s kinetic energy <= %.1e m g L, drift %.1e of the overlap, 1 − cos(tilt) %.1e\n", d.name, worst,
              drift, 1 - upright);
  EXPECT_LT(worst, 1e-10);
  EXPECT_LT(drift, 0.01);
  EXPECT_LT(1 - upright, 1e-10);
}

INSTANTIATE_TEST_SUITE_P(Orientations, DroppedBox, testing::Range(0, 3),
                         [](const auto& p) { return drops()[static_cast<std::size_t>(p.param)].name; });

}  // namespace
}  // namespace dem
