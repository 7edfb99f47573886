// The reference against itself, against the older references of single pairs, and every listed method against it.
#include "tests/libcontact/reference.h"

#include <gtest/gtest.h>

#include "tests/libcontact/catalogue.h"
#include "tests/libcontact/poly_reference.h"
#include "tests/reference/answer.h"
#include "tests/reference/samples.h"

namespace {

using namespace reference;
using contact::Contact;
using contact::epsilon;
using contact::MethodInfo;
using contact::Status;

double extent(const Body& a, const Body& b, const Vec3d& d) { return norm(d) + a.circumradius() + b.circumradius(); }

class Listed : public testing::TestWithParam<MethodInfo> {};

// Also that no pair is listed without a reference, but for facets of meshes: they leave bodies to their neighbours.
TEST_P(Listed, answers_contain_the_reference) {
  const MethodInfo& m = GetParam();
  Source draw(100 + 16 * static_cast<unsigned>(m.a) + static_cast<unsigned>(m.b));
  int overlapping = 0, matched = 0;
  constexpr int pairs = 300;
  for (int i = 0; i < pairs; ++i) {
    SCOPED_TRACE("pair " + std::to_string(i));
    const Body a = sample(m.a, draw), b = sample(m.b, draw);
    ASSERT_TRUE(known(a) && known(b));
    const Vec3d d = sample_offset(a, b, draw);
    const Answer truth = answer(a, b, d);
    const contact::Body pa = a.placed(), pb = b.placed();
    Contact c;
    contact::find(m.a, m.b, m.name)(1, &pa, &pb, &d, {}, nullptr, &c);
    const double length = extent(a, b, d), tolerance = 64 * epsilon * length;
    ASSERT_LE(truth.lower, truth.upper);
    EXPECT_LE(truth.upper - truth.lower, 1e-5 * length);
    ASSERT_NE(c.status, Status::refused);
    if (m.exact) {
      EXPECT_LE(abs(Real(c.gap) - truth.lower), tolerance) << c.gap << " " << truth.lower << " " << truth.upper;
    } else if (!half_space(m.b)) {  // the separation along its own normal
      EXPECT_LE(abs(Real(c.gap) - separation(a, b, d, c.normal)), tolerance);
    }
    EXPECT_LE(Real(c.gap_lower), truth.upper);
    EXPECT_GE(Real(c.gap_upper), truth.lower);
    overlapping += truth.lower < 0;
    matched += truth.matched;
    // No direction separates more than the reference says, the library's included.
    if (!half_space(m.b)) {
      EXPECT_LE(separation(a, b, d, c.normal), truth.lower + Real(1e-25 * length));
    }
  }
  EXPECT_GT(overlapping, pairs / 5);
  EXPECT_GT(matched, m.certified ? pairs / 2 : pairs / 4);
}

INSTANTIATE_TEST_SUITE_P(Catalogue, Listed, testing::ValuesIn(catalogue::of_own_methods()), catalogue::entry_name);

// Another formulation: bordered Newton from a scan of directions (tests/libcontact/reference.h).
TEST(Reference, ellipsoids_agree_with_the_bordered_system) {
  Source draw(3);
  for (int i = 0; i < 20; ++i) {
    const Body a = sample(Kind::ellipsoid, draw), b = sample(Kind::ellipsoid, draw);
    const Vec3d d = sample_offset(a, b, draw);
    const Real other = ellipsoid_gap(a, b, d);
    EXPECT_LE(abs(answer(a, b, d).lower - other), Real("1e-30")) << i;
  }
}

TEST(Reference, a_point_in_an_ellipsoid_agrees_with_the_scalar_equation) {
  Source draw(4);
  for (const double thin : {1.0, 1e-3, 1e-6})
    for (int i = 0; i < 20; ++i) {
      Body a = sample(Kind::sphere, draw), b = sample(Kind::ellipsoid, draw);
      b.size.z *= thin;
      const Vec3d d = sample_offset(a, b, draw);
      const Real other = gap(a, b, d);
      EXPECT_LE(abs(answer(a, b, d).lower - other), Real("1e-30")) << thin << " " << i;
    }
}

// Every axis and every feature pair, without the search.
TEST(Reference, polyhedra_agree_with_all_axes) {
  Source draw(5);
  for (int i = 0; i < 25; ++i) {
    const Body a = sample(Kind::polyhedron, draw), b = sample(Kind::polyhedron, draw);
    const Vec3d d = sample_offset(a, b, draw);
    const auto solid = [](const Body& body, const Vec3d& at) {
      return Solid<Wide>(*static_cast<const shapes::Polyhedron*>(body.geometry), body.size.x, body.orientation, at);
    };
    const auto sa = solid(a, {}), sb = solid(b, d);
    Wide all = sat_gap(sa, sb);
    if (all > 0) all = distance(sa, sb);
    // Faces that rounding has bent are met in other triangles.
    EXPECT_LE(abs(answer(a, b, d).lower - all), Real(4 * epsilon)) << i;
  }
}

// A ball in place of an ellipsoid of equal axes, the section of a body of space in place of one of the plane.
TEST(Reference, kinds_agree_where_they_are_the_same_body) {
  Source draw(6);
  for (int i = 0; i < 20; ++i) {
    const Body ball = sample(Kind::sphere, draw), other = sample(Kind::polyhedron, draw);
    Body round = sample(Kind::ellipsoid, draw);
    round.size = {ball.size.x, ball.size.x, ball.size.x};
    const Vec3d d = sample_offset(ball, other, draw);
    EXPECT_LE(abs(answer(ball, other, d).lower - answer(round, other, d).lower), Real("1e-30")) << i;

    const Body disc = sample(Kind::disc, draw), ellipse = sample(Kind::ellipse, draw);
    Body solid = ellipse;
    solid.kind = Kind::ellipsoid;
    solid.size.z = 2;
    Body sphere = disc;
    sphere.kind = Kind::sphere;
    const Vec3d e = sample_offset(disc, ellipse, draw);
    EXPECT_LE(abs(answer(disc, ellipse, e).lower - answer(sphere, solid, e).lower), Real("1e-30")) << i;
  }
}

TEST(Reference, scales_exactly) {
  Source draw(7);
  for (int i = 0; i < 10; ++i) {
    const Body a = sample(Kind::ellipsoid, draw), b = sample(Kind::rounded_polyhedron, draw);
    const Vec3d d = sample_offset(a, b, draw);
    const Real gap = answer(a, b, d).lower;
    for (const int power : {-300, 300}) {
      const double s = std::ldexp(1.0, power);
      Body as = a, bs = b;
      as.size *= s;
      bs.size *= s;
      EXPECT_EQ(answer(as, bs, s * d).lower, Real(s) * gap);
    }
  }
}

}  // namespace
