// Bonds in the loop: held across the gap that their law says and not longer, whatever the list of candidates does, on
// spheres, ellipsoids and boxes, turning, across the seam of a periodic box; pull-off forces; bridges.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

#include "tests/libdem/laws_in_loop.h"

namespace dem {
namespace {

using law_loop::Meeting;
using law_loop::Shape;

// Never yields, lets a bond go where its law alone says.
MaterialSpec elastic() {
  MaterialSpec m = law_loop::material();
  m.restitution = 1;
  m.yield_pressure = 0;
  return m;
}

double range_of(const Meeting& m) {
  return law_model_of(m.scene.law).range(m.pair, law_options_of(m.scene.law), m.radius_eff);
}

class Bonds : public testing::TestWithParam<std::tuple<std::size_t, int, bool>> {
 protected:
  Meeting meeting() const {
    return Meeting(law_loop::every_law()[std::get<0>(GetParam())], elastic(),
                   static_cast<Shape>(std::get<1>(GetParam())), std::get<2>(GetParam()));
  }
};

struct Parting {
  double held = 0, apart = 0;  // gaps: the last one that was held across, the first that was not, m
  double speed = 0;            // m/s
  std::uint64_t steps = 0;
};

Parting part(const Scene& s, const Meeting& m, int most = 100000) {
  World w = build_world(s);
  Parting p;
  bool met = false;
  for (int i = 0; i < most; ++i) {
    advance(w, 1);
    const bool holds = !touching_contacts(w).empty();
    if (met && !holds) {
      p.apart = m.gap(w);
      p.speed = m.speed(w);
      p.steps = w.step;
      return p;
    }
    met = met || holds;
    if (holds) p.held = m.gap(w);
  }
  ADD_FAILURE() << (met ? "never parted" : "never met");
  return p;
}

// At a speed at which the bodies cross the range in some 30 steps.
TEST_P(Bonds, LetGoAtTheGapOfTheirLawWhateverTheListDoes) {
  Meeting m = meeting();
  const double range = range_of(m), speed = 0.3;
  ASSERT_GT(range, 0);
  m.scene.run.dt_auto = false;
  m.scene.run.dt = std::min(m.duration(speed) / 50, range / speed / 30);
  m.approach(speed, 2 * m.scene.run.dt);
  const Parting p = part(m.scene, m);
  std::printf("  range %.6e m, held at %.6e m, apart at %.6e m\n", range, p.held, p.apart);
  EXPECT_LT(p.held, range);
  EXPECT_GE(p.apart, range * (1 - 1e-9));
  Scene s = m.scene;
  for (const double skin : {1e-9, 0.3}) {
    s.run.skin = skin * law_loop::radius;
    for (const std::uint64_t every : {0u, 1u, 5u}) {
      s.run.rebuild_every = every;
      const Parting other = part(s, m);
      EXPECT_EQ(other.steps, p.steps) << "skin " << skin << ", rebuilt every " << every;
      EXPECT_EQ(other.apart, p.apart);
      EXPECT_EQ(other.speed, p.speed);
    }
  }
}

std::string name_of(const testing::TestParamInfo<std::tuple<std::size_t, int, bool>>& p) {
  const auto& [law, shape, wall] = p.param;
  return law_loop::test_name(law_loop::every_law()[law]) + "_" + law_loop::shape_names[shape] +
         (wall ? "_on_a_plane" : "_pair");
}

INSTANTIATE_TEST_SUITE_P(Every, Bonds,
                         testing::Combine(testing::ValuesIn(law_loop::laws_that_hold_on()), testing::Range(0, 3),
                                          testing::Bool()),
                         name_of);

class Bond : public testing::TestWithParam<std::size_t> {
 protected:
  LawSpec law() const { return law_loop::every_law()[GetParam()]; }
};

// A bonded pair that flies and turns through a periodic box and whose bond is stretched and let back again: neither the
// seam nor a rebuild of the list parts them, and the bits are those of any list.
TEST_P(Bond, HoldsWhileThePairFliesAndTurnsAcrossTheSeamOfABox) {
  for (const Shape shape : {Shape::sphere, Shape::ellipsoid, Shape::box}) {
    Meeting m(law(), elastic(), shape, false);
    Scene s = m.scene;
    const double box = 12 * law_loop::radius, range = range_of(m);
    s.periodic.axes = "xyz";
    s.periodic.upper = {box, box, box};
    s.run.dt_fraction = 0.2;
    for (BodySpec& b : s.bodies) {
      b.position.z *= 1 - 1e-6;  // bonded from the start
      b.position += Vec3d{0.9 * box, 0.5 * box, 0.95 * box};
    }
    // The widest gap on their way, m; 1 when they part.
    const auto fly = [&](const RunSpec& run, double apart, World& w) {
      Scene thrown = s;
      thrown.run = run;
      for (BodySpec& b : thrown.bodies) {
        const double arm = b.position.z - 0.95 * box, spin = 60;
        b.velocity = {3 + spin * arm, -1, 5 + (arm > 0 ? 0.5 : -0.5) * apart};
        b.spin = {0, spin, 0};
      }
      w = build_world(thrown);
      double widest = -1;
      for (int i = 0; i < 2500; ++i) {
        advance(w, 1);
        const auto held = touching_contacts(w);
        if (held.empty()) return 1.0;
        widest = std::max(widest, -held[0].overlap);
      }
      return widest;
    };
    World held, other;
    double low = 0, high = 1;
    while (high - low > 0.01 * high) (fly(s.run, 0.5 * (low + high), held) < 1 ? low : high) = 0.5 * (low + high);
    const double widest = fly(s.run, low, held);
    std::printf("  %s: thrown apart at %.4g m/s, up to %.3g of the range; %llu rebuilds\n",
                law_loop::shape_names[static_cast<int>(shape)], low, widest / range,
                static_cast<unsigned long long>(held.counters.rebuilds));
    EXPECT_GT(widest, 0.1 * range);
    EXPECT_LT(widest, range);
    EXPECT_GT(held.counters.rebuilds, 3u);
    RunSpec run = s.run;
    run.rebuild_every = 1;
    EXPECT_EQ(fly(run, low, other), widest);
    EXPECT_EQ(state_hash(other), state_hash(held));
    run.skin = 1e-9 * law_loop::radius;
    EXPECT_EQ(fly(run, low, other), widest);
    EXPECT_EQ(state_hash(other), state_hash(held));
  }
}

INSTANTIATE_TEST_SUITE_P(Every, Bond, testing::ValuesIn(law_loop::laws_that_hold_on()),
                         [](const auto& p) { return law_loop::test_name(law_loop::every_law()[p.param]); });

// A ball bonded to a ceiling, its weight raised slowly: it falls at the pull-off force.
double pull_off(const LawSpec& law, Shape shape) {
  MaterialSpec material = elastic();
  material.restitution = 0.3;
  Meeting m(law, material, shape, true);
  m.scene.bodies[0].position.z = m.half * (1 - 1e-4);
  World w = build_world(m.scene);
  const auto run = [&](int steps) {
    for (int i = 0; i < steps; ++i) advance(w, 1);
  };
  run(3000);
  EXPECT_EQ(touching_contacts(w).size(), 1u);
  const double guess = 2 * std::numbers::pi * m.pair.work_of_adhesion * m.radius_eff;
  const double part = 0.0025 * guess;
  double pull = 0.5 * guess;
  while (pull < 2 * guess && !touching_contacts(w).empty()) {
    pull += part;
    w.scene.gravity.z = pull / m.mass;
    run(700);
  }
  pull -= 0.5 * part;
  return pull / (m.pair.work_of_adhesion * m.radius_eff * std::numbers::pi);
}

TEST(PullOff, IsThatOfTheTheories) {
  LawSpec jkr = law_loop::combination(LawName::hertz_mindlin);
  jkr.normal = "jkr";
  for (const Shape shape : {Shape::sphere, Shape::ellipsoid, Shape::box}) {
    EXPECT_NEAR(pull_off(jkr, shape), 1.5, 0.012);
    EXPECT_NEAR(pull_off(law_loop::combination(LawName::dmt), shape), 2, 0.016);
  }
}

}  // namespace
}  // namespace dem
