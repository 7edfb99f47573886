// Polyhedron–polyhedron against every axis and every feature pair in 50 digits.
#include <gtest/gtest.h>

#include <array>

#include "libcontact/methods/sat.h"
#include "tests/libcontact/poly_reference.h"

namespace {

using namespace contact;
using namespace reference;

std::vector<Polyhedron> zoo() {
  using enum shapes::Platonic;
  return {shapes::make_box({1, 1, 1}),
          shapes::make_box({1, 0.3, 0.02}),
          shapes::make_platonic(tetrahedron, 0.8),
          shapes::make_platonic(octahedron, 0.6),
          shapes::make_platonic(dodecahedron, 0.7),
          shapes::make_platonic(icosahedron, 0.5),
          shapes::make_prism(7, 0.5, 1.5),
          grain("cement140_01.off"),
          grain("cement140_07.off")};
}

double size_of(const Polyhedron& a, double scale_a, const Polyhedron& b, double scale_b, const Vec3d& d) {
  return norm(d) + scale_a * a.circumradius + scale_b * b.circumradius;
}

struct Case {
  const Polyhedron *a, *b;
  double scale_a, scale_b;
  Quatd qa, qb;
  Vec3d d;
};

// Checks one pair against the reference; returns the reference gap.
template <class T>
double check(const Case& c) {
  const Solid<T> a(*c.a, c.scale_a, c.qa, {}), b(*c.b, c.scale_b, c.qb, c.d);
  T exact = sat_gap(a, b);
  if (exact > T(0)) exact = distance(a, b);
  const Contact got = Sat::query(place(*c.a, c.scale_a, c.qa), place(*c.b, c.scale_b, c.qb), c.d, {}, nullptr);
  const double allowed = 64 * epsilon * size_of(*c.a, c.scale_a, *c.b, c.scale_b, c.d);
  EXPECT_LE(std::abs(static_cast<double>(T(got.gap) - exact)), allowed);
  EXPECT_LE(T(got.gap_lower), exact);
  EXPECT_GE(T(got.gap_upper), exact);
  EXPECT_LE(got.gap_upper - got.gap_lower, 4 * allowed);
  EXPECT_TRUE(got.certified);
  EXPECT_NEAR(norm(got.normal), 1, 16 * epsilon);  // the rotation is orthonormal to some eps
  // The witness points are a gap apart along the normal when the bodies overlap, the distance apart otherwise.
  const Vec3d w = got.point_b - got.point_a;
  if (got.status == Status::overlapping) {
    EXPECT_LE(norm(w - got.gap * got.normal), allowed);
  } else {
    EXPECT_LE(std::abs(norm(w) - std::abs(got.gap)), 2 * allowed);
  }
  // Each lies on or in its body.
  EXPECT_LE(point_gap(widen<T>(got.point_a), a), T(4 * allowed));
  EXPECT_LE(point_gap(widen<T>(got.point_b), b), T(4 * allowed));
  return static_cast<double>(exact);
}

TEST(PolySat, RandomPairs) {
  const auto shapes = zoo();
  Draw draw(11);
  int overlapping = 0, separated = 0;
  for (int i = 0; i < 3000; ++i) {
    Case c{&shapes[draw.index(shapes.size())],
           &shapes[draw.index(shapes.size())],
           std::exp2(draw.between(-2, 2)),
           std::exp2(draw.between(-2, 2)),
           draw.orientation(),
           draw.orientation(),
           {}};
    const double reach = c.scale_a * c.a->circumradius + c.scale_b * c.b->circumradius;
    c.d = draw.direction() * (reach * draw.between(0, 1.2));
    if (c.a->edges.size() * c.b->edges.size() > 1000 && i % 10 != 0) continue;
    (check<long double>(c) < 0 ? overlapping : separated) += 1;
    ASSERT_FALSE(HasFailure()) << "pair " << i;
  }
  EXPECT_GT(overlapping, 300);
  EXPECT_GT(separated, 300);
}

// Near-parallel faces and edges: the answer is continuous in the tilt and no axis is lost.
TEST(PolySat, SmallTilts) {
  const auto shapes = zoo();
  Draw draw(5);
  for (const double tilt : {0.0, 3e-16, 1e-12, 1e-8, 1e-5, 1e-3})
    for (std::size_t s = 0; s < 7; ++s)
      for (int i = 0; i < 4; ++i) {
        const Vec3d axis = draw.direction();
        const Quatd base = i % 2 ? draw.orientation() : Quatd{};
        const Quatd turn{std::cos(tilt / 2), std::sin(tilt / 2) * axis.x, std::sin(tilt / 2) * axis.y,
                         std::sin(tilt / 2) * axis.z};
        const auto& face = shapes[s].faces[draw.index(shapes[s].faces.size())];
        const Vec3d n = rotate(base, face.normal);
        const Case c{&shapes[s],
                     &shapes[s],
                     1,
                     1,
                     base,
                     turn * base,
                     n * (2 * face.offset - (i < 2 ? 1e-3 : -1e-3)) + draw.direction() * 0.1};
        check<Wide>(c);
        ASSERT_FALSE(HasFailure()) << "tilt " << tilt << " solid " << s << " draw " << i;
      }
}

// Needles and slivers that share a plane with the other body, in 50 digits.
TEST(PolySat, Slivers) {
  Draw draw(8);
  for (const double thin : {1e-3, 1e-6, 1e-9})
    for (int i = 0; i < 40; ++i) {
      std::vector<Vec3d> points;
      for (int k = 0; k < 7; ++k)
        points.push_back({draw.between(-1, 1), draw.between(-1, 1), thin * draw.between(-1, 1)});
      const Polyhedron plate = shapes::polyhedron_from_points(points, shapes::Frame::principal);
      const Polyhedron box = shapes::make_box({1, 0.5, 0.2});
      const Case c{&plate, &box, 1, 1, draw.orientation(), draw.orientation(), draw.direction() * draw.between(0, 1)};
      check<Wide>(c);
      ASSERT_FALSE(HasFailure()) << "thickness " << thin << " draw " << i;
    }
}

// Distances down to touching, for every kind of feature pair.
TEST(PolySat, NearContactDistances) {
  const auto shapes = zoo();
  Draw draw(21);
  for (int i = 0; i < 120; ++i) {
    Case c{&shapes[draw.index(7)], &shapes[draw.index(7)], 1, 1, draw.orientation(), draw.orientation(), {}};
    const Solid<long double> a(*c.a, 1, c.qa, {}), b(*c.b, 1, c.qb, {});
    // Vertex of A against vertex of B along a random direction: the closest features are decided by chance.
    const Vec3d n = draw.direction();
    Vec3d tip_a = rotate(c.qa, c.a->vertices[0]), tip_b = rotate(c.qb, c.b->vertices[0]);
    for (const auto& v : c.a->vertices)
      if (dot(rotate(c.qa, v), n) > dot(tip_a, n)) tip_a = rotate(c.qa, v);
    for (const auto& v : c.b->vertices)
      if (dot(rotate(c.qb, v), n) < dot(tip_b, n)) tip_b = rotate(c.qb, v);
    c.d = tip_a - tip_b + n * std::pow(10.0, draw.between(-15, 0));
    check<Wide>(c);
    ASSERT_FALSE(HasFailure()) << "draw " << i;
  }
}

TEST(PolySat, OverlapOnlyAgrees) {
  const auto shapes = zoo();
  Draw draw(3);
  Options quick;
  quick.overlap_only = true;
  for (int i = 0; i < 5000; ++i) {
    const Polyhedron &pa = shapes[draw.index(shapes.size())], &pb = shapes[draw.index(shapes.size())];
    const auto a = place(pa, 1, draw.orientation()), b = place(pb, 1, draw.orientation());
    const Vec3d d = draw.direction() * draw.between(0, 1.5);
    Cache cache;
    const Contact full = Sat::query(a, b, d, {}, nullptr), cold = Sat::query(a, b, d, quick, &cache),
                  warm = Sat::query(a, b, d, quick, &cache);
    EXPECT_EQ(full.status, cold.status);
    EXPECT_EQ(full.status, warm.status);
    if (full.status == Status::overlapping) {
      EXPECT_EQ(full.gap, cold.gap);
      EXPECT_EQ(full.gap, warm.gap);
    } else {
      EXPECT_LE(cold.gap_lower, full.gap_upper);
      EXPECT_LE(warm.gap_lower, full.gap_upper);
      EXPECT_GT(warm.gap_lower, 0);
    }
  }
}

TEST(PolySat, ManyFaces) {
  const Polyhedron drum = shapes::make_prism(1000, 1, 1), box = shapes::make_box({1, 1, 1});
  const auto flat = Sat::query(place(drum, 1, {}), place(box, 1, {}), {0.1, 0.2, 0.99}, {}, nullptr);
  EXPECT_NEAR(flat.gap, -0.01, 64 * epsilon * 4);
  EXPECT_NEAR(flat.patch.centre.x, 0.1, 1e-13);
  EXPECT_NEAR(flat.patch.centre.y, 0.2, 1e-13);
  const auto side = Sat::query(place(drum, 1, {}), place(drum, 1, {}), {1.99, 0, 0}, {}, nullptr);
  EXPECT_NEAR(side.gap, -0.01, 1e-5);  // the polygon stands back from the circle by 5e-6
  const auto apart = Sat::query(place(drum, 1, {}), place(box, 1, {}), {0, 0, 1.5}, {}, nullptr);
  EXPECT_NEAR(apart.gap, 0.5, 64 * epsilon * 4);
}

TEST(PolySat, RefusesBadInput) {
  const Polyhedron box = shapes::make_box({1, 1, 1});
  const double inf = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
  for (const double bad : {0.0, -1.0, inf, nan})
    EXPECT_EQ(Sat::query(place(box, bad, {}), place(box, 1, {}), {0.5, 0, 0}, {}, nullptr).status, Status::refused);
  for (const double bad : {inf, nan})
    EXPECT_EQ(Sat::query(place(box, 1, {}), place(box, 1, {}), {0.5, bad, 0}, {}, nullptr).status, Status::refused);
  auto broken = place(box, 1, {});
  broken.rotation.row[1].y = nan;
  EXPECT_EQ(Sat::query(broken, place(box, 1, {}), {0.5, 0, 0}, {}, nullptr).status, Status::refused);
  EXPECT_EQ(Sat::query(place(box, 1, {}), broken, {0.5, 0, 0}, {}, nullptr).status, Status::refused);
}

}  // namespace
