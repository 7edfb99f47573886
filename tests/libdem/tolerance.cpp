// contact.tolerance: a run whose gaps are found to a tolerance is as repeatable as an exact one, and near it.
#include <gtest/gtest.h>

#include "libdem/forecast/warnings.h"
#include "tests/libdem/same_bits.h"

namespace dem {
namespace {

TEST(SceneTolerance, gives_the_same_bits_for_any_threads_skin_rebuild_and_resume) {
  for (const double tolerance : {1e-3, 1e-7}) {
    Scene s = scenes::every_shape(120);
    s.tolerance = tolerance;
    scenes::expect_same_bits(s, 400);
    s = scenes::bodies_of_parts(40);
    s.tolerance = tolerance;
    scenes::expect_same_bits(s, 400);
  }
}

TEST(SceneTolerance, a_finer_one_comes_nearer_to_the_exact_run) {
  Scene s = scenes::every_shape(120);
  constexpr std::uint64_t steps = 300;
  const World exact = scenes::run(s, steps);
  const auto off = [&](double tolerance) {
    s.tolerance = tolerance;
    const World w = scenes::run(s, steps);
    double most = 0;
    for (std::size_t i = 0; i < w.particles.count(); ++i)
      most = std::max(most, norm(w.particles.motion[i].position - exact.particles.motion[i].position));
    return most;
  };
  const double coarse = off(1e-3), fine = off(1e-9);
  EXPECT_LE(fine, 1e-3 * coarse);
  EXPECT_GT(coarse, 0);
}

TEST(SceneTolerance, one_of_a_large_part_of_the_overlap_is_warned_of) {
  Scene s = scenes::every_shape(120);
  const auto warned = [&](double tolerance) {
    s.tolerance = tolerance;
    const World w = build_world(s);
    forecast::PairForecast pair;
    pair.press_overlap = 1e-4;
    for (const std::string& text : forecast::dynamic_warnings(w, {}, {pair}))
      if (text.find("contact.tolerance") != std::string::npos) return true;
    return false;
  };
  EXPECT_TRUE(warned(6e-6));
  EXPECT_FALSE(warned(4e-6));
  EXPECT_FALSE(warned(0));
}

}  // namespace
}  // namespace dem
