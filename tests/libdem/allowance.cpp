// How far bodies may go before the list of candidates is made anew: by their speed, and for as long as costs least.
#include "libdem/broad_phase/allowance.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/libdem/scenes_in_code.h"

namespace dem {
namespace {

constexpr double radius = 0.01, speed = 2;
constexpr std::uint64_t resting = 40, steps = 2000;

// Balls at rest in a row, a fortieth of a radius apart, and one that flies over them out of reach.
Scene flight(double skin) {
  Scene s;
  s.materials = {scenes::material("soft", 1e6, 2500, 0.5, 0.5)};
  s.shapes = {scenes::sphere("ball", radius)};
  s.run.skin = skin;
  for (std::uint64_t i = 0; i < resting; ++i)
    s.bodies.push_back(scenes::body("ball", "soft", {2.025 * radius * static_cast<double>(i), 0, 0}));
  s.bodies.push_back(scenes::body("ball", "soft", {0, 0, 4 * radius}, {speed, 0, 0}));
  return s;
}

TEST(Allowance, ASkinThatIsGivenIsSharedEvenly) {
  const World w = scenes::run(flight(0.004), 10);
  for (const double a : w.contacts.allowance) EXPECT_EQ(a, 0.002);
}

TEST(Allowance, FastBodiesHaveMoreAndThoseAtRestWhatTheyHad) {
  const World w = scenes::run(flight(-1), steps);
  const std::size_t fast = scenes::place(w, resting);
  for (std::size_t i = 0; i < w.particles.count(); ++i) {
    if (i != fast) {
      EXPECT_EQ(w.contacts.allowance[i], 0.5 * w.skin);
    }
  }
  EXPECT_GT(w.contacts.allowance[fast], 2 * w.skin);
  EXPECT_LE(w.contacts.allowance[fast], radius);
}

TEST(Allowance, OneFastBodyDoesNotMakeTheListAnewAtEveryTurn) {
  const World tuned = scenes::run(flight(-1), steps);
  const World even = scenes::run(flight(tuned.skin), steps);
  EXPECT_EQ(state_hash(tuned), state_hash(even));
  EXPECT_LT(3 * tuned.counters.rebuilds, even.counters.rebuilds);
  EXPECT_GT(tuned.counters.rebuilds, 3u);  // it is made anew: the way is many allowances long
}

// n² (listed − touching) / steps is what a rebuild costs over what a step costs a pair, whatever the last list was
// like.
TEST(Allowance, TheListLastsAsLongAsCostsLeast) {
  const auto rebuild = [](double bodies, double listed, double spare, double lasted) {
    const double best = best_steps(bodies, listed, listed - spare, lasted);
    return best * best * spare / lasted;
  };
  const double expected = rebuild(1000, 5000, 1000, 20);
  for (const double spare : {400.0, 2500.0, 4000.0})
    for (const double lasted : {10.0, 20.0, 50.0})
      EXPECT_NEAR(rebuild(1000, 5000, spare, lasted), expected, 1e-9 * expected);
  EXPECT_GT(rebuild(2000, 5000, 1000, 20), expected);
  EXPECT_GT(rebuild(1000, 6000, 1000, 20), expected);
  EXPECT_GE(best_steps(1, 1e9, 0, 1e-3), 1);                      // a step at least
  EXPECT_TRUE(std::isfinite(best_steps(1000, 2000, 2000, 1e9)));  // nothing to spare
}

}  // namespace
}  // namespace dem
