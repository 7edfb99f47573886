// tests/guard/child.h: what aborts, throws or hangs in a child process loses its own answer alone.
#include "tests/guard/child.h"

#include <gtest/gtest.h>

#include <csignal>
#include <stdexcept>

namespace {

TEST(Child, a_job_that_does_not_end_well_is_lost_alone) {
  const auto job = [](std::size_t i) {
    if (i == 1) throw std::runtime_error("no answer");
    if (i == 3) raise(SIGKILL);
    if (i == 5 || i == 6)
      for (volatile bool on = true; on;) {
      }
    if (i == 7) _exit(3);
    return 0.5 * static_cast<double>(i);
  };
  const auto answers = guard::in_child(9, 0.05, job);
  ASSERT_EQ(answers.size(), 9u);
  for (const std::size_t i : {0u, 2u, 4u, 8u}) EXPECT_EQ(answers[i], 0.5 * static_cast<double>(i));
  for (const std::size_t i : {1u, 3u, 5u, 6u, 7u}) EXPECT_FALSE(answers[i].has_value()) << i;
}

TEST(Child, no_job_no_answer) {
  EXPECT_TRUE(guard::in_child(0, 1, [](std::size_t) { return 0; }).empty());
}

}  // namespace
