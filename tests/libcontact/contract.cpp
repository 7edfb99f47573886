// The contract of contact.h, tested over every method and pair of kinds in the catalogue: a new method is tested by
// being listed. Bodies are random; the pairs run from apart to deep. Of approximate methods: bounds instead of digits.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/libcontact/catalogue.h"
#include "tests/libcontact/random_cases.h"

namespace {

using namespace contact;
using namespace random_cases;
using shapes::Kind;

Contact run(const MethodInfo& m, const Case& c, const Options& options = {}, Cache* cache = nullptr) {
  Contact out;
  find(m.a, m.b, m.name)(1, &c.a, &c.b, &c.offset, options, cache, &out);
  return out;
}

// The case with A and B exchanged, asked through the door that takes any order.
Contact run_swapped(const MethodInfo& m, const Case& c) { return query(c.b, c.a, -c.offset, {}, m.name); }

bool sized_by_scale(Kind k) {
  return k == Kind::polyhedron || k == Kind::potential_particle || k == Kind::polygon || k == Kind::mesh;
}

Case scaled_case(Case c, double s) {
  for (Body* b : {&c.a, &c.b}) b->size = sized_by_scale(b->kind) ? Vec3d{b->size.x * s, 0, 0} : b->size * s;
  c.offset *= s;
  return c;
}

// A facet of a mesh may leave a body to its neighbours: then it answers "separated" without points or upper bound.
bool left_to_others(const MethodInfo& m, const Contact& c) {
  return m.b == Kind::mesh && c.status == Status::separated && std::isinf(c.gap_upper);
}

class Contract : public testing::TestWithParam<MethodInfo> {
 protected:
  template <class Check>
  void each_case(int count, Check check) {
    Draw draw;
    for (int i = 0; i < count; ++i) {
      const Case c = random_case(GetParam(), draw);
      SCOPED_TRACE("case " + std::to_string(i));
      check(c, draw);
      if (HasFatalFailure()) return;
    }
  }
};

constexpr int cases = 200;

TEST_P(Contract, an_answer_is_consistent) {
  int overlapping = 0, separated = 0;
  each_case(cases, [&](const Case& c, Draw&) {
    const Contact r = run(GetParam(), c);
    if (GetParam().exact) {
      ASSERT_TRUE(r.status == Status::separated || r.status == Status::touching || r.status == Status::overlapping);
    }
    ASSERT_NE(r.status, Status::refused);
    if (r.status == Status::not_converged) return;  // its bounds are tested below
    if (left_to_others(GetParam(), r)) {
      ++separated;
      return;
    }
    overlapping += r.status == Status::overlapping;
    separated += r.status == Status::separated;
    const double tolerance = 64 * epsilon * c.extent();
    EXPECT_LE(r.gap_lower, r.gap);
    EXPECT_LE(r.gap, r.gap_upper);
    if (GetParam().exact) {
      EXPECT_LE(r.gap_upper - r.gap_lower, 4 * tolerance);
      EXPECT_NEAR(norm(r.point_b - r.point_a), std::abs(r.gap), tolerance);
    }
    EXPECT_EQ(r.status == Status::separated, r.gap_lower > 0);
    EXPECT_EQ(r.status == Status::overlapping, r.gap_upper < 0);
    EXPECT_NEAR(norm(r.normal), 1, 8 * epsilon);
    EXPECT_NEAR(dot(r.point_b - r.point_a, r.normal), r.gap, tolerance);
    EXPECT_LE(norm(r.patch.centre), 2 * c.extent());
    EXPECT_TRUE(r.certified || !GetParam().certified);
  });
  EXPECT_GT(overlapping, cases / 20);
  EXPECT_GT(separated, cases / 20);
}

// Own measures are finite, and proven bounds of an approximate method hold the exact answer, converged or not.
TEST_P(Contract, the_bounds_hold_the_answer_of_the_exact_method) {
  int converged = 0;
  each_case(cases, [&](const Case& c, Draw&) {
    const Contact r = run(GetParam(), c), exact = query(c.a, c.b, c.offset);
    if (left_to_others(GetParam(), r)) return;
    converged += r.status != Status::not_converged;
    EXPECT_LE(r.gap_lower, exact.gap_upper);
    EXPECT_TRUE(!r.certified || exact.gap_lower <= r.gap_upper);
    EXPECT_TRUE(std::isfinite(r.method_overlap));
    EXPECT_NEAR(norm(r.method_normal), 1, 8 * epsilon);
    EXPECT_LE(norm(r.method_point), 2 * c.extent());
    if (!r.handed_over) return;
    EXPECT_FALSE(GetParam().exact);
    EXPECT_EQ(r.gap, exact.gap);
    EXPECT_EQ(r.method_overlap, exact.method_overlap);
  });
  EXPECT_TRUE(GetParam().b == Kind::mesh || converged >= (GetParam().exact ? cases : cases * 9 / 10)) << converged;
}

TEST_P(Contract, swapping_the_bodies_flips_the_normal) {
  each_case(cases, [&](const Case& c, Draw&) {
    const Contact r = run(GetParam(), c), s = run_swapped(GetParam(), c);
    EXPECT_EQ(r.status, s.status);
    EXPECT_EQ(r.gap, s.gap);
    EXPECT_EQ(r.gap_lower, s.gap_lower);
    EXPECT_EQ(r.gap_upper, s.gap_upper);
    EXPECT_TRUE(s.normal == -r.normal);
    if (left_to_others(GetParam(), r)) return;
    const double tolerance = 64 * epsilon * c.extent();
    EXPECT_LE(norm(s.point_a + c.offset - r.point_b), tolerance);  // from the origin of the other body
    EXPECT_LE(norm(s.point_b + c.offset - r.point_a), tolerance);
    EXPECT_LE(norm(s.patch.centre + c.offset - r.patch.centre), tolerance);
  });
}

TEST_P(Contract, a_rigid_motion_keeps_the_gap) {
  each_case(cases, [&](const Case& c, Draw& draw) {
    const Mat3d turn = random_rotation(c.a.kind, draw);
    Case moved = c;
    moved.a.rotation = turn * c.a.rotation;
    moved.b.rotation = turn * c.b.rotation;
    moved.offset = turn * c.offset;
    const Contact r = run(GetParam(), c), s = run(GetParam(), moved);
    // The motion itself rounds: its matrix to 4 eps, its products to 2 eps, of lengths up to the extent.
    const double tolerance = 64 * epsilon * c.extent();
    ASSERT_EQ(left_to_others(GetParam(), r), left_to_others(GetParam(), s));
    if (left_to_others(GetParam(), r)) return;
    if (GetParam().exact) {
      EXPECT_NEAR(r.gap, s.gap, tolerance);
    }
    EXPECT_LE(r.gap_lower, s.gap_upper);
    EXPECT_LE(s.gap_lower, r.gap_upper);
  });
}

TEST_P(Contract, powers_of_two_scale_every_bit) {
  each_case(40, [&](const Case& c, Draw&) {
    const Contact r = run(GetParam(), c);
    for (const int power : {-300, -30, 30, 300}) {
      const double s = std::ldexp(1.0, power);
      const Contact t = run(GetParam(), scaled_case(c, s));
      EXPECT_EQ(t.status, r.status);
      EXPECT_EQ(t.gap, r.gap * s);
      EXPECT_EQ(t.gap_lower, r.gap_lower * s);
      EXPECT_EQ(t.gap_upper, r.gap_upper * s);
      EXPECT_TRUE(t.normal == r.normal);
      EXPECT_TRUE(t.point_a == r.point_a * s);
      EXPECT_TRUE(t.point_b == r.point_b * s);
      EXPECT_TRUE(t.patch.centre == r.patch.centre * s);
      EXPECT_EQ(t.method_overlap, r.method_overlap * s);
      EXPECT_TRUE(t.method_normal == r.method_normal);
      EXPECT_TRUE(t.method_point == r.method_point * s);
    }
  });
}

TEST_P(Contract, the_same_query_gives_the_same_bits) {
  each_case(40, [&](const Case& c, Draw&) {
    Options bare;
    bare.patch = false;
    const Contact r = run(GetParam(), c), s = run(GetParam(), c), t = run(GetParam(), c, bare);
    EXPECT_EQ(r.gap, s.gap);
    EXPECT_TRUE(r.normal == s.normal && r.point_a == s.point_a && r.point_b == s.point_b);
    EXPECT_EQ(r.gap, t.gap);
    EXPECT_TRUE(r.normal == t.normal);
  });
}

TEST_P(Contract, moving_by_the_overlap_ends_the_contact) {
  each_case(cases, [&](const Case& c, Draw&) {
    const Contact r = run(GetParam(), c);
    if (r.status != Status::overlapping) return;
    Case apart = c;
    apart.offset += (-r.gap + 64 * epsilon * c.extent()) * r.normal;
    const Contact after = GetParam().exact ? run(GetParam(), apart) : query(apart.a, apart.b, apart.offset);
    EXPECT_NE(after.status, Status::overlapping);
    EXPECT_GE(after.gap, 0);
    if (!GetParam().exact) return;
    // And nothing shorter along the normal does.
    apart.offset = c.offset + (-r.gap * 0.999 - 64 * epsilon * c.extent()) * r.normal;
    const Contact nearly = run(GetParam(), apart);
    // About a ridge the last of the way, the radius, may be the neighbour's.
    if (c.a.kind == Kind::rounded_polyhedron && left_to_others(GetParam(), nearly)) return;
    EXPECT_LT(nearly.gap, 0);
  });
}

// A stop at the first proof and a cached axis, right or wrong, change no verdict.
TEST_P(Contract, a_cache_is_only_a_proof) {
  each_case(cases, [&](const Case& c, Draw& draw) {
    Options quick;
    quick.overlap_only = true;
    const Contact full = run(GetParam(), c);
    Cache none, kept, wrong{normalized(random_vector(c.a.kind, draw))};
    const Contact first = run(GetParam(), c, quick, &none);
    run(GetParam(), c, {}, &kept);
    const Contact again = run(GetParam(), c, quick, &kept), misled = run(GetParam(), c, quick, &wrong);
    for (const Contact& r : {first, again, misled}) {
      EXPECT_EQ(r.status == Status::separated, full.status == Status::separated);
      if (full.status == Status::separated) {
        EXPECT_LE(r.gap_lower, full.gap_upper);
        EXPECT_TRUE(r.gap_lower > 0 || left_to_others(GetParam(), r));
      } else {
        EXPECT_EQ(r.status, full.status);
        EXPECT_EQ(r.gap, full.gap);
        EXPECT_TRUE(r.normal == full.normal);
      }
    }
    EXPECT_TRUE(full.status != Status::overlapping || kept.axis == (Vec3d{0, 0, 0}));
  });
}

TEST_P(Contract, bad_numbers_are_refused) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  each_case(5, [&](const Case& good, Draw&) {
    for (const double bad : {nan, infinity, -infinity}) {
      for (int i = 0; i < 3; ++i) {
        Case c = good;
        c.offset[i] = bad;
        EXPECT_EQ(run(GetParam(), c).status, Status::refused);
      }
    }
    for (const double bad : {nan, infinity, 0.0, -1.0}) {
      for (Body Case::*which : {&Case::a, &Case::b}) {
        const Kind kind = (good.*which).kind;
        if (kind == Kind::plane || kind == Kind::line) continue;
        const int sizes = kind == Kind::ellipsoid                                     ? 3
                          : kind == Kind::ellipse || kind == Kind::rounded_polyhedron ? 2
                                                                                      : 1;
        for (int i = 0; i < sizes; ++i) {
          Case c = good;
          (c.*which).size[i] = bad;
          EXPECT_EQ(run(GetParam(), c).status, Status::refused);
        }
      }
    }
    for (const double bad : {nan, infinity}) {
      for (Body Case::*which : {&Case::a, &Case::b}) {
        const Kind kind = (good.*which).kind;
        if (kind == Kind::sphere || kind == Kind::disc) continue;
        Case c = good;
        (c.*which).rotation.row[1][!is_flat(kind) ? 2 : kind == Kind::line ? 1 : 0] = bad;
        EXPECT_EQ(run(GetParam(), c).status, Status::refused);
      }
    }
  });
}

INSTANTIATE_TEST_SUITE_P(Catalogue, Contract, testing::ValuesIn(methods_begin(), methods_end()), catalogue::entry_name);

}  // namespace
