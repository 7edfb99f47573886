// Methods by other libraries: closed forms, what they say beside the exact methods, and that nothing is silent.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "libcontact/methods/other_libraries.h"
#include "shapes/polyhedron_build.h"
#include "tests/libcontact/catalogue.h"
#include "tests/libcontact/random_cases.h"

namespace {

using namespace contact;
using namespace random_cases;

std::vector<MethodInfo> by_other_libraries() {
  std::vector<MethodInfo> list(methods_begin(), methods_end());
  std::erase_if(list, [](const MethodInfo& m) { return m.cost_rank < first_rank_of_other_libraries; });
  return list;
}

// Its overlap is the radius of a ball or a chord, at most the depth along its normal.
bool measures_less(const MethodInfo& m) { return m.name == "nlopt"; }

class Independent : public testing::TestWithParam<MethodInfo> {};

// Where a method says that it has converged, its verdict is that of the exact method, and the overlap that it measures
// is not below the least translation but for its tolerance, or no more than that along its normal.
TEST_P(Independent, its_verdict_is_right_and_its_overlap_no_less_than_the_true_one) {
  const MethodInfo& m = GetParam();
  Draw draw;
  int overlapping = 0;
  for (int i = 0; i < 200; ++i) {
    const Case c = random_case(m, draw);
    SCOPED_TRACE("case " + std::to_string(i));
    const Contact r = query(c.a, c.b, c.offset, {}, m.name), exact = query(c.a, c.b, c.offset);
    const double tolerance = 1e-3 * c.extent();
    if (r.status == Status::not_converged || std::abs(exact.gap) < tolerance) continue;
    EXPECT_EQ(r.method_overlap > 0, exact.gap < 0) << r.method_overlap << " " << exact.gap;
    overlapping += exact.gap < 0;
    if (!measures_less(m)) {
      EXPECT_GE(r.method_overlap, -exact.gap - tolerance);
    } else if (exact.gap < 0) {
      EXPECT_LE(r.method_overlap, -r.gap + tolerance);
    }
  }
  EXPECT_GT(overlapping, 20);
}

TEST_P(Independent, automatic_choice_and_a_tolerance_never_pick_it) {
  const MethodInfo& m = GetParam();
  EXPECT_FALSE(m.exact);
  EXPECT_NE(choose(m.a, m.b)->name, m.name);
  EXPECT_EQ(m.reach, std::numeric_limits<double>::infinity());
  EXPECT_NE(m.remark.find("independent; allocates"), std::string_view::npos);
}

INSTANTIATE_TEST_SUITE_P(Catalogue, Independent, testing::ValuesIn(by_other_libraries()), catalogue::entry_name);
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(Independent);

// Two cubes that share a face's depth of 1/8: every method that answers polyhedra finds it.
TEST(Independent, cubes_that_overlap_by_an_eighth) {
  const shapes::Polyhedron cube = shapes::make_box({1, 1, 1});
  Body a, b;
  a.kind = b.kind = Kind::polyhedron;
  a.geometry = b.geometry = &cube;
  a.size = b.size = {1, 0, 0};
  for (const MethodInfo& m : by_other_libraries()) {
    if (m.a != Kind::polyhedron || m.b != Kind::polyhedron) continue;
    SCOPED_TRACE(m.name);
    const Contact c = query(a, b, {0.875, 0.0625, 0.03125}, {}, m.name);
    EXPECT_NE(c.status, Status::not_converged);
    EXPECT_NEAR(c.gap, -0.125, 1e-6);
    EXPECT_NEAR(c.normal.x, 1, 1e-6);
    EXPECT_NEAR(c.method_overlap, measures_less(m) ? 0.0625 : 0.125, 1e-6);
    EXPECT_NEAR(c.method_point.x, 0.4375, 0.0626);  // somewhere in the overlap
  }
}

}  // namespace
