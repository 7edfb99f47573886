// The table from pairs of kinds to methods, and its doors.
#include "libcontact/dispatch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace {

using namespace contact;
using shapes::Kind;

Body sphere(double radius) {
  Body b;
  b.size = {radius, 0, 0};
  return b;
}
Body ellipsoid(const Vec3d& axes) {
  Body b;
  b.kind = Kind::ellipsoid;
  b.size = axes;
  return b;
}

TEST(Dispatch, catalogue_is_in_kind_order_then_by_cost) {
  ASSERT_NE(methods_begin(), methods_end());
  for (const MethodInfo* m = methods_begin(); m != methods_end(); ++m) {
    EXPECT_LE(m->a, m->b);
    EXPECT_FALSE(m->remark.empty());
    EXPECT_NE(find(m->a, m->b, m->name), nullptr);
    if (m + 1 == methods_end()) break;
    const auto key = [](const MethodInfo& x) { return std::tuple(x.a, x.b, x.cost_rank); };
    EXPECT_LE(key(*m), key(m[1]));
  }
}

TEST(Dispatch, every_pair_of_particles_and_every_particle_against_a_wall_is_answered) {
  for (const Kind particle : {Kind::sphere, Kind::ellipsoid, Kind::polyhedron, Kind::rounded_polyhedron})
    for (const Kind other :
         {Kind::sphere, Kind::ellipsoid, Kind::polyhedron, Kind::rounded_polyhedron, Kind::plane, Kind::mesh})
      EXPECT_EQ(find(particle, other) != nullptr, particle <= other) << name_of(particle) << " " << name_of(other);
  EXPECT_EQ(find(Kind::plane, Kind::mesh), nullptr);
  for (const Kind other : {Kind::sphere, Kind::ellipsoid, Kind::polyhedron, Kind::rounded_polyhedron})
    EXPECT_NE(find(other, Kind::potential_particle), nullptr);
  for (const Kind other : {Kind::potential_particle, Kind::plane, Kind::mesh})
    EXPECT_NE(find(Kind::potential_particle, other), nullptr);
  for (const Kind particle : {Kind::disc, Kind::ellipse, Kind::polygon}) {
    for (const Kind other : {Kind::disc, Kind::ellipse, Kind::polygon, Kind::line})
      EXPECT_EQ(find(particle, other) != nullptr, particle <= other) << name_of(particle) << " " << name_of(other);
    EXPECT_EQ(find(Kind::sphere, particle), nullptr);  // the two dimensions never meet
  }
}

TEST(Dispatch, automatic_choice_is_the_cheapest_certified_exact_method) {
  for (const MethodInfo* m = methods_begin(); m != methods_end(); ++m) {
    const auto first = [&](bool certified) {
      return std::find_if(methods_begin(), methods_end(), [&](const MethodInfo& x) {
        return x.a == m->a && x.b == m->b && x.exact && (x.certified || !certified);
      });
    };
    const MethodInfo* best = first(true) != methods_end() ? first(true) : first(false);
    ASSERT_NE(best, methods_end());  // no pair is left to approximate methods alone
    EXPECT_EQ(choose(m->a, m->b), best);
    EXPECT_EQ(find(m->a, m->b), find(m->a, m->b, best->name));
  }
}

TEST(Dispatch, an_approximate_method_acts_by_its_own_measure_where_that_is_asked) {
  const Body a = ellipsoid({1, 2, 3}), b = ellipsoid({1, 0.5, 2});
  const Vec3d offset{1.2, 1.1, 0.75};
  int approximate = 0;
  for (const MethodInfo* m = methods_begin(); m != methods_end(); ++m) {
    if (m->a != Kind::ellipsoid || m->b != Kind::ellipsoid) continue;
    Contact plain, own;
    find(m->a, m->b, m->name)(1, &a, &b, &offset, {}, nullptr, &plain);
    find_own_measure(m->a, m->b, m->name)(1, &a, &b, &offset, {}, nullptr, &own);
    approximate += !m->exact;
    EXPECT_EQ(own.gap, m->exact ? plain.gap : -plain.method_overlap);
    EXPECT_TRUE(own.normal == (m->exact ? plain.normal : plain.method_normal));
    EXPECT_TRUE(own.patch.centre == (m->exact ? plain.patch.centre : plain.method_point));
    EXPECT_EQ(own.gap_lower, plain.gap_lower);
  }
  EXPECT_GE(approximate, 3);
  EXPECT_EQ(find_own_measure(Kind::sphere, Kind::sphere, "common_normal"), nullptr);
}

TEST(Dispatch, unknown_names_and_pairs_are_refused) {
  EXPECT_EQ(find(Kind::sphere, Kind::sphere, "no_such_method"), nullptr);
  EXPECT_EQ(find(Kind::ellipsoid, Kind::sphere), nullptr);  // not in kind order
  EXPECT_EQ(query(sphere(1), sphere(1), {1, 0, 0}, {}, "no_such_method").status, Status::refused);
  Body hollow;
  hollow.kind = Kind::polyhedron;
  hollow.size = {1, 0, 0};
  EXPECT_EQ(query(sphere(1), hollow, {1, 0, 0}).status, Status::refused);
  EXPECT_EQ(query(hollow, sphere(1), {1, 0, 0}).status, Status::refused);
}

TEST(Dispatch, bodies_against_kind_order_are_seen_from_the_first_one) {
  const Contact c = query(ellipsoid({1, 2, 3}), sphere(0.5), {1.25, 0, 0});
  EXPECT_DOUBLE_EQ(c.gap, -0.25);
  EXPECT_DOUBLE_EQ(c.normal.x, 1);
  EXPECT_DOUBLE_EQ(c.point_a.x, 1);
  EXPECT_DOUBLE_EQ(c.point_b.x, 0.75);
  EXPECT_DOUBLE_EQ(c.patch.centre.x, 0.875);
}

TEST(Dispatch, a_chunk_answers_each_pair_as_alone) {
  std::vector<Body> a, b;
  std::vector<Vec3d> offset;
  for (int i = 0; i < 9; ++i) {
    a.push_back(ellipsoid({1, 1 + 0.1 * i, 2}));
    b.push_back(ellipsoid({0.5, 1, 1.5 - 0.1 * i}));
    offset.push_back({1.0, 0.2 * i, 0.5});
  }
  std::vector<Contact> out(a.size());
  std::vector<Cache> cache(a.size());
  find(Kind::ellipsoid, Kind::ellipsoid)(a.size(), a.data(), b.data(), offset.data(), {}, cache.data(), out.data());
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Contact alone = query(a[i], b[i], offset[i]);
    EXPECT_EQ(out[i].gap, alone.gap);
    EXPECT_TRUE(out[i].normal == alone.normal);
    EXPECT_EQ(out[i].status == Status::separated, !(cache[i].axis == Vec3d{}));
  }
}

}  // namespace
