// The depth of flat-faced bodies in each other, and that its slope is its slope.
#include "libcontact/overlap_depth.h"

#include <gtest/gtest.h>

#include <numbers>
#include <random>

#include "libcontact/methods/overlap_moments.h"
#include "libcontact/methods/patch.h"
#include "libcontact/methods/polygon_regions.h"
#include "libcontact/methods/polyhedron_measure.h"
#include "libcontact/scale.h"
#include "shapes/math/quat.h"
#include "shapes/mesh_generate.h"
#include "shapes/polygon_build.h"
#include "shapes/polyhedron_build.h"

namespace contact {
namespace {

using shapes::Kind;
using shapes::Quatd;

constexpr double pi = std::numbers::pi;

Vec3d direction(std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  const Vec3d v{normal(random), normal(random), normal(random)};
  return v * (1 / norm(v));
}
Quatd turned(const Vec3d& axis, double angle) {
  const double s = std::sin(angle / 2);
  return {std::cos(angle / 2), axis.x * s, axis.y * s, axis.z * s};
}

struct Pair {
  Body a, b;
  Vec3d offset;
  OverlapDepth measure() const {
    OverlapDepth d;
    if (meets_in_regions(a, b)) {
      Contact c[max_regions];
      EXPECT_EQ(polygon_regions(a, b, offset, {.measure = true}, c), 1u);
      return c[0].measure;
    }
    const Contact c = query(a, b, offset, {.measure = true});
    if (c.measure.depth > 0) return c.measure;
    EXPECT_TRUE(overlap_depth(a, b, offset, c.normal, d));
    return d;
  }
  // b moved by u and turned by a small angle about the unit axis through the point x.
  Pair moved(const Vec3d& u, const Vec3d& axis, double angle, const Vec3d& x) const {
    Pair p = *this;
    const Mat3d r = rotation_matrix(turned(axis, angle));
    p.offset = x + r * (offset - x) + u;
    p.b.rotation = r * b.rotation;
    return p;
  }
};

// −dd along the motion: by (3), and by differences.
void expect_slope(const Pair& pair, std::mt19937_64& random, double step, double tolerance, bool planar) {
  const OverlapDepth d = pair.measure();
  ASSERT_GT(d.depth, 0);
  EXPECT_GT(d.gain, 0.1);
  for (int i = 0; i < 4; ++i) {
    Vec3d u = direction(random), axis = direction(random);
    if (planar) {
      u.z = 0;
      axis = {0, 0, 1};
    }
    const double angle = 1 / norm(d.point - pair.offset);
    const double high = pair.moved(u * step, axis, angle * step, pair.offset).measure().depth,
                 low = pair.moved(u * -step, axis, -angle * step, pair.offset).measure().depth;
    const double found = (low - high) / (2 * step);
    const Vec3d turn = axis * angle, at = u + cross(turn, d.point - pair.offset);
    EXPECT_NEAR(found, d.gain * (dot(d.normal, at) + d.screw * dot(d.normal, turn)), tolerance);
  }
}

// Bodies that touch where their origins' line runs, brought to an overlap of `depth` along their normal.
bool press(Pair& p, double depth) {
  for (int k = 0; k < 20; ++k) {
    const Contact c = query(p.a, p.b, p.offset);
    p.offset -= c.normal * (c.gap + depth);
  }
  return query(p.a, p.b, p.offset).gap < -0.3 * depth;
}

Body cube(const shapes::Polyhedron& shape, const Quatd& q = {}) {
  return {.kind = Kind::polyhedron, .geometry = &shape, .size = {1, 1, 1}, .rotation = rotation_matrix(q)};
}

const shapes::Polyhedron& box() {
  static const shapes::Polyhedron p = shapes::make_box({1, 1, 1});
  return p;
}

TEST(OverlapDepth, SlabIsAsDeepAsItIsThick) {
  for (const double depth : {1e-7, 1e-3, 0.2}) {
    const Pair onto{cube(box()), cube(box()), {0, 0, 1 - depth}},
        beside{cube(box()), cube(box()), {0.3, -0.2, 1 - depth}};
    const Pair wall{cube(box()), {.kind = Kind::plane}, {0, 0, depth - 0.5}};
    for (const Pair* p : {&onto, &beside, &wall}) {
      const OverlapDepth d = p->measure();
      // Where both overhang, their sides take part, and S leans by about δ/L.
      const double leans = p == &beside ? 4 * depth * depth : 0;
      EXPECT_NEAR(d.depth, depth, 64 * epsilon + leans * depth);
      EXPECT_NEAR(d.gain, 1, 1e-6 + 2 * leans);
      EXPECT_NEAR(std::abs(d.normal.z), 1, 1e-12 + leans * leans);
    }
    EXPECT_NEAR(onto.measure().point.x, 0, 1e-6);
    EXPECT_NEAR(beside.measure().point.x, 0.15, 1e-6);
    EXPECT_NEAR(beside.measure().point.y, -0.1, 1e-6);
  }
}

// So shallow that rounding is what is left of its shape.
TEST(OverlapDepth, GrazesAreLeftToTheGap) {
  OverlapDepth d;
  const Body a = cube(box());
  EXPECT_FALSE(overlap_depth(a, a, {0.1, 0, 1 - 1e-9}, {0, 0, 1}, d));
  EXPECT_FALSE(overlap_depth(a, {.kind = Kind::plane}, {0, 0, 1e-9 - 0.5}, {0, 0, -1}, d));
  EXPECT_FALSE(overlap_depth(a, a, {0.1, 0, 1.1}, {0, 0, 1}, d));
  EXPECT_FALSE(overlap_depth(a, {.kind = Kind::ellipsoid, .size = {1, 1, 1}}, {0, 0, 1}, {0, 0, 1}, d));
  EXPECT_FALSE(overlap_depth(cube(box()), {.kind = Kind::polyhedron, .geometry = &box(), .size = {0.1, 0.1, 0.1}}, {},
                             {0, 0, 1}, d));  // one in the other
}

// d² = δ² + θ² L²/4 as long as the whole face is in; the corner springs of (1).
TEST(OverlapDepth, TiltedFaceIsTwoSprings) {
  const double depth = 1e-3;
  for (const double angle : {1e-5, 1e-3}) {
    const Pair p{cube(box(), turned({0, 1, 0}, angle)), {.kind = Kind::plane}, {0, 0, depth - 0.5 * std::cos(angle)}};
    const double slope = std::sin(angle);
    EXPECT_NEAR(p.measure().depth, std::sqrt(depth * depth + slope * slope / 4), 1e-6 * depth);
  }
}

TEST(OverlapDepth, WedgeAndCorner) {
  const double depth = 1e-3, root = std::sqrt(0.5);
  const Pair wedge{cube(box(), turned({0, 1, 0}, pi / 4)), {.kind = Kind::plane}, {0, 0, depth - root}};
  EXPECT_NEAR(wedge.measure().depth, root * depth * std::sqrt(4.0 / 3), 2e-3 * depth);
  const Vec3d axis{root, -root, 0};
  const Pair corner{cube(box(), turned(axis, std::acos(1 / std::sqrt(3.0)))),
                    {.kind = Kind::plane},
                    {0, 0, depth - 0.5 * std::sqrt(3.0)}};
  EXPECT_NEAR(corner.measure().depth, depth * std::sqrt(0.45), 2e-3 * depth);
  EXPECT_NEAR(corner.measure().gain, std::sqrt(0.45), 2e-3);
}

TEST(OverlapDepth, SlopeOfPolyhedraAndWalls) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> part;
  const shapes::Polyhedron brick = shapes::make_box({1.4, 0.8, 0.5});
  int seen = 0;
  for (int i = 0; i < 60; ++i) {
    const Quatd qa = turned(direction(random), 3 * part(random)), qb = turned(direction(random), 3 * part(random));
    Pair p{cube(box(), qa), cube(brick, qb), direction(random)};
    if (i % 3 == 0) {  // nearly flat on each other
      p.a.rotation = Mat3d::identity();
      p.b.rotation = rotation_matrix(turned(direction(random), 0.02));
      p.offset = {0.3 * part(random), 0.3 * part(random), 0.7};
    }
    if (i % 3 == 1) p.b = {.kind = Kind::plane, .rotation = rotation_matrix(qb)};
    if (!press(p, 0.03)) continue;
    ++seen;
    expect_slope(p, random, 1e-6, 1e-6, false);
    if (HasFailure()) {
      ADD_FAILURE() << "case " << i;
      return;
    }
  }
  EXPECT_GT(seen, 40);
}

// With the contact it is the same, to rounding; and nothing else changes but the patch, which is then that of the
// overlap. Closed forms and short cuts are the sums over one body cut by all planes of the other.
TEST(OverlapDepth, OfPolyhedraComesWithTheContact) {
  std::mt19937_64 random(23);
  const shapes::Polyhedron ico = shapes::make_platonic(shapes::Platonic::icosahedron, 0.8);
  const auto expect_same = [](const OverlapDepth& d, const OverlapDepth& e) {
    EXPECT_NEAR(d.depth, e.depth, 1e-13);
    EXPECT_NEAR(d.gain, e.gain, 1e-11);
    EXPECT_LE(norm(d.normal - e.normal), 1e-11);
    EXPECT_LE(norm(d.point - e.point), 1e-11);
    EXPECT_NEAR(d.screw, e.screw, 1e-11);
  };
  int seen = 0;
  for (int i = 0; i < 90; ++i) {
    Pair p{cube(i % 2 == 0 ? box() : ico, turned(direction(random), 3)), cube(ico, turned(direction(random), 2)),
           direction(random)};
    if (i % 3 == 0) p.b = cube(box(), turned(direction(random), 0.01)), p.a = cube(box()), p.offset = {0.2, 0.3, 0.9};
    if (!press(p, 0.01)) continue;
    const Contact with = query(p.a, p.b, p.offset, {.measure = true}), without = query(p.a, p.b, p.offset);
    EXPECT_EQ(with.gap, without.gap);
    EXPECT_LE(norm(with.normal - without.normal), 0);
    EXPECT_LE(norm(with.point_a - without.point_a), 0.01);
    EXPECT_LE(norm(with.patch.centre - without.patch.centre), 0.01);
    EXPECT_EQ(without.measure.depth, 0);
    OverlapDepth d;
    ASSERT_TRUE(overlap_depth(p.a, p.b, p.offset, with.normal, d));
    if (with.measure.depth > 0) ++seen, expect_same(with.measure, d);
    const Contact back = query(p.b, p.a, -p.offset, {.measure = true});
    EXPECT_EQ(back.measure.depth, with.measure.depth);
    EXPECT_LE(norm(back.measure.normal + with.measure.normal), 0);
    double up = 1;
    DepthSlope slope;
    ASSERT_TRUE(depth_slope(
        overlap_body(
            placed_polyhedra(placed<shapes::Polyhedron>(p.a), placed<shapes::Polyhedron>(p.b), p.offset, up).pair),
        0.1, slope));
    OverlapDepth plain = rotated(line_of_action(slope), p.a.rotation);
    rescale(plain, up);
    expect_same(plain, d);
    ASSERT_FALSE(HasFailure()) << "case " << i;
  }
  EXPECT_GT(seen, 60);
}

TEST(OverlapDepth, SlopeOfRoundedOnAPlane) {
  std::mt19937_64 random(19);
  for (int i = 0; i < 20; ++i) {
    Body a = cube(box(), turned(direction(random), i % 2 == 0 ? 0.01 : 2.0));
    a.kind = Kind::rounded_polyhedron;
    a.size.y = 0.1;
    Pair p{a, {.kind = Kind::plane}, {0, 0, -1}};
    ASSERT_TRUE(press(p, 0.03));
    expect_slope(p, random, 1e-6, 1e-6, false);
    ASSERT_FALSE(HasFailure()) << "case " << i;
  }
}

TEST(OverlapDepth, SlopeOfPolygonsAndLines) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> part;
  const shapes::Polygon seven = shapes::make_regular_polygon(7, 0.6), four = shapes::make_regular_polygon(4, 0.8);
  const auto body = [](const shapes::Polygon& p, double angle) {
    return Body{.kind = Kind::polygon,
                .geometry = &p,
                .size = {1, 1, 1},
                .rotation = rotation_matrix(turned({0, 0, 1}, angle))};
  };
  int seen = 0;
  for (int i = 0; i < 60; ++i) {
    Pair p{body(seven, 6 * part(random)), body(four, 6 * part(random)), direction(random)};
    p.offset.z = 0;
    if (i % 3 == 0) p.a = body(four, pi / 4 + 0.02 * part(random)), p.b = body(four, pi / 4), p.offset = {0.1, 1.1, 0};
    if (i % 3 == 1) p.b = {.kind = Kind::line, .rotation = rotation_matrix(turned({0, 0, 1}, 6 * part(random)))};
    if (!press(p, 0.03)) continue;
    ++seen;
    expect_slope(p, random, 1e-6, 1e-6, true);
    ASSERT_FALSE(HasFailure()) << "case " << i;
  }
  EXPECT_GT(seen, 40);
}

// A region of an outline that is not convex: where it is met as a convex body would be, as that; and its slope.
TEST(OverlapDepth, RegionsOfPolygons) {
  std::mt19937_64 random(13);
  const std::vector<Vec3d> brick{{-0.5, -0.25, 0}, {0.5, -0.25, 0}, {0.5, 0.25, 0}, {-0.5, 0.25, 0}},
      floor{{-1, -1, 0}, {1, -1, 0}, {1, -0.5, 0}, {-1, -0.5, 0}},
      corner{{-1, -1, 0}, {1, -1, 0}, {1, -0.5, 0}, {-0.5, -0.5, 0}, {-0.5, 1, 0}, {-1, 1, 0}};
  const shapes::Polygon bar = shapes::polygon_from_outline(brick), flat = shapes::polygon_from_outline(floor),
                        ell = shapes::polygon_from_outline(corner);
  const auto body = [](const shapes::Polygon& p, double angle) {
    return Body{.kind = Kind::polygon,
                .geometry = &p,
                .size = {1, 1, 1},
                .rotation = rotation_matrix(turned({0, 0, 1}, angle))};
  };
  for (const double tilt : {0.0, 1e-4, 0.006, 0.02, 0.3}) {
    Pair on_flat{body(bar, tilt), body(flat, 0), {-0.3, 0, 0}};
    ASSERT_TRUE(press(on_flat, 0.01));
    Pair on_ell = on_flat;
    on_ell.b = body(ell, 0);
    ASSERT_TRUE(meets_in_regions(on_ell.a, on_ell.b));
    const OverlapDepth d = on_flat.measure(), e = on_ell.measure();
    EXPECT_NEAR(d.depth, e.depth, 1e-13);
    EXPECT_NEAR(d.gain, e.gain, 1e-11);
    EXPECT_LE(norm(d.normal - e.normal), 1e-11);
    EXPECT_NEAR(cross(d.normal, d.point - e.point).z, 0, 1e-10);
    expect_slope(on_ell, random, 1e-6, 1e-6, true);
    ASSERT_FALSE(HasFailure()) << "on an L, tilt " << tilt;
    // Its foot on a line: two regions become one slope each.
    Pair on_line{body(ell, 0.3), {.kind = Kind::line}, {0, 0, 0}};
    on_line.offset.y = -1 / std::cos(0.3) + 0.05;
    Contact c[max_regions];
    ASSERT_EQ(polygon_regions(on_line.a, on_line.b, on_line.offset, {}, c), 1u);
    expect_slope(on_line, random, 1e-6, 1e-6, true);
    ASSERT_FALSE(HasFailure()) << "on a line";
  }
}

// Over the middle of a facet a mesh is a plane.
TEST(OverlapDepth, MeshIsPlane) {
  std::mt19937_64 random(17);
  const shapes::Mesh panel = shapes::make_panel({-5, -5, 0}, {10, 0, 0}, {0, 10, 0});
  for (int i = 0; i < 20; ++i) {
    Pair plane{cube(box(), turned(direction(random), i * 0.1)), {.kind = Kind::plane}, {0, 0, -1}};
    ASSERT_TRUE(press(plane, 0.02));
    Pair mesh = plane;
    mesh.b = {.kind = Kind::mesh, .geometry = &panel, .size = {1, 1, 1}};
    const OverlapDepth d = plane.measure(), e = mesh.measure();
    EXPECT_NEAR(d.depth, e.depth, 1e-13);
    EXPECT_NEAR(d.gain, e.gain, 1e-11);
    EXPECT_LE(norm(d.normal - e.normal), 1e-12);
    EXPECT_LE(norm(cross(d.normal, d.point - e.point)), 1e-10);
  }
}

}  // namespace
}  // namespace contact
