// Linear laws whose stiffness follows from a reference speed: their impacts last as long as those of Hertz.
#include "libdem/reference_stiffness.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "libdem/build.h"
#include "tests/libdem/scenes_in_code.h"

namespace dem {
namespace {

constexpr double radius = 0.01, speed = 0.5, young = 5e7, poisson = 0.25, density = 2500;

Scene two_balls(LawName law) {
  Scene s;
  s.law.name = law;
  s.law.reference_speed = law == LawName::linear_spring ? speed : 0;
  s.materials = {scenes::material("m", young, density, 1, 0)};
  s.materials[0].poisson = poisson;
  s.materials[0].stiffness = 0;
  s.shapes = {scenes::sphere("ball", radius)};
  const double gap = 1e-9;
  s.bodies = {scenes::body("ball", "m", {-radius - gap, 0, 0}, {0.5 * speed, 0, 0}),
              scenes::body("ball", "m", {radius + gap, 0, 0}, {-0.5 * speed, 0, 0})};
  s.run.dt_auto = false;
  s.run.dt = 2e-8;
  s.run.steps = 1;
  return s;
}

double duration(LawName law) {
  World w = build_world(two_balls(law));
  double first = -1;
  for (int i = 0; i < 100000; ++i) {
    advance(w, 1);
    const bool touching = contacts_per_particle(w) > 0;
    if (touching && first < 0) first = w.time();
    if (!touching && first >= 0) return w.time() - first;
  }
  return -1;
}

TEST(ReferenceStiffness, ImpactsLastAsLongAsThoseOfHertz) {
  const double hertz = duration(LawName::hertz_mindlin), linear = duration(LawName::linear_spring);
  ASSERT_GT(hertz, 0);
  EXPECT_NEAR(linear / hertz, 1, 3e-4);  // the step is 1e-4 of them
  // Hertz' own: 2.868265699 (m*²/(R* E*² v))^(1/5)
  const double young_eff = young / (2 * (1 - poisson * poisson)), r = 0.5 * radius;
  const double mass = 0.5 * density * 4.0 / 3.0 * std::numbers::pi * radius * radius * radius;
  const double expected = 2.868265699 * std::pow(mass * mass / (r * young_eff * young_eff * speed), 0.2);
  EXPECT_NEAR(hertz / expected, 1, 3e-4);
  EXPECT_NEAR(std::numbers::pi * std::sqrt(mass / reference_stiffness(young_eff, r, mass, speed)) / expected, 1, 1e-12);
}

// A wall, or a rigid partner, has neither mass nor radius in it; what a pair is given stays.
TEST(ReferenceStiffness, WallsAndGivenPairs) {
  Scene s = two_balls(LawName::linear_spring);
  s.materials.push_back(scenes::material("steel", 2e11, 7800, 1, 0));
  s.materials[1].rigid = true;
  s.walls = {scenes::plane("floor", "steel", {0, 0, -1}, {0, 0, 1})};
  World w = build_world(s);
  const double mass = density * 4.0 / 3.0 * std::numbers::pi * radius * radius * radius;
  const double young_eff = young / (1 - poisson * poisson);
  EXPECT_NEAR(w.pairs[1].stiffness_n / reference_stiffness(young_eff, radius, mass, speed), 1, 1e-12);
  EXPECT_NEAR(w.pairs[1].stiffness_t / w.pairs[1].stiffness_n, 2 * (1 - poisson) / (2 - poisson), 1e-12);
  MaterialPairSpec pair;
  pair.a = pair.b = "m";
  pair.stiffness = 123;
  s.pairs.push_back(pair);
  w = build_world(s);
  EXPECT_EQ(w.pairs[0].stiffness_n, 123);
}

}  // namespace
}  // namespace dem
