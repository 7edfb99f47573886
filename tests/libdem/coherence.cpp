// Pairs known to be apart still: the bound of travel, and that what it spares changes nothing.
#include "libdem/coherence.h"

#include <gtest/gtest.h>

#include <random>

#include "tests/libdem/scenes_in_code.h"

namespace dem {
namespace {

// No point of a body moves farther than its travel says, whatever the turn; and a quarter of it is not enough, so the
// bound is not idle.
TEST(Coherence, NoPointMovesFartherThanTravelSays) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> u(-1, 1);
  double closest = 0;
  for (int i = 0; i < 20000; ++i) {
    const auto quaternion = [&] { return shapes::normalized(Quatd{u(random), u(random), u(random), u(random)}); };
    const Quatd before = quaternion();
    const double small = std::exp2(-20 * std::abs(u(random)));
    Quatd after = before * shapes::normalized(Quatd{1, small * u(random), small * u(random), small * u(random)});
    const double radius = std::exp2(10 * u(random));
    const Vec3d displacement = Vec3d{u(random), u(random), u(random)} * (radius * small);
    const Vec3d point = shapes::normalized(Vec3d{u(random), u(random), u(random)}) * radius;
    const Vec3d moved = displacement + shapes::rotate(after, point) - shapes::rotate(before, point);
    const double travel = travel_of(displacement, before, after, radius);
    ASSERT_LE(norm(moved), travel * (1 + 1e-12) + 1e-14 * radius) << i;
    closest = std::max(closest, norm(moved) / travel);
  }
  EXPECT_GT(closest, 0.5);
}

TEST(Coherence, AGapThatRoundingCouldHaveMadeKeepsNothingApart) {
  EXPECT_LE(apart_until(3.0, 1e-13, 0.01), 3.0);
  EXPECT_GT(apart_until(3.0, 1e-3, 0.01), 3.0009);
  EXPECT_LT(apart_until(3.0, 1e-3, 0.01), 3.001);
}

// With a list made anew at every step nothing is known of earlier steps, and every candidate is looked at.
TEST(Coherence, WhatIsSparedChangesNoBit) {
  Scene s = scenes::every_shape(200);
  const World spared = scenes::run(s, 500);
  s.run.rebuild_every = 1;
  const World asked = scenes::run(s, 500);
  EXPECT_EQ(state_hash(spared), state_hash(asked));
  Tally sum, sum_asked;
  for (std::size_t a = 0; a < shapes::kind_count; ++a)
    for (std::size_t b = 0; b < shapes::kind_count; ++b) {
      const Tally& t = spared.profile.pairs[a][b];
      EXPECT_LE(t.by_displacement + t.by_spheres + t.by_axis + t.touching, t.candidates);
      EXPECT_EQ(t.touching, asked.profile.pairs[a][b].touching);
      sum += t;
      sum_asked += asked.profile.pairs[a][b];
    }
  EXPECT_EQ(sum.candidates, spared.counters.queries);
  EXPECT_EQ(sum.touching, spared.counters.contact_steps);
  EXPECT_GT(10 * sum.by_displacement, 3 * sum.candidates);
  EXPECT_GT(sum.by_spheres, 0u);
  EXPECT_GT(sum.by_axis, 0u);
  EXPECT_EQ(sum_asked.by_displacement, 0u);
}

// A wall that comes is seen, though the body beside it has not moved.
TEST(Coherence, AWallThatMovesIsMet) {
  for (const char* motion : {"translation", "oscillation", "rotation"}) {
    Scene s;
    s.law.name = LawName::hertz_mindlin;
    s.materials = {scenes::material("soft", 5e6, 2500, 0.5, 0.4)};
    s.shapes = {scenes::box("cube", {0.01, 0.01, 0.01})};
    BodySpec cube;
    cube.shape = "cube";
    cube.material = "soft";
    s.bodies = {cube};
    WallSpec w;
    w.name = "piston";
    w.material = "soft";
    w.kind = "plane";
    w.normal = {1, 0, 0};
    w.point = {-0.0052, 0, 0};
    s.walls = {w};
    s.run.skin = 0.004;
    if (std::string(motion) == "translation") {
      s.walls[0].motion = WallMotion::translation;
      s.walls[0].velocity = {0.5, 0, 0};
    } else if (std::string(motion) == "oscillation") {
      s.walls[0].motion = WallMotion::oscillation;
      s.walls[0].amplitude = {0.0004, 0, 0};
      s.walls[0].frequency = 200;
    } else {
      s.walls[0].motion = WallMotion::rotation;
      s.walls[0].axis = {0, 0, 1};
      s.walls[0].centre = {-0.0052, -0.1, 0};
      s.walls[0].rate = -5;
    }
    const std::uint64_t steps = 400;
    const World spared = scenes::run(s, steps);
    s.run.rebuild_every = 1;
    EXPECT_EQ(state_hash(spared), state_hash(scenes::run(s, steps))) << motion;
    EXPECT_GT(spared.counters.contact_steps, 0u) << motion;
  }
}

}  // namespace
}  // namespace dem
