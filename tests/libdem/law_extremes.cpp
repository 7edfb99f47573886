// Every law of the list at every extreme of the list: right by closed forms, or stopped or refused by a message.
#include "libdem/validate/law_extremes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numbers>
#include <tuple>

#include "libcontact/laws/list.h"
#include "tests/libdem/scenes_in_code.h"

namespace dem {
namespace {

class LawExtremes : public testing::TestWithParam<std::tuple<std::string, std::size_t>> {};

TEST_P(LawExtremes, AreRightOrStopWithAMessage) {
  const auto& [law, i] = GetParam();
  const std::vector<validate::Row> rows = validate::law_extremes()[i].check(law);
  EXPECT_FALSE(rows.empty());
  for (const validate::Row& row : rows) {
    std::printf("  %s: %s, expected %s\n", row.criterion.c_str(), row.got.c_str(), row.expected.c_str());
    EXPECT_TRUE(row.pass) << row.criterion << ": " << row.got << ", expected " << row.expected;
  }
}

INSTANTIATE_TEST_SUITE_P(List, LawExtremes,
                         testing::Combine(testing::ValuesIn(validate::law_names()),
                                          testing::Range(std::size_t(0), validate::law_extremes().size())),
                         [](const auto& p) {
                           return std::get<0>(p.param) + "_" + validate::law_extremes()[std::get<1>(p.param)].name;
                         });

TEST(LawList, TheDashpotsAreThere) {
  const std::vector<std::string> names = validate::law_names();
  for (const char* name : {"spring_dashpot", "hertz_mindlin", "hertz_mindlin_deresiewicz", "mindlin_deresiewicz_exact"})
    EXPECT_NE(std::find(names.begin(), names.end(), name), names.end()) << name;
}

constexpr double radius = 0.01, stiffness = 1e4;
const double mass = 2500 * 4.0 / 3.0 * std::numbers::pi * radius * radius * radius;

// A ball that comes to the floor at 1 m/s, its first overlap the part `phase` of a step's way.
Scene coming(LawName law, double dt, double phase) {
  Scene s;
  s.law.name = law;
  s.materials = {scenes::material("m", 5e6, 2500, 1, 0)};
  s.materials[0].stiffness = stiffness;
  s.shapes = {scenes::sphere("ball", radius)};
  s.walls = {scenes::plane("floor", "m", {0, 0, 0}, {0, 0, 1})};
  s.run.steps = 1;
  s.run.dt_auto = false;
  s.run.dt = dt;
  s.bodies = {scenes::body("ball", "m", {0, 0, radius + (5 - phase) * dt}, {0, 0, -1})};
  return s;
}

// An impact that lasts two or three steps is over before the monitor of the time step looks: without a look of its own
// it would throw the ball back several times as fast.
TEST(Impact, PastTheLimitStopsAtEveryPhase) {
  for (const LawName law : {LawName::spring_dashpot, LawName::hertz_mindlin}) {
    const bool hertz = law == LawName::hertz_mindlin;
    // At the largest overlap of the undamped impact: linear v/ω; Hertz (15 m v²/(16 E* sqrt(R)))^(2/5).
    const double young = 0.5 * 5e6 / (1 - 0.09);
    const double deepest = std::pow(15 * mass / (16 * young * std::sqrt(radius)), 0.4);
    const double kn = hertz ? 2 * young * std::sqrt(radius * deepest) : stiffness;
    for (const double share : {1.6, 3.0, 10.0})
      for (int k = 1; k <= 20; ++k) {
        World w = build_world(coming(law, share * 2 * std::sqrt(mass / kn), k / 20.5));
        const auto run = [&] {
          for (int i = 0; i < 20; ++i) advance(w, 1);
        };
        EXPECT_THROW(run(), RunError) << "law " << hertz << ", " << share << " of the limit, phase " << k;
      }
    for (int k = 1; k <= 20; ++k) {  // and no run that is within it
      World w = build_world(coming(law, 0.3 * 2 * std::sqrt(mass / kn), k / 20.5));
      for (int i = 0; i < 30; ++i) advance(w, 1);
      EXPECT_NEAR(w.particles.motion[0].velocity.z, 1, 0.05);
    }
  }
}

// Nothing holds the sticking mode where there is no friction: its limit does not count.
TEST(Impact, WithoutFrictionOnlyTheNormalModeLimitsTheStep) {
  for (const double friction : {0.0, 0.5}) {
    Scene s = coming(LawName::spring_dashpot, 0.9 * 2 * std::sqrt(mass / stiffness), 0);
    s.materials[0].friction = friction;
    s.gravity = {0, 0, -0.02 * radius * stiffness / mass};
    s.bodies[0].position.z = 0.98 * radius;
    s.bodies[0].velocity = {};
    World w = build_world(s);
    const auto run = [&] {
      for (int i = 0; i < 200; ++i) advance(w, 1);
    };
    if (friction > 0)
      EXPECT_THROW(run(), RunError);
    else
      EXPECT_NO_THROW(run());
  }
}

// A small cube is set down on a slab that slides on a smooth floor, up to a hundred times as long: it is dragged along
// by μ m g, lags behind by V²/(2 μ g (1 + m/M)), and then rests on the slab at V M/(M + m), whatever their sizes.
TEST(Fines, ComeToRestOnALargeBodyThatMoves) {
  for (const LawName law : {LawName::spring_dashpot, LawName::hertz_mindlin})
    for (const double ratio : {3.0, 10.0, 30.0, 100.0}) {
      const double edge = 2e-3, g = 9.81, mu = 0.3, v = 0.1 * std::sqrt(g * edge), small = 2500 * edge * edge * edge;
      Scene s;
      s.law.name = law;
      s.gravity = {0, 0, -g};
      s.materials = {scenes::material("m", 2e12, 2500, 0.3, mu), scenes::material("floor", 0, 0, 0.3, 0)};
      s.materials[0].stiffness = 2e4 * ratio * ratio * small * g / edge;
      s.materials[1].rigid = true;
      s.shapes = {scenes::box("cube", {edge, edge, edge}), scenes::box("slab", {ratio * edge, ratio * edge, edge})};
      s.walls = {scenes::plane("floor", "floor", {0, 0, 0}, {0, 0, 1})};
      s.run.steps = 1;
      s.run.dt_fraction = 0.2;
      s.run.dt_overlap = 1e-5;
      s.run.dt_contacts = 1;
      s.bodies = {scenes::body("cube", "m", {0, 0, 1.5 * edge}),
                  scenes::body("slab", "m", {0, 0, 0.5 * edge}, {v, 0, 0})};
      World w = build_world(s);
      const double heavier = 1 + 1 / (ratio * ratio), slides = v / (mu * g * heavier);
      while (w.time() < 0.5 * slides) advance(w, 1);
      EXPECT_NEAR(scenes::motion(w, 0).velocity.x / (0.5 * mu * g * slides), 1, 0.02) << ratio;
      while (w.time() < 1.5 * slides) advance(w, 1);
      const Motion &a = scenes::motion(w, 0), &b = scenes::motion(w, 1);
      EXPECT_NEAR(a.velocity.x / (v / heavier), 1, 2e-3) << ratio;
      EXPECT_LT(std::abs(a.velocity.x - b.velocity.x), 1e-3 * v) << ratio;
      EXPECT_NEAR((b.position.x - a.position.x) / (v * v / (2 * mu * g * heavier)), 1, 0.02) << ratio;
      std::printf("  law %d, ratio %g: lags by %.4f of the way to expect, %llu steps\n", static_cast<int>(law), ratio,
                  (b.position.x - a.position.x) / (v * v / (2 * mu * g * heavier)),
                  static_cast<unsigned long long>(w.step));
    }
}

// A number that is none never goes on: bodies put at one place, a body thrown without a speed.
TEST(Numbers, ThatAreNoneStopTheRun) {
  for (const LawName law : {LawName::spring_dashpot, LawName::hertz_mindlin}) {
    Scene s = coming(law, 1e-5, 0);
    s.bodies[0].position.z = 1;
    s.bodies.push_back(scenes::body("ball", "m", {0, 0, 2}));
    World meet = build_world(s), thrown = meet;
    meet.particles.motion[1].position = meet.particles.motion[0].position;
    meet.particles.motion[0].velocity = {};
    meet.contacts.stale = true;
    EXPECT_THROW(advance(meet, 1), RunError);
    thrown.particles.motion[0].velocity.x = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(advance(thrown, 1), RunError);
  }
}

// Bodies that are pushed through a thin wall, or through each other, stop the run. (A body that is longest along its
// way is pushed out sideways instead.)
TEST(Depth, BeyondTheMiddleStops) {
  for (const ShapeSpec& shape :
       {scenes::sphere("body", radius), scenes::ellipsoid("body", {1.2 * radius, 1.2 * radius, radius}),
        scenes::box("body", {2 * radius, 2 * radius, 2 * radius})}) {
    for (const bool against_wall : {false, true}) {
      Scene s = coming(LawName::spring_dashpot, 1e-6, 0);
      s.run.dt_contacts = 1;
      s.walls.clear();
      s.shapes = {shape};
      const double fast = 20 * radius * std::sqrt(stiffness / mass);
      s.bodies = {scenes::body("body", "m", {1e-4 * radius, 0, 2.5 * radius}, {0, 0, -fast})};
      if (against_wall) {
        s.walls = {scenes::random_floor("sheet", "m", 0.1, 4, 0, 3)};
      } else {
        s.bodies.push_back(scenes::body("body", "m", {0, 0, 0}));
      }
      World w = build_world(s);
      const auto run = [&] {
        while (w.time() < 8 * radius / fast) advance(w, 1);
      };
      try {
        run();
        ADD_FAILURE() << shape.kind << (against_wall ? " went through the wall" : " went through the other");
      } catch (const RunError& error) {
        EXPECT_NE(std::string(error.what()).find("pass through each other"), std::string::npos) << error.what();
      }
    }
  }
}

}  // namespace
}  // namespace dem
