// Bodies of parts: what they become, however they were cut.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

#include "shapes/compound_build.h"
#include "shapes/geometry.h"
#include "shapes/polyhedron_build.h"
#include "tests/shapes/support.h"

namespace {

using namespace shapes;
using shape_tests::Random;
using Kind = Compound::PartKind;
constexpr double eps = 0x1p-52;

CompoundPart box(const Vec3d& lower, const Vec3d& upper) {
  return {make_box(upper - lower), {0.5 * (lower + upper), {}}};
}
CompoundPart hull(const std::vector<Vec3d>& points) { return {polyhedron_from_points(points, Frame::as_given), {}}; }
CompoundPart ball(const Vec3d& centre, double radius) { return {Sphere{radius}, {centre, {}}}; }

// A set of polyhedra by the corners of each, in the frame of the input, in an order of their own.
std::vector<std::vector<Vec3d>> corners(const Compound& body) {
  std::vector<std::vector<Vec3d>> all;
  for (const auto& p : body.parts) {
    std::vector<Vec3d> list;
    for (const Vec3d& v : p.solid->vertices) {
      Vec3d x = body.frame.position + rotate(body.frame.orientation, p.centre + v);
      for (int k = 0; k < 3; ++k) x[k] = std::round(x[k] * 1e10) / 1e10 + 0.0;
      list.push_back(x);
    }
    const auto before = [](const Vec3d& a, const Vec3d& b) {
      return a.x != b.x ? a.x < b.x : (a.y != b.y ? a.y < b.y : a.z < b.z);
    };
    std::sort(list.begin(), list.end(), before);
    all.push_back(list);
  }
  std::sort(all.begin(), all.end(), [](const auto& a, const auto& b) {
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end(), [](const Vec3d& x, const Vec3d& y) {
      return x.x != y.x ? x.x < y.x : (x.y != y.y ? x.y < y.y : x.z < y.z);
    });
  });
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

TEST(Compound, a_box_in_pieces_is_the_box) {
  const Vec3d size{2, 3, 1};
  const Polyhedron whole = make_box(size);
  const std::vector<std::vector<CompoundPart>> cuts{
      {box({-1, -1.5, -0.5}, {0.25, 1.5, 0.5}), box({0.25, -1.5, -0.5}, {1, 1.5, 0.5})},
      {hull({{-1, -1.5, -0.5}, {1, -1.5, -0.5}, {1, 1.5, -0.5}, {-1, -1.5, 0.5}, {1, -1.5, 0.5}, {1, 1.5, 0.5}}),
       hull({{-1, -1.5, -0.5}, {-1, 1.5, -0.5}, {1, 1.5, -0.5}, {-1, -1.5, 0.5}, {-1, 1.5, 0.5}, {1, 1.5, 0.5}})},
      // pieces that overlap, one inside the others
      {box({-1, -1.5, -0.5}, {0.5, 1.5, 0.5}), box({-0.5, -1.5, -0.5}, {1, 1.5, 0.5}),
       box({-0.2, 0, 0}, {0.2, 1, 0.3})},
      // a pinwheel about a core: no two pieces are convex together
      {box({-1, -1.5, -0.5}, {0.5, -0.5, 0.5}), box({0.5, -1.5, -0.5}, {1, 0.5, 0.5}),
       box({-0.5, 0.5, -0.5}, {1, 1.5, 0.5}), box({-1, -0.5, -0.5}, {-0.5, 1.5, 0.5}),
       box({-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5})}};
  for (const auto& parts : cuts) {
    const Compound body = make_compound(parts);
    ASSERT_EQ(body.parts.size(), 1u);
    const Polyhedron& p = *body.parts[0].solid;
    ASSERT_EQ(p.vertices.size(), 8u);
    EXPECT_EQ(p.faces.size(), 6u);
    EXPECT_EQ(body.mass_error, 0);
    EXPECT_NEAR(body.mass.volume / whole.mass.volume, 1, 8 * eps);
    for (const Vec3d& v : p.vertices) {
      EXPECT_NEAR(std::abs(v.x), 1, 4 * eps);
      EXPECT_NEAR(std::abs(v.y), 1.5, 4 * eps);
      EXPECT_NEAR(std::abs(v.z), 0.5, 4 * eps);
    }
  }
}

// An L in different cuts is the same body, two bars.
TEST(Compound, an_l_is_two_bars_however_it_is_cut) {
  const std::vector<std::vector<CompoundPart>> cuts{
      {box({0, 0, 0}, {3, 1, 1}), box({0, 1, 0}, {1, 3, 1})},
      {box({1, 0, 0}, {3, 1, 1}), box({0, 0, 0}, {1, 3, 1})},
      {box({0, 0, 0}, {1, 1, 1}), box({1, 0, 0}, {3, 1, 1}), box({0, 1, 0}, {1, 3, 1})},
      {box({0, 0, 0}, {3, 1, 1}), box({0, 0, 0}, {1, 3, 1})},                                           // overlapping
      {hull({{0, 0, 0}, {1, 1, 0}, {1, 3, 0}, {0, 3, 0}, {0, 0, 1}, {1, 1, 1}, {1, 3, 1}, {0, 3, 1}}),  // mitred
       hull({{0, 0, 0}, {1, 1, 0}, {3, 1, 0}, {3, 0, 0}, {0, 0, 1}, {1, 1, 1}, {3, 1, 1}, {3, 0, 1}})}};
  const Compound first = make_compound(cuts[0]);
  EXPECT_NEAR(first.mass.volume, 5, 16 * eps);
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(first.frame.position[k], k == 2 ? 0.5 : 1.1, 8 * eps);
  const auto bars = corners(first);
  ASSERT_EQ(bars.size(), 2u);
  for (const auto& parts : cuts) {
    const Compound body = make_compound(parts);
    EXPECT_EQ(body.mass_error, 0);
    EXPECT_NEAR(body.mass.volume, 5, 32 * eps);
    for (int k = 0; k < 3; ++k) {
      EXPECT_NEAR(body.frame.position[k], first.frame.position[k], 16 * eps);
      EXPECT_NEAR(body.mass.inertia.row[k][k], first.mass.inertia.row[k][k], 64 * eps * 10);
    }
    EXPECT_EQ(body.parts.size(), 2u);
    EXPECT_TRUE(corners(body) == bars) << "a cut into " << parts.size();
    EXPECT_FALSE(body.joints.empty());
  }
}

// The stem of a T ends in the bar: its end face is none, it goes on to the top of the bar. The bar's face is covered in
// part only and stays.
TEST(Compound, a_stem_reaches_through_the_bar) {
  const Compound body =
      make_compound(std::vector{box({-2, -0.5, 0}, {2, 0.5, 1}), box({-0.5, -0.5, -3}, {0.5, 0.5, 0})});
  ASSERT_EQ(body.parts.size(), 2u);
  EXPECT_EQ(body.parts[0].solid->faces.size(), 6u);
  EXPECT_NEAR(body.parts[0].solid->mass.volume, 4, 16 * eps);
  double lowest = 1, highest = -9;
  for (const Vec3d& v : body.parts[1].solid->vertices) {
    const double z = (body.frame.position + rotate(body.frame.orientation, body.parts[1].centre + v)).z;
    lowest = std::min(lowest, z), highest = std::max(highest, z);
  }
  EXPECT_NEAR(lowest, -3, 8 * eps);
  EXPECT_NEAR(highest, 1, 8 * eps);
}

// Two bars that bend: a face of the cut grows to the point where the outer sides meet.
TEST(Compound, a_bent_bar_has_no_inner_face) {
  const auto arm = [](double side) {
    std::vector<Vec3d> points;
    for (const double y : {-0.2, 0.2})
      for (const auto& [x, z] : {std::pair(0.0, 0.0), {0.0, 1.0}, {4 * side, -1.0}, {4 * side, 0.0}})
        points.push_back({x, y, z});
    return hull(points);
  };
  const Compound body = make_compound(std::vector{arm(-1), arm(1)});
  ASSERT_EQ(body.parts.size(), 2u);
  for (const auto& p : body.parts)
    for (const auto& f : p.solid->faces) {
      const Vec3d n = rotate(body.frame.orientation, f.normal);
      const bool cut = std::abs(n.x) > 1 - 1e-9;
      if (!cut) continue;
      // the only faces across x are the far ends
      const Vec3d x = body.frame.position + rotate(body.frame.orientation, p.centre + f.offset * f.normal);
      EXPECT_NEAR(std::abs(x.x), 4, 1e-12);
    }
}

TEST(Compound, what_is_inside_is_dropped) {
  EXPECT_EQ(make_compound(std::vector{ball({0, 0, 0}, 1), ball({0.5, 0, 0}, 0.5), ball({0, 0, 0}, 1)}).parts.size(),
            1u);
  EXPECT_EQ(make_compound(std::vector{box({-1, -1, -1}, {1, 1, 1}), ball({0, 0, 0}, 1)}).parts.size(), 1u);
  EXPECT_EQ(make_compound(std::vector{box({-1, -1, -1}, {1, 1, 1}), ball({0.1, 0, 0}, 1)}).parts.size(), 2u);
  const Compound one = make_compound(std::vector{ball({3, -2, 5}, 0.75)});
  ASSERT_EQ(one.parts.size(), 1u);
  EXPECT_EQ(one.parts[0].size.x, 0.75);
  EXPECT_TRUE(one.parts[0].centre == Vec3d{});
  EXPECT_TRUE(one.frame.position == (Vec3d{3, -2, 5}));
  EXPECT_EQ(one.mass.volume, mass_properties(Sphere{0.75}).volume);
  EXPECT_EQ(one.circumradius, 0.75);
}

// What a joint spans: the neck of two balls, the face between two boxes, the overlap of a ball and a box.
TEST(Compound, joints_are_where_parts_meet) {
  const Compound two = make_compound(std::vector{ball({-0.6, 0, 0}, 1), ball({0.6, 0, 0}, 1)});
  ASSERT_EQ(two.joints.size(), 1u);
  EXPECT_NEAR(extent(two, two.joints[0], {0, 1, 0}), 0.8, 4 * eps);
  EXPECT_NEAR(extent(two, two.joints[0], {1, 0, 0}), 0.4, 4 * eps);  // the tip of the lens
  const Vec3d slant = normalized(Vec3d{1, 2, 0});
  double lens = 0;
  Random random(5);
  for (int i = 0; i < 200000; ++i) {
    const Vec3d x{random.uniform(-0.4, 0.4), random.uniform(-0.8, 0.8), random.uniform(-0.8, 0.8)};
    if (distance(two.parts[0], x) < 0 && distance(two.parts[1], x) < 0) lens = std::max(lens, dot(slant, x));
  }
  EXPECT_NEAR(extent(two, two.joints[0], slant), lens, 0.01);
  EXPECT_GE(extent(two, two.joints[0], slant), lens);
  const Compound tee =
      make_compound(std::vector{box({-2, -0.5, 0}, {2, 0.5, 1}), box({-0.5, -0.5, -3}, {0.5, 0.5, 0})});
  ASSERT_EQ(tee.joints.size(), 1u);
  EXPECT_EQ(tee.joints[0].points.size(), 8u);
  EXPECT_EQ(tee.joint(1, 0), &tee.joints[0]);
  const Compound mixed = make_compound(std::vector{ball({0, 0, 0}, 1), box({0.5, -2, -2}, {3, 2, 2})});
  ASSERT_EQ(mixed.joints.size(), 1u);
  const Vec3d top{0, 0, 1};
  EXPECT_NEAR(extent(mixed, mixed.joints[0], rotate(conjugate(mixed.frame.orientation), top)) + mixed.frame.position.z,
              std::sqrt(0.75), 5e-3);
  EXPECT_TRUE(make_compound(std::vector{ball({0, 0, 0}, 1), ball({3, 0, 0}, 1)}).joints.empty());
}

TEST(Compound, other_units_give_the_same_bits_scaled) {
  const auto make = [](double unit) {
    const auto at = [unit](double x, double y, double z) { return Vec3d{x * unit, y * unit, z * unit}; };
    return make_compound(std::vector<CompoundPart>{
        {make_box(at(1.1, 0.7, 0.6)), {at(0.3, 0.2, 0.1), normalized(Quatd{0.9, 0.1, 0.2, 0.3})}},
        {make_box(at(0.5, 1.7, 0.6)), {at(0.1, -0.2, 0.1), {}}},
        {Sphere{0.6 * unit}, {at(0.9, 0.4, 0.1), {}}},
        {Ellipsoid{at(0.4, 0.5, 0.9)}, {at(-0.5, 0.3, 0.2), normalized(Quatd{0.8, 0.3, -0.2, 0.3})}}});
  };
  const Compound a = make(1);
  ASSERT_EQ(a.parts.size(), 4u);
  for (const int k : {-13, 20}) {
    const double unit = std::ldexp(1.0, k);
    const Compound b = make(unit);
    EXPECT_EQ(b.mass.volume, a.mass.volume * unit * unit * unit);
    EXPECT_EQ(b.circumradius, a.circumradius * unit);
    EXPECT_TRUE(b.frame.position == a.frame.position * unit);
    for (std::size_t i = 0; i < a.parts.size(); ++i) {
      EXPECT_TRUE(b.parts[i].centre == a.parts[i].centre * unit);
      EXPECT_EQ(b.parts[i].bounding_radius, a.parts[i].bounding_radius * unit);
      EXPECT_EQ(b.parts[i].equivalent_radius, a.parts[i].equivalent_radius * unit);
    }
    ASSERT_EQ(b.joints.size(), a.joints.size());
    for (std::size_t i = 0; i < a.joints.size(); ++i) EXPECT_TRUE(b.joints[i].middle == a.joints[i].middle * unit);
  }
}

TEST(Compound, nonsense_is_refused) {
  EXPECT_THROW(make_compound({}), Error);
  EXPECT_THROW(make_compound(std::vector{ball({0, 0, 0}, 0)}), Error);
  EXPECT_THROW(make_compound(std::vector{ball({0, 0, NAN}, 1)}), Error);
  EXPECT_THROW(make_compound(std::vector{CompoundPart{Sphere{1}, {{}, {0, 0, 0, 0}}}}), Error);
}

}  // namespace
