// Every listed method over every dimension of the extremes, against the reference in 50 digits.
#include <gtest/gtest.h>

#include <cmath>
#include <string_view>

#include "tests/extremes/dimensions.h"
#include "tests/libcontact/catalogue.h"

namespace {

using namespace extremes;

// Of every level. Approximate methods of potential particles, whose reference costs most, get one.
int cases_of(const contact::MethodInfo& m) {
  const bool dear = m.a == shapes::Kind::potential_particle || m.b == shapes::Kind::potential_particle;
  return dear && !m.exact ? 1 : 4;
}

class Extremes : public testing::TestWithParam<contact::MethodInfo> {};

TEST_P(Extremes, hold_or_say_so) {
  for (const Dimension& dimension : dimensions())
    each_case(dimension, GetParam().a, GetParam().b, cases_of(GetParam()), [&](const Case& c, double level) {
      SCOPED_TRACE(testing::Message() << dimension.name << " " << level);
      const contact::Contact got = ask(c, GetParam().name);
      const Outcome o = judge(c, got);
      EXPECT_NE(o.verdict, Verdict::wrong) << "error " << o.error << ", width " << o.width << " eps L";
      EXPECT_EQ(o.verdict == Verdict::refused, !dimension.answered);
      EXPECT_TRUE(scales(c, GetParam().name, got));
    });
}

// Nearly parallel edges apart: their cross product has lost what the tilt is short of, their points have not.
TEST(Extremes, edges_at_any_angle_hold) {
  for (const Dimension& dimension : dimensions())
    if (std::string_view(dimension.name) == "edge_tilt")
      each_case(dimension, shapes::Kind::polyhedron, shapes::Kind::polyhedron, 60, [](const Case& c, double level) {
        const Outcome o = judge(c, ask(c, "sat"));
        EXPECT_EQ(o.verdict, Verdict::holds) << level << ": error " << o.error << ", width " << o.width << " eps L";
      });
}

// Matrices that turn nothing are the caller's mistake (libcontact/dispatch.h): no bound then holds, but every query
// ends, and what it answers are numbers.
TEST_P(Extremes, matrices_that_are_no_rotations_end_in_numbers) {
  const shapes::Mat3d wrong[] = {{{{1, 1e-3, 0}, {0, 1, 0}, {0, 0, 1}}},
                                 {{{1, 1, 1}, {0, 1, 0}, {0, 0, -1}}},
                                 {{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}},
                                 {{{1e10, 0, 0}, {0, 1e-10, 0}, {0, 0, 1}}},
                                 {{{1e300, 1e300, 0}, {-1e300, 1e300, 0}, {0, 0, 1e300}}}};
  each_case(dimensions().front(), GetParam().a, GetParam().b, cases_of(GetParam()), [&](const Case& c, double) {
    const auto ends_in_numbers = [&](const contact::Body& a, const contact::Body& b) {
      contact::Contact got;
      contact::find(a.kind, b.kind, GetParam().name)(1, &a, &b, &c.offset, {}, nullptr, &got);
      return got.status == contact::Status::refused ||
             !(std::isnan(got.gap) || std::isnan(got.gap_lower) || std::isnan(got.gap_upper));
    };
    for (const shapes::Mat3d& m : wrong) {
      contact::Body a = c.a.placed(), b = c.b.placed();
      a.rotation = m;
      EXPECT_TRUE(ends_in_numbers(a, b)) << m.row[0].x << " " << m.row[0].y;
      b.rotation = m;
      EXPECT_TRUE(ends_in_numbers(a, b)) << m.row[0].x << " " << m.row[0].y;
      a = c.a.placed();
      EXPECT_TRUE(ends_in_numbers(a, b)) << m.row[0].x << " " << m.row[0].y;
    }
  });
}

// The judge is not asleep: an interval that is moved by more than its width is found out.
TEST_P(Extremes, a_shifted_answer_is_wrong) {
  each_case(dimensions().front(), GetParam().a, GetParam().b, cases_of(GetParam()), [&](const Case& c, double) {
    contact::Contact got = ask(c, GetParam().name);
    const double shift = got.gap_upper - got.gap_lower + 64 * contact::epsilon * c.extent();
    got.gap += shift;
    got.gap_lower += shift;
    got.gap_upper += shift;
    EXPECT_EQ(judge(c, got).verdict, Verdict::wrong);
  });
}

INSTANTIATE_TEST_SUITE_P(Catalogue, Extremes, testing::ValuesIn(catalogue::of_own_methods()), catalogue::entry_name);

}  // namespace
