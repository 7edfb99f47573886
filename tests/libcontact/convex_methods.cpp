// gjk_epa and mpr by themselves: closed forms, and what they say beside the exact methods.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "libcontact/dispatch.h"
#include "shapes/math/quat.h"
#include "shapes/math/trig.h"
#include "shapes/polygon_build.h"
#include "shapes/polyhedron_build.h"
#include "tests/libcontact/catalogue.h"
#include "tests/shapes/potential_samples.h"

namespace {

using namespace contact;
using shapes::Kind;

struct Draw {
  std::mt19937_64 engine{41};
  double uniform(double low, double high) {
    return low + (high - low) * (static_cast<double>(engine() >> 11) * 0x1p-53);
  }
  Vec3d direction() {
    for (;;) {
      const Vec3d v{uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)};
      if (const double s = dot(v, v); s > 0.01 && s < 1) return normalized(v);
    }
  }
  Mat3d rotation() {
    return rotation_matrix(normalized(shapes::Quatd{uniform(-1, 1), uniform(-1, 1), uniform(-1, 1), uniform(0.1, 1)}));
  }
};

const std::vector<shapes::Polyhedron>& solids() {
  using enum shapes::Platonic;
  static const std::vector<shapes::Polyhedron> list{
      shapes::make_box({1, 1.5, 2}), shapes::make_box({2, 2, 0.25}), shapes::make_platonic(tetrahedron, 1),
      shapes::make_platonic(icosahedron, 1), shapes::make_prism(7, 0.5, 1.5)};
  return list;
}

const std::vector<shapes::Polygon>& polygons() {
  static const std::vector<shapes::Polygon> list{
      shapes::make_regular_polygon(3, 1), shapes::make_regular_polygon(8, 1),
      shapes::polygon_hull(std::vector<Vec3d>{{-1, -0.125, 0}, {1, -0.125, 0}, {1, 0.125, 0}, {-1, 0.125, 0}}),
      shapes::polygon_hull(std::vector<Vec3d>{{-0.5, -0.5, 0}, {1, -0.25, 0}, {0.25, 0.75, 0}, {-0.75, 0.5, 0}})};
  return list;
}

bool is_flat(Kind kind) { return shapes::dimension_of(kind) == 2; }

Body sample(Kind kind, Draw& draw) {
  Body b{kind, 0, nullptr, {draw.uniform(0.3, 1.2), 0, 0}, draw.rotation()};
  if (is_flat(kind)) {
    const shapes::SineCosine t = shapes::sine_cosine(draw.uniform(-3, 3));
    b.rotation = {{{t.cosine, -t.sine, 0}, {t.sine, t.cosine, 0}, {0, 0, 1}}};
  }
  if (kind == Kind::ellipse) b.size = {draw.uniform(0.3, 1.2), draw.uniform(0.3, 1.2), 0};
  if (kind == Kind::polygon) b.geometry = &polygons()[draw.engine() % polygons().size()];
  if (kind == Kind::ellipsoid) b.size = {draw.uniform(0.3, 1.2), draw.uniform(0.3, 1.2), draw.uniform(0.3, 1.2)};
  if (kind == Kind::polyhedron || kind == Kind::rounded_polyhedron)
    b.geometry = &solids()[draw.engine() % solids().size()];
  if (kind == Kind::rounded_polyhedron) b.size.y = draw.uniform(0.02, 0.3);
  if (kind == Kind::potential_particle)
    b.geometry = &shape_tests::potential_particles()[draw.engine() % shape_tests::potential_particles().size()];
  return b;
}

Vec3d direction(Kind kind, Draw& draw) {
  if (!is_flat(kind)) return draw.direction();
  const shapes::SineCosine t = shapes::sine_cosine(draw.uniform(-3, 3));
  return {t.cosine, t.sine, 0};
}

struct Drawn {
  Body a, b;
  Vec3d offset;
  double size, small;
};
Drawn draw_pair(const MethodInfo& m, Draw& draw) {
  Drawn p{sample(m.a, draw), sample(m.b, draw), {}, 0, 0};
  const double ra = circumradius(p.a), rb = circumradius(p.b);
  const Vec3d along = direction(m.a, draw);
  if (is_wall(m.b))
    p.offset = 0.5 * along - draw.uniform(-0.2, 1.1) * ra * p.b.rotation.column(m.b == Kind::line ? 1 : 2);
  else
    p.offset = draw.uniform(0.4, 1.1) * (ra + rb) * along;
  p.size = ra + rb + norm(p.offset);
  p.small = is_wall(m.b) ? ra : std::min(ra, rb);
  return p;
}

bool has_corners(Kind k) {  // of the core
  return k != Kind::ellipsoid && k != Kind::potential_particle && k != Kind::ellipse;
}

std::vector<MethodInfo> answered_by(std::string_view method) {
  std::vector<MethodInfo> list(methods_begin(), methods_end());
  std::erase_if(list, [&](const MethodInfo& m) { return m.name != method; });
  return list;
}

class GjkEpaPairs : public testing::TestWithParam<MethodInfo> {};

// Apart or overlapping gjk_epa finds the gap, and its interval closes to a millionth of the smaller body; of cores with
// corners alone to rounding, and the gap of most others.
TEST_P(GjkEpaPairs, gap_is_that_of_the_exact_method) {
  const MethodInfo& m = GetParam();
  Draw draw;
  int open = 0, right = 0;
  for (int i = 0; i < 300; ++i) {
    const Drawn p = draw_pair(m, draw);
    const Contact c = query(p.a, p.b, p.offset, {}, "gjk_epa"), exact = query(p.a, p.b, p.offset);
    SCOPED_TRACE(i);
    open += c.status == Status::not_converged;
    EXPECT_FALSE(c.handed_over);
    EXPECT_LE(c.gap_lower, exact.gap_upper);
    if (exact.certified) {
      EXPECT_GE(c.gap_upper, exact.gap_lower);
    }
    if (c.status == Status::not_converged) continue;
    EXPECT_LE(c.gap_upper - c.gap_lower, 1e-6 * p.small + 64 * epsilon * p.size);
    right += std::abs(c.gap - exact.gap) <= 64 * epsilon * p.size;
    if (has_corners(m.a) && has_corners(m.b)) {
      EXPECT_NEAR(c.gap, exact.gap, 64 * epsilon * p.size);
    }
    // Witness points: as far apart as the gap, along the normal.
    EXPECT_NEAR(norm(c.point_b - c.point_a), std::abs(c.gap), 64 * epsilon * p.size);
  }
  EXPECT_LE(open, 3);
  EXPECT_GE(right, 285) << m.name;  // of round bodies too
}

// Asked for less, it stops earlier, and its interval is as narrow as was asked.
TEST_P(GjkEpaPairs, a_tolerance_is_met_and_saves_steps) {
  const MethodInfo& m = GetParam();
  Draw draw;
  long coarse_steps = 0, fine_steps = 0;
  for (int i = 0; i < 100; ++i) {
    const Drawn p = draw_pair(m, draw);
    Options coarse;
    coarse.tolerance = 1e-2;
    const Contact c = query(p.a, p.b, p.offset, coarse, "gjk_epa"), fine = query(p.a, p.b, p.offset, {}, "gjk_epa");
    SCOPED_TRACE(i);
    if (c.status != Status::not_converged) {
      EXPECT_LE(c.gap_upper - c.gap_lower, 1e-2 * p.small + 64 * epsilon * p.size);
    }
    EXPECT_LE(c.gap_lower, fine.gap_upper);
    EXPECT_GE(c.gap_upper, fine.gap_lower);
    coarse_steps += c.iterations;
    fine_steps += fine.iterations;
  }
  if (has_corners(m.a) && has_corners(m.b)) {
    EXPECT_LE(coarse_steps, fine_steps);
  } else if (!is_wall(m.b)) {
    EXPECT_LT(1.3 * static_cast<double>(coarse_steps), static_cast<double>(fine_steps));
  }
}

INSTANTIATE_TEST_SUITE_P(ConvexMethods, GjkEpaPairs, testing::ValuesIn(answered_by("gjk_epa")), catalogue::entry_name);

class MprPairs : public testing::TestWithParam<MethodInfo> {};

// mpr decides overlap; its depth is that along its own normal, never less than the least translation, at times far
// more.
TEST_P(MprPairs, it_decides_overlap_and_is_never_shallower) {
  const MethodInfo& m = GetParam();
  Draw draw;
  int open = 0, deeper = 0, proven = 0, overlapping = 0;
  for (int i = 0; i < 300; ++i) {
    const Drawn p = draw_pair(m, draw);
    const Contact c = query(p.a, p.b, p.offset, {}, "mpr"), exact = query(p.a, p.b, p.offset);
    SCOPED_TRACE(i);
    EXPECT_FALSE(c.handed_over);
    open += c.status == Status::not_converged;
    const double tolerance = 1e-9 * p.size;
    if (std::abs(exact.gap) > tolerance) {
      EXPECT_EQ(c.method_overlap > 0, exact.gap < 0) << c.method_overlap << " " << exact.gap;
    }
    EXPECT_GE(c.method_overlap, -exact.gap - tolerance);
    EXPECT_NEAR(c.gap, -c.method_overlap, tolerance);
    deeper += exact.gap < 0 && c.method_overlap > 1.05 * -exact.gap;
    overlapping += exact.gap < 0;
    proven += c.status == Status::overlapping;
  }
  EXPECT_EQ(open, 0);
  EXPECT_GE(proven, overlapping * 95 / 100);
  const bool round = (m.a == Kind::sphere || m.a == Kind::disc) && m.a == m.b;
  if (!is_wall(m.b) && !round) {
    EXPECT_GT(deeper, 5);
  }
}

INSTANTIATE_TEST_SUITE_P(ConvexMethods, MprPairs, testing::ValuesIn(answered_by("mpr")), catalogue::entry_name);

// One centre, and the same pose: no direction to begin from.
TEST(ConvexMethods, bodies_with_one_centre) {
  for (const char* method : {"gjk_epa", "mpr"})
    for (const MethodInfo& m : answered_by(method)) {
      if (is_wall(m.b)) continue;
      Draw draw;
      for (int i = 0; i < 30; ++i) {
        Body a = sample(m.a, draw), b = sample(m.b, draw);
        if (i % 2 == 0) a.rotation = b.rotation = Mat3d::identity();
        const Contact c = query(a, b, {}, {}, method), exact = query(a, b, {});
        SCOPED_TRACE(std::string(method) + " " + name_of(m.a) + " " + name_of(m.b) + " " + std::to_string(i));
        EXPECT_LT(c.gap, 0);
        EXPECT_LE(c.gap_lower, exact.gap_upper);
        if (exact.certified) {
          EXPECT_GE(c.gap_upper, exact.gap_lower);
        }
        if (std::string(method) == "gjk_epa" && has_corners(m.a) && has_corners(m.b)) {
          EXPECT_NEAR(c.gap, exact.gap, 64 * epsilon * (circumradius(a) + circumradius(b)));
        }
      }
    }
}

// Outlines that are not convex are not theirs.
TEST(ConvexMethods, a_polygon_that_is_not_convex_is_refused) {
  const shapes::Polygon hook = shapes::polygon_from_outline(
      std::vector<Vec3d>{{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}});
  Body a, b;
  a.kind = Kind::disc;
  a.size = {0.5, 0, 0};
  b.kind = Kind::polygon;
  b.geometry = &hook;
  b.size = {1, 0, 0};
  ASSERT_EQ(query(a, b, {3, 0, 0}).status, Status::separated);
  for (const char* method : {"gjk_epa", "mpr"}) EXPECT_EQ(query(a, b, {3, 0, 0}, {}, method).status, Status::refused);
}

TEST(ConvexMethods, a_ball_in_a_face_and_beside_it) {
  const shapes::Polyhedron cube = shapes::make_box({2, 2, 2});
  Body ball, box;
  ball.size = {0.5, 0, 0};
  box.kind = Kind::polyhedron;
  box.geometry = &cube;
  box.size = {1, 0, 0};
  for (const char* method : {"gjk_epa", "mpr"})
    for (const double x : {1.25, 1.4375, 1.75}) {  // the centre outside: of the face, apart from it in the end
      const Contact c = query(ball, box, {-x, 0.25, 0.125}, {}, method);
      SCOPED_TRACE(std::string(method) + " " + std::to_string(x));
      EXPECT_LE(c.gap, x - 1.5 + 1e-12);
      if (std::string(method) == "gjk_epa") {
        EXPECT_NEAR(c.gap, x - 1.5, 1e-12);
        EXPECT_NEAR(c.normal.x, -1, 1e-9);
        EXPECT_NEAR(c.method_overlap, 1.5 - x, 1e-9);
        EXPECT_LE(c.gap_upper - c.gap_lower, 1e-9);
        EXPECT_NEAR(c.method_point.x, -0.5 * (0.5 + (x - 1)), 1e-9);
      }
    }
}

}  // namespace
