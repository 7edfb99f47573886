// Every listed method over every dimension of the extremes, against the reference in 50 digits.
#include <gtest/gtest.h>

#include "tests/extremes/dimensions.h"
#include "tests/libcontact/catalogue.h"

namespace {

using namespace extremes;

constexpr int cases = 4;  // of every level

class Extremes : public testing::TestWithParam<contact::MethodInfo> {};

TEST_P(Extremes, hold_or_say_so) {
  for (const Dimension& dimension : dimensions())
    each_case(dimension, GetParam().a, GetParam().b, cases, [&](const Case& c, double level) {
      SCOPED_TRACE(testing::Message() << dimension.name << " " << level);
      const Outcome o = judge(c, ask(c, GetParam().name));
      EXPECT_NE(o.verdict, Verdict::wrong) << "error " << o.error << ", width " << o.width << " eps L";
      EXPECT_EQ(o.verdict == Verdict::refused, !dimension.answered);
    });
}

// The judge is not asleep: an interval that is moved by more than its width is found out.
TEST_P(Extremes, a_shifted_answer_is_wrong) {
  each_case(dimensions().front(), GetParam().a, GetParam().b, cases, [&](const Case& c, double) {
    contact::Contact got = ask(c, GetParam().name);
    const double shift = got.gap_upper - got.gap_lower + 64 * contact::epsilon * c.extent();
    got.gap += shift;
    got.gap_lower += shift;
    got.gap_upper += shift;
    EXPECT_EQ(judge(c, got).verdict, Verdict::wrong);
  });
}

INSTANTIATE_TEST_SUITE_P(Catalogue, Extremes, testing::ValuesIn(catalogue::of_whole_bodies()), catalogue::entry_name);

}  // namespace
