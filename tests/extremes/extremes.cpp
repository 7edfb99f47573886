// Every listed method over every dimension of the extremes, against the reference in 50 digits.
#include <gtest/gtest.h>

#include "tests/extremes/dimensions.h"

namespace {

using namespace extremes;

class Extremes : public testing::TestWithParam<contact::MethodInfo> {
 protected:
  // Four cases of every level.
  template <class Check>
  void each_case(const Dimension& dimension, Check check) const {
    const contact::MethodInfo& m = GetParam();
    for (std::size_t level = 0; level < dimension.levels.size(); ++level) {
      reference::Source draw(1000 * level + 16 * static_cast<unsigned>(m.a) + static_cast<unsigned>(m.b));
      for (int i = 0; i < 4; ++i) {
        Case c;
        if (!dimension.make(dimension.levels[level], m.a, m.b, draw, c)) continue;
        SCOPED_TRACE(testing::Message() << dimension.name << " " << dimension.levels[level] << " #" << i);
        check(c);
      }
    }
  }
};

TEST_P(Extremes, hold_or_say_so) {
  for (const Dimension& dimension : dimensions())
    each_case(dimension, [&](const Case& c) {
      const Outcome o = judge(c, ask(c, GetParam().name));
      EXPECT_NE(o.verdict, Verdict::wrong) << "error " << o.error << ", width " << o.width << " eps L";
      EXPECT_EQ(o.verdict == Verdict::refused, !dimension.answered);
    });
}

// The judge is not asleep: an interval that is moved by more than its width is found out.
TEST_P(Extremes, a_shifted_answer_is_wrong) {
  each_case(dimensions().front(), [&](const Case& c) {
    contact::Contact got = ask(c, GetParam().name);
    const double shift = got.gap_upper - got.gap_lower + 64 * contact::epsilon * c.extent();
    got.gap += shift;
    got.gap_lower += shift;
    got.gap_upper += shift;
    EXPECT_EQ(judge(c, got).verdict, Verdict::wrong);
  });
}

std::vector<contact::MethodInfo> methods_of_bodies() {
  std::vector<contact::MethodInfo> list(contact::methods_begin(), contact::methods_end());
  std::erase_if(list, [](const contact::MethodInfo& m) { return m.b == Kind::mesh; });
  return list;
}

INSTANTIATE_TEST_SUITE_P(Catalogue, Extremes, testing::ValuesIn(methods_of_bodies()), [](const auto& info) {
  return std::string(info.param.name) + "_" + name_of(info.param.a) + "_" + name_of(info.param.b);
});

}  // namespace
