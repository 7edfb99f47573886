// What dem check says before a run: closed forms, the table of limits, loads, memory, the packed sample. No test looks
// at a clock.
#include <gtest/gtest.h>

#include <cstdio>
#include <numbers>

#include "libcontact/laws/mix.h"
#include "libdem/forecast/closed_forms.h"
#include "libdem/forecast/loads.h"
#include "libdem/forecast/memory.h"
#include "libdem/forecast/packing.h"
#include "libdem/forecast/warnings.h"
#include "tests/libdem/scenes_in_code.h"

namespace dem {
namespace {

constexpr double pi = std::numbers::pi;

// A published pair of collisions (Chung and Ooi 2011, tests 1 and 2): two glass spheres at ±10 m/s, an aluminium sphere
// on a rigid wall at 0.2 m/s.
TEST(Forecast, HertzCollisionsOfThePublishedTests) {
  const auto mass = [](double rho, double r) { return rho * 4 / 3 * pi * r * r * r; };
  const double glass = 48e9 / (2 * (1 - 0.2 * 0.2)), aluminium = 70e9 / (1 - 0.3 * 0.3);
  const auto two = forecast::hertz_collision(mass(2800, 0.01) / 2, 0.005, glass, 20);
  EXPECT_NEAR(two.duration, 40.339e-6, 1e-9);
  EXPECT_NEAR(two.overlap, 0.274113e-3, 1e-9);
  const auto wall = forecast::hertz_collision(mass(2699, 0.1), 0.1, aluminium, 0.2);
  EXPECT_NEAR(wall.duration, 731.657e-6, 1e-9);
  EXPECT_NEAR(wall.overlap, 49.7172e-6, 1e-10);
  // The same overlap under the force of that instant.
  const double force = 4.0 / 3 * aluminium * std::sqrt(0.1) * std::pow(wall.overlap, 1.5);
  EXPECT_NEAR(force, 11369.9, 0.1);
  EXPECT_NEAR(forecast::hertz_overlap(force, 0.1, aluminium), wall.overlap, 1e-15);
}

TEST(Forecast, RayleighTimeBySpeedOfItsWave) {
  // ν = 0.25: the exact speed is 0.91940 sqrt(G/ρ).
  const double shear = 70e9 / 2.5, speed = 0.91940 * std::sqrt(shear / 2500);
  EXPECT_NEAR(forecast::rayleigh_time(0.005, 2500, 70e9, 0.25) / (pi * 0.005 / speed), 1, 3e-3);
}

// A simple cubic bed: z/2R layers, each body's contact carries all above it. By hand p = ρ g φ H, F = p (2R)².
TEST(Forecast, MeanContactForceOfACubicBed) {
  const double r = 0.01, p = 1000;
  EXPECT_NEAR(forecast::contact_force(p, r, pi / 6, 6), p * 4 * r * r, 1e-12);
  EXPECT_NEAR(forecast::contact_force_of_prisms(p, r, 0.05, pi / 4, 4), p * 2 * r * 0.05, 1e-12);
}

Scene two_sizes() {
  Scene s;
  s.gravity = {0, 0, -9.81};
  s.law.name = LawName::spring_dashpot;
  s.materials = {scenes::material("smooth", 0, 2500, 1, 0), scenes::material("rough", 0, 5000, 0.5, 0.5)};
  s.materials[0].stiffness = 1e4;
  s.materials[1].stiffness = 4e4;
  s.shapes = {scenes::sphere("small", 0.005), scenes::sphere("large", 0.01)};
  s.walls = {scenes::plane("floor", "rough", {0, 0, 0}, {0, 0, 1})};
  s.run.time = 10;
  s.run.dt_contacts = 2;
  s.bodies = {scenes::body("small", "smooth", {0, 0, 0.5}), scenes::body("large", "rough", {0.1, 0, 0.8}),
              scenes::body("large", "rough", {0.2, 0, 0.3})};
  s.bodies[2].scale = 0.5;
  return s;
}

// Groups (small of smooth), (large of rough): their pairs and walls against 2 sqrt(m*/k) and 2 sqrt(2 m*/(7 kt)), whose
// dashpot is sqrt(7/2) times as strong.
TEST(Forecast, LimitsOfEveryPairInClosedForm) {
  const World w = build_world(two_sizes());
  const auto groups = body_groups(w);
  ASSERT_EQ(groups.size(), 2u);
  EXPECT_EQ(groups[1].count, 2u);
  EXPECT_EQ(w.particles.id[groups[1].light], 2u);
  EXPECT_EQ(w.particles.id[groups[1].large], 1u);
  const auto limits = pair_limits(w, groups);
  ASSERT_EQ(limits.size(), 5u);
  const auto mass = [](double rho, double r) { return rho * 4 / 3 * pi * r * r * r; };
  const double small = mass(2500, 0.005), light = mass(5000, 0.005);  // of scale 0.5
  const double beta = contact::clipped_damping(0.5), damped = std::sqrt(1 + beta * beta) - beta;
  const double stuck = std::sqrt(1 + 3.5 * beta * beta) - std::sqrt(3.5) * beta;
  const double soft = 1e4, mixed = 2 / (1 / 1e4 + 1 / 4e4), hard = 4e4, ratio = 2 * (1 - 0.3) / (2 - 0.3);
  const auto limit = [](double m, double k) { return 2 * std::sqrt(m / k); };
  const auto expect = [&](std::size_t i, bool wall, double normal, double tangential) {
    EXPECT_EQ(limits[i].wall, wall) << i;
    EXPECT_NEAR(limits[i].normal / normal, 1, 1e-12) << i;
    if (tangential > 0)
      EXPECT_NEAR(limits[i].tangential / tangential, 1, 1e-12) << i;
    else
      EXPECT_TRUE(std::isinf(limits[i].tangential)) << i;
  };
  expect(0, false, limit(small / 2, soft), 0);
  const double both = small * light / (small + light);
  expect(1, false, damped * limit(both, mixed), 0);  // the lower friction of the two: 0
  expect(2, true, damped * limit(small, mixed), 0);
  expect(3, false, damped * limit(light / 2, hard), stuck * limit(light / 2 / 3.5, hard * ratio));
  expect(4, true, damped * limit(light, hard), stuck * limit(light / 3.5, hard * ratio));
  double least = limits[0].limit();
  for (const PairLimit& l : limits) least = std::min(least, l.limit());
  EXPECT_EQ(w.time_step.limit, least);
}

TEST(Forecast, CollisionsAndLoadsOfTheScene) {
  const World w = build_world(two_sizes());
  const auto loads = forecast::expected_loads(w);
  // Alone above a wide floor: from 0.8 m down to a centre at 0.01 m, but for the layer that the others make there.
  EXPECT_NEAR(loads.fall, 0.79, 0.02);
  EXPECT_NEAR(loads.impact / std::sqrt(2 * 9.81 * loads.fall), 1, 1e-12);
  EXPECT_NEAR(loads.fall_time / std::sqrt(2 * loads.fall / 9.81), 1, 1e-12);
  EXPECT_EQ(loads.unsupported, 0u);
  ASSERT_EQ(loads.pressures.size(), 1u);
  double mass = 0;
  for (const double m : w.particles.mass) mass += m;
  EXPECT_NEAR(loads.pressures[0].value * loads.ground_area / (mass * 9.81), 1, 1e-12);
  const auto pairs = forecast::pair_forecasts(w, body_groups(w), loads);
  const double small = 2500 * 4.0 / 3 * pi * 0.005 * 0.005 * 0.005;
  EXPECT_NEAR(pairs[2].duration / (pi * std::sqrt(small / 16000)), 1, 1e-12);
  EXPECT_NEAR(pairs[2].impact_overlap / (loads.impact * std::sqrt(small / 16000) / 0.005), 1, 1e-12);
}

TEST(Forecast, SpeedsOfWallsAndFallsWithoutAFloor) {
  Scene s = two_sizes();
  s.walls[0].motion = WallMotion::oscillation;
  s.walls[0].amplitude = {0, 0, 0.002};
  s.walls[0].frequency = 50;
  EXPECT_NEAR(forecast::expected_loads(build_world(s)).wall_speed, 0.002 * 2 * pi * 50, 1e-12);
  s.walls[0].start = 20;  // after the end of the run
  EXPECT_EQ(forecast::expected_loads(build_world(s)).wall_speed, 0);
  s.walls[0] = scenes::plane("side", "rough", {-1, 0, 0}, {1, 0, 0});
  const World open = build_world(s);
  const auto loads = forecast::expected_loads(open);
  EXPECT_EQ(loads.unsupported, 3u);
  EXPECT_TRUE(loads.pressures.empty());
  const auto warnings =
      forecast::dynamic_warnings(open, loads, forecast::pair_forecasts(open, body_groups(open), loads));
  ASSERT_FALSE(warnings.empty());
  EXPECT_NE(warnings.back().find("3 of 3 bodies have no wall below"), std::string::npos) << warnings.back();
}

TEST(Forecast, NeighboursInABoxThatDeforms) {
  Scene s = two_sizes();
  s.gravity = {};
  s.walls.clear();
  s.periodic.axes = "xyz";
  s.periodic.lower = {-1, -1, -1};
  s.periodic.upper = {1, 1, 1};
  s.periodic.deform.resize(2);
  s.periodic.deform[0].strain_rates = {-0.25, 0, 0.125};
  s.periodic.deform[1].strain_rates = {-1, 0, 0};
  s.periodic.deform[1].start = 20;  // after the end of the run
  const auto loads = forecast::expected_loads(build_world(s));
  EXPECT_EQ(loads.flow_speed, 2 * 0.01 * 0.25);
  EXPECT_EQ(loads.impact, loads.flow_speed);
}

TEST(Forecast, AServoPressesByItsForceOverItsArea) {
  Scene s = two_sizes();
  WallSpec lid = scenes::plane("lid", "rough", {0, 0, 2}, {0, 0, -1});
  lid.motion = WallMotion::servo;
  lid.axis = {0, 0, -1};
  lid.target_pressure = 5000;
  lid.area = 0.02;
  lid.speed_limit = 3;
  s.walls.push_back(lid);
  const auto loads = forecast::expected_loads(build_world(s));
  ASSERT_EQ(loads.pressures.size(), 2u);
  EXPECT_NEAR(loads.pressures[1].value, 5000, 1e-9);
  EXPECT_EQ(loads.wall_speed, 3);
}

// A scene in other units (lengths × 2^8, times × 2^4, masses × 2^4) has the same loads in those units.
TEST(Forecast, LoadsScaleWithTheUnits) {
  Scene s = two_sizes();
  const auto before = forecast::expected_loads(build_world(s));
  const double length = 256, time = 16, mass = 16;
  for (auto& b : s.bodies) b.position *= length;
  for (auto& b : s.shapes) b.radius *= length;
  for (auto& m : s.materials) {
    m.stiffness *= mass / (time * time);
    m.density *= mass / (length * length * length);
  }
  s.gravity *= length / (time * time);
  s.run.time *= time;
  const auto after = forecast::expected_loads(build_world(s));
  EXPECT_EQ(after.fall, before.fall * length);
  EXPECT_EQ(after.impact, before.impact * length / time);
  EXPECT_EQ(after.pressures[0].value, before.pressures[0].value * mass / (length * time * time));
}

Scene bed(const std::vector<ShapeSpec>& shapes) {
  Scene s;
  s.gravity = {0, 0, -9.81};
  s.materials = {scenes::material("soft", 1e7, 2500, 0.5, 0.4)};
  s.shapes = shapes;
  s.walls = {scenes::plane("floor", "soft", {0, 0, 0}, {0, 0, 1})};
  s.run.time = 1;
  FillSpec fill;
  fill.lower = {0, 0, 0};
  fill.upper = {0.2, 0.2, 0.2};
  fill.count = 400;
  for (const ShapeSpec& shape : shapes) fill.items.push_back({shape.name, "soft", 1, 0.8, 1});
  s.fills = {fill};
  return s;
}

TEST(Forecast, ThePackedSampleIsABed) {
  const auto balls = forecast::packed_sample(build_world(bed({scenes::sphere("ball", 0.005)})));
  EXPECT_TRUE(balls.packed);
  EXPECT_GT(balls.solid_fraction, 0.55);
  EXPECT_LT(balls.solid_fraction, 0.66);
  EXPECT_GT(balls.contacts_per_body, 2);
  EXPECT_LT(balls.contacts_per_body, 3);
  const auto mixed = forecast::packed_sample(
      build_world(bed({scenes::ellipsoid("egg", {0.004, 0.005, 0.0075}), scenes::box("brick", {0.006, 0.008, 0.012}),
                       scenes::sphere("b", 0.005)})));
  std::printf("  balls: solid %.3f, pairs %.2f; mixed: solid %.3f, pairs %.2f\n", balls.solid_fraction,
              balls.contacts_per_body, mixed.solid_fraction, mixed.contacts_per_body);
  EXPECT_TRUE(mixed.packed);
  EXPECT_GT(mixed.solid_fraction, 0.5);
  EXPECT_LT(mixed.solid_fraction, 0.8);
  // Twice the same.
  const auto again = forecast::packed_sample(build_world(bed({scenes::sphere("ball", 0.005)})));
  EXPECT_EQ(state_hash(again.world), state_hash(balls.world));
}

// The model of memory against the lists of a bed as they are, bodies and contacts apart.
TEST(Forecast, MemoryOfAPackedBedWithinAFactorOfTwo) {
  for (const bool round : {true, false}) {
    const auto sample = forecast::packed_sample(
        build_world(bed({round ? scenes::sphere("ball", 0.005) : scenes::box("brick", {0.006, 0.008, 0.012})})));
    const World& w = sample.world;
    const auto actual = forecast::bytes_of(w);
    const auto model =
        forecast::bytes_of_packed(w, static_cast<double>(w.particles.count()), sample.records_per_body, 0, round);
    std::printf("  %s: bodies %.0f of %.0f B, contacts %.0f of %.0f B\n", round ? "balls" : "bricks", model.bodies,
                actual.bodies, model.contacts, actual.contacts);
    EXPECT_GT(model.bodies / actual.bodies, 0.5);
    EXPECT_LT(model.bodies / actual.bodies, 2);
    EXPECT_GT(model.contacts / actual.contacts, 0.5);
    EXPECT_LT(model.contacts / actual.contacts, 2);
    EXPECT_GT(model.rebuild, 0.5 * model.contacts);
  }
}

}  // namespace
}  // namespace dem
