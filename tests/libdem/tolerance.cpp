// contact.tolerance: a run whose gaps are found to a tolerance is as repeatable as an exact one.
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
