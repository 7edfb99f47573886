// Options::tolerance: the interval that was asked for, from the cheapest method that reaches it; what it leaves wider
// goes on to the next, and says so. Over every pair of kinds in the catalogue, and over lists made for it.
#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "libcontact/extend.h"
#include "tests/libcontact/catalogue.h"
#include "tests/libcontact/random_cases.h"

namespace {

using namespace contact;
using namespace random_cases;

double size_of(const Case& c) {
  const double b = is_wall(c.b.kind) ? circumradius(c.a) : circumradius(c.b);
  return std::min(circumradius(c.a), b);
}

std::vector<MethodInfo> pairs() {
  std::vector<MethodInfo> list(methods_begin(), methods_end());
  std::erase_if(list, [](const MethodInfo& m) { return choose(m.a, m.b)->name != m.name; });
  return list;
}

class Tolerance : public testing::TestWithParam<MethodInfo> {};

TEST_P(Tolerance, the_interval_is_as_narrow_as_asked_and_holds_the_exact_one) {
  const MethodInfo& m = GetParam();
  Draw draw;
  for (int i = 0; i < 100; ++i) {
    const Case c = random_case(m, draw);
    SCOPED_TRACE("case " + std::to_string(i));
    Contact exact;
    find(m.a, m.b)(1, &c.a, &c.b, &c.offset, {}, nullptr, &exact);
    for (const double tolerance : {1e-2, 1e-4, 1e-6, 1e-9}) {
      Options wanted;
      wanted.tolerance = tolerance;
      Contact r;
      find(m.a, m.b, "auto", wanted.tolerance)(1, &c.a, &c.b, &c.offset, wanted, nullptr, &r);
      ASSERT_NE(r.status, Status::refused);
      EXPECT_LE(r.gap_lower, r.gap);
      EXPECT_LE(r.gap, r.gap_upper);
      EXPECT_LE(r.gap_lower, exact.gap_upper);
      EXPECT_TRUE(!r.certified || !exact.certified || exact.gap_lower <= r.gap_upper);
      EXPECT_TRUE(r.certified || !exact.certified);
      if (std::isinf(r.gap_upper)) continue;  // a facet that leaves the body to others
      EXPECT_TRUE(!r.certified || r.gap_upper - r.gap_lower <= tolerance * size_of(c))
          << (r.gap_upper - r.gap_lower) / size_of(c);
      if (m.b == Kind::mesh) continue;  // whose order is fixed
      const Contact back = query(c.b, c.a, -c.offset, wanted);
      EXPECT_EQ(back.gap, r.gap);
      EXPECT_TRUE(back.normal == -r.normal);
    }
  }
}

// A search that stops early still finds apart what a proof finds apart: by `gap_upper < 0`, as a run asks.
TEST_P(Tolerance, a_cached_proof_contradicts_no_overlap) {
  const MethodInfo& m = GetParam();
  Draw draw;
  Options wanted;
  wanted.overlap_only = true;
  wanted.tolerance = 1e-3;
  for (int i = 0; i < 100; ++i) {
    const Case c = random_case(m, draw);
    Cache kept, none;
    Contact first, cold, cached;
    find(m.a, m.b)(1, &c.a, &c.b, &c.offset, {}, &kept, &first);
    find(m.a, m.b, "auto", wanted.tolerance)(1, &c.a, &c.b, &c.offset, wanted, &none, &cold);
    find(m.a, m.b, "auto", wanted.tolerance)(1, &c.a, &c.b, &c.offset, wanted, &kept, &cached);
    EXPECT_EQ(cold.gap_upper < 0, cached.gap_upper < 0);
    if (!(cold.gap_upper < 0)) continue;
    EXPECT_EQ(cold.gap, cached.gap);
    EXPECT_TRUE(cold.normal == cached.normal);
  }
}

TEST_P(Tolerance, a_chunk_gives_the_bits_of_single_queries) {
  const MethodInfo& m = GetParam();
  Draw draw;
  constexpr std::size_t n = 33;
  std::vector<Body> a, b;
  std::vector<Vec3d> offset;
  for (std::size_t i = 0; i < n; ++i) {
    const Case c = random_case(m, draw);
    a.push_back(c.a), b.push_back(c.b), offset.push_back(c.offset);
  }
  Options wanted;
  wanted.tolerance = 1e-6;
  std::vector<Contact> chunk(n);
  find(m.a, m.b, "auto", wanted.tolerance)(n, a.data(), b.data(), offset.data(), wanted, nullptr, chunk.data());
  for (std::size_t i = 0; i < n; ++i) {
    Contact one;
    find(m.a, m.b, "auto", wanted.tolerance)(1, &a[i], &b[i], &offset[i], wanted, nullptr, &one);
    EXPECT_EQ(chunk[i].gap, one.gap);
    EXPECT_EQ(chunk[i].gap_lower, one.gap_lower);
    EXPECT_EQ(chunk[i].gap_upper, one.gap_upper);
    EXPECT_EQ(chunk[i].handed_over, one.handed_over);
    EXPECT_TRUE(chunk[i].normal == one.normal);
  }
}

INSTANTIATE_TEST_SUITE_P(Catalogue, Tolerance, testing::ValuesIn(pairs()), catalogue::entry_name);

// Three methods of spheres: one that guesses within 1e-2, one within 1e-4 that gives up where y > 0, and the truth.
Contact ball(const Placed<shapes::Sphere>& a, const Placed<shapes::Sphere>& b, const Vec3d& offset, double half) {
  Contact c;
  c.gap = norm(offset) - a.radius - b.radius;
  c.gap_lower = c.gap - half, c.gap_upper = c.gap + half;
  c.status = c.gap_lower > 0 ? Status::separated : c.gap_upper < 0 ? Status::overlapping : Status::touching;
  c.certified = true;
  c.normal = normalized(offset);
  return c;
}
struct Guess {
  static constexpr const char *name = "guess", *remark = "within 1e-2";
  static constexpr int cost_rank = 1;
  static constexpr bool exact = false;
  static constexpr double reach = 1e-2;
  static Contact query(const Placed<shapes::Sphere>& a, const Placed<shapes::Sphere>& b, const Vec3d& offset,
                       const Options&, Cache*) {
    return ball(a, b, offset, 0.4e-2);
  }
};
struct Moody {
  static constexpr const char *name = "moody", *remark = "within 1e-4, or unproven";
  static constexpr int cost_rank = 2;
  static constexpr bool exact = false;
  static constexpr double reach = 1e-4;
  static Contact query(const Placed<shapes::Sphere>& a, const Placed<shapes::Sphere>& b, const Vec3d& offset,
                       const Options&, Cache*) {
    Contact c = ball(a, b, offset, 0.4e-4);
    c.certified = offset.y <= 0;
    return c;
  }
};
struct Truth {
  static constexpr const char *name = "truth", *remark = "exact";
  static constexpr int cost_rank = 3;
  static Contact query(const Placed<shapes::Sphere>& a, const Placed<shapes::Sphere>& b, const Vec3d& offset,
                       const Options&, Cache*) {
    return ball(a, b, offset, 0);
  }
};
using Three = Dispatch<std::tuple<shapes::Sphere>, std::tuple<Truth, Moody, Guess>>;

Contact ask(const Vec3d& offset, double tolerance) {
  Body a, b;
  a.size = {2, 0, 0};
  b.size = {1, 0, 0};  // the smaller one
  Options wanted;
  wanted.tolerance = tolerance;
  return Three::query(a, b, offset, wanted);
}

TEST(Escalation, the_cheapest_method_that_reaches_the_tolerance_answers) {
  const auto width = [](const Contact& c) { return c.gap_upper - c.gap_lower; };
  const Vec3d low{2.5, -0.5, 0}, high{2.5, 0.5, 0};
  EXPECT_NEAR(width(ask(low, 1e-2)), 0.8e-2, 1e-12);
  EXPECT_NEAR(width(ask(low, 1e-3)), 0.8e-4, 1e-12);  // Guess does not reach it
  EXPECT_EQ(width(ask(low, 1e-5)), 0);
  EXPECT_EQ(width(ask(low, 0)), 0);
  for (const double tolerance : {1e-2, 1e-3, 1e-5, 0.0}) EXPECT_FALSE(ask(low, tolerance).handed_over);
  EXPECT_NEAR(width(ask(high, 1e-2)), 0.8e-2, 1e-12);
  EXPECT_EQ(width(ask(high, 1e-3)), 0);  // Moody proves nothing here
  EXPECT_TRUE(ask(high, 1e-3).handed_over);
  EXPECT_FALSE(ask(high, 1e-5).handed_over);
}

TEST(Escalation, what_is_too_wide_goes_on) {
  // Relative to the smaller one: 0.8e-2 is too wide for a ball of half the radius, and Moody answers.
  Body a, b;
  a.size = {2, 0, 0};
  b.size = {0.5, 0, 0};
  Options wanted;
  wanted.tolerance = 1e-2;
  const Contact c = Three::query(a, b, {2, -0.5, 0}, wanted);
  EXPECT_TRUE(c.handed_over);
  EXPECT_NEAR(c.gap_upper - c.gap_lower, 0.8e-4, 1e-12);
  EXPECT_EQ(Three::choose(Kind::sphere, Kind::sphere)->name, "truth");
  EXPECT_EQ(Three::find(Kind::sphere, Kind::ellipsoid, "auto", 1e-2), nullptr);
}

}  // namespace
