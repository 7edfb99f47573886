// Curvatures of bodies and of pairs, against second derivatives in 50 digits and against closed forms.
#include "libcontact/curvature.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "libcontact/laws/elliptical.h"
#include "shapes/math/quat.h"

#if TEST_HAS_BOOST
#include <boost/multiprecision/cpp_bin_float.hpp>
#endif

namespace contact {
namespace {

using shapes::Kind;

Body body(Kind kind, const Vec3d& size, const Mat3d& rotation = Mat3d::identity()) {
  Body b;
  b.kind = kind;
  b.size = size;
  b.rotation = rotation;
  return b;
}

class Draw {
 public:
  double in(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine_); }
  double log_in(double low, double high) { return std::exp(in(std::log(low), std::log(high))); }
  Vec3d unit() {
    Vec3d v;
    do v = {in(-1, 1), in(-1, 1), in(-1, 1)};
    while (dot(v, v) > 1 || dot(v, v) < 1e-2);
    return shapes::normalized(v);
  }
  Mat3d rotation() {
    const Vec3d a = unit();
    Vec3d t1, t2;
    shapes::tangent_frame(a, t1, t2);
    const double angle = in(0, 6);
    const Vec3d b = t1 * std::cos(angle) + t2 * std::sin(angle);
    return shapes::transposed(Mat3d{{b, cross(a, b), a}});
  }

 private:
  std::mt19937_64 engine_{5};
};

TEST(Curvature, RoundAndFlatBodies) {
  Curvature c;
  const Vec3d n = shapes::normalized(Vec3d{1, 2, -2});
  ASSERT_TRUE(curvature(body(Kind::sphere, {0.25, 0, 0}), n, c));
  EXPECT_EQ(c.least, 4);
  EXPECT_EQ(c.most, 4);
  ASSERT_TRUE(curvature(body(Kind::rounded_polyhedron, {3, 0.5, 0}), n, c));
  EXPECT_EQ(c.most, 2);
  for (const Kind flat : {Kind::plane, Kind::mesh, Kind::line}) {
    ASSERT_TRUE(curvature(body(flat, {1, 0, 0}), n, c));
    EXPECT_EQ(c.most, 0);
  }
  for (const Kind none : {Kind::polyhedron, Kind::polygon, Kind::compound}) {
    c.most = 7;
    EXPECT_FALSE(curvature(body(none, {1, 0, 0}), n, c));
    EXPECT_EQ(c.most, 7);
  }
}

TEST(Curvature, EllipseAtItsEndsAndBetween) {
  const double a = 3, b = 0.5;
  Curvature c;
  ASSERT_TRUE(curvature(body(Kind::ellipse, {a, b, 0}), {1, 0, 0}, c));
  EXPECT_DOUBLE_EQ(c.most, a / (b * b));
  EXPECT_EQ(c.least, c.most);
  ASSERT_TRUE(curvature(body(Kind::ellipse, {a, b, 0}), {0, -1, 0}, c));
  EXPECT_DOUBLE_EQ(c.most, b / (a * a));
  // At the point (a cos t, b sin t): a b/(a² sin² t + b² cos² t)^(3/2), in a body that is turned.
  for (double t = 0.1; t < 6; t += 0.37) {
    const Vec3d n = shapes::normalized(Vec3d{b * std::cos(t), a * std::sin(t), 0});
    Mat3d turn = Mat3d::identity();
    turn.row[0] = {0.6, -0.8, 0};
    turn.row[1] = {0.8, 0.6, 0};
    ASSERT_TRUE(curvature(body(Kind::ellipse, {a, b, 0}, turn), turn * n, c));
    const double q = a * a * std::sin(t) * std::sin(t) + b * b * std::cos(t) * std::cos(t);
    EXPECT_NEAR(c.most / (a * b / (q * std::sqrt(q))), 1, 2e-15) << t;
  }
}

TEST(Curvature, EllipsoidAtItsAxes) {
  const double a = 2e-3, b = 1e-3, c = 0.5e-3;
  Curvature k;
  ASSERT_TRUE(curvature(body(Kind::ellipsoid, {a, b, c}), {0, 0, 1}, k));
  EXPECT_DOUBLE_EQ(k.least, c / (a * a));
  EXPECT_DOUBLE_EQ(k.most, c / (b * b));
  EXPECT_NEAR(std::abs(k.least_direction.x), 1, 1e-15);
  EXPECT_NEAR(std::abs(k.most_direction.y), 1, 1e-15);
  ASSERT_TRUE(curvature(body(Kind::ellipsoid, {a, b, c}), {-1, 0, 0}, k));
  EXPECT_DOUBLE_EQ(k.least, a / (b * b));
  EXPECT_DOUBLE_EQ(k.most, a / (c * c));
  EXPECT_NEAR(std::abs(k.most_direction.z), 1, 1e-15);
}

#if TEST_HAS_BOOST
using Wide = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<60>, boost::multiprecision::et_off>;
using shapes::Vec3;

Vec3<Wide> wide(const Vec3d& v) { return {Wide(v.x), Wide(v.y), Wide(v.z)}; }

// The second derivative of h(n) = sqrt(nᵀ D² n) along u and v: ρ(u, v) = (u·D²v)/h − (u·D²n)(v·D²n)/h³, by its plain
// formula, in the ellipsoid's axes.
struct Radii {
  Vec3<Wide> square, n;
  Wide operator()(const Vec3<Wide>& u, const Vec3<Wide>& v) const {
    const Vec3<Wide> dn = scaled(square, n);
    const Wide h = sqrt(dot(n, dn));
    return dot(u, scaled(square, v)) / h - dot(u, dn) * dot(v, dn) / (h * h * h);
  }
};

// Curvatures and directions satisfy the eigenvalue equations, whatever the aspect ratio.
TEST(Curvature, EllipsoidsOfAnyAspectRatio) {
  Draw draw;
  double worst = 0, worst_direction = 0;
  for (int i = 0; i < 4000; ++i) {
    const double span = i % 4 == 0 ? 1.5 : i % 4 == 1 ? 1e3 : i % 4 == 2 ? 1e8 : 1.0000001;
    const Vec3d axes{draw.log_in(1, span), draw.log_in(1, span), i % 3 == 0 ? 1.0 : draw.log_in(1, span)};
    const Mat3d turn = i % 2 == 0 ? Mat3d::identity() : draw.rotation();
    Vec3d n = draw.unit();
    // Near the sides and the tips too.
    if (i % 5 == 0) n = shapes::normalized(Vec3d{n.x * draw.log_in(1e-9, 1), n.y * draw.log_in(1e-9, 1), n.z});
    Curvature c;
    ASSERT_TRUE(curvature(body(Kind::ellipsoid, axes, turn), turn * n, c));
    // The normal that the body sees, to rounding; its rounding in needles is the caller's.
    const Vec3d seen = transposed_times(turn, turn * n);
    const Vec3<Wide> wn = wide(seen), square = scaled(wide(axes), wide(axes));
    Vec3<Wide> t1, t2;
    shapes::tangent_frame(shapes::normalized(wn), t1, t2);
    const Radii r{square, shapes::normalized(wn)};
    const Wide trace = r(t1, t1) + r(t2, t2), det = r(t1, t1) * r(t2, t2) - r(t1, t2) * r(t1, t2);
    const Wide larger = trace / 2 + sqrt((r(t1, t1) - r(t2, t2)) * (r(t1, t1) - r(t2, t2)) / 4 + r(t1, t2) * r(t1, t2));
    worst = std::max(worst, std::abs(double(Wide(c.least) * larger - 1)));
    worst = std::max(worst, std::abs(double(Wide(c.most) * det / larger - 1)));
    // ρ(u, v) vanishes between the two directions, and is the radius along one.
    const Vec3<Wide> u = wide(transposed_times(turn, c.least_direction)),
                     v = wide(transposed_times(turn, c.most_direction));
    worst_direction = std::max(worst_direction, std::abs(double(r(u, v) / larger)));
    worst_direction = std::max(worst_direction, std::abs(double(r(u, u) / larger - 1)));
    EXPECT_NEAR(norm(c.least_direction), 1, 1e-15);
    EXPECT_NEAR(norm(c.most_direction), 1, 1e-15);
    EXPECT_NEAR(dot(c.least_direction, c.most_direction), 0, 1e-15);
    EXPECT_NEAR(dot(c.least_direction, turn * n), 0, 2e-15);  // `turn` is a rotation to rounding
  }
  EXPECT_LT(worst, 1e-14);
  EXPECT_LT(worst_direction, 1e-14);
}

// A and B, the eigenvalues of half the sum of both curvature matrices, in 60 digits.
TEST(Curvature, RelativeCurvatureIsTheSumOfBothMatrices) {
  Draw draw;
  double worst = 0;
  for (int i = 0; i < 3000; ++i) {
    const double span = i % 2 == 0 ? 3.0 : 1e6;
    const double angle = i % 7 == 0 ? 0 : draw.in(0, 6.3);
    Curvature a{draw.log_in(1 / span, 1), draw.log_in(1, span), {1, 0, 0}, {0, 1, 0}};
    Curvature b{draw.log_in(1 / span, 1), draw.log_in(1, span), {std::cos(angle), std::sin(angle), 0}, {}};
    b.most_direction = {-b.least_direction.y, b.least_direction.x, 0};
    if (i % 5 == 0) b.least = b.most = 0;
    const Vec3<Wide> d1 = shapes::normalized(wide(b.least_direction)), d2{-d1.y, d1.x, Wide(0)};
    const Wide xx = (Wide(a.least) + Wide(b.least) * d1.x * d1.x + Wide(b.most) * d2.x * d2.x) / 2;
    const Wide yy = (Wide(a.most) + Wide(b.least) * d1.y * d1.y + Wide(b.most) * d2.y * d2.y) / 2;
    const Wide xy = (Wide(b.least) * d1.x * d1.y + Wide(b.most) * d2.x * d2.y) / 2;
    const Wide away = sqrt((xx - yy) * (xx - yy) / 4 + xy * xy);
    const Wide most = (xx + yy) / 2 + away, least = (xx + yy) / 2 - away;
    const RelativeCurvature c = relative_curvature(a, b);
    worst = std::max({worst, std::abs(double(c.most / most - 1)), std::abs(double(c.least / least - 1)),
                      std::abs(double(c.radius_eff * 2 * sqrt(least * most) - 1))});
  }
  EXPECT_LT(worst, 1e-14);
}
#endif

TEST(Curvature, PairsOfKnownRadius) {
  RelativeCurvature c;
  const Vec3d n = shapes::normalized(Vec3d{1, -2, 3});
  ASSERT_TRUE(relative_curvature(body(Kind::sphere, {0.1, 0, 0}), body(Kind::sphere, {0.3, 0, 0}), n, c));
  EXPECT_NEAR(c.radius_eff / 0.075, 1, 1e-15);
  EXPECT_NEAR(c.least / c.most, 1, 1e-15);
  ASSERT_TRUE(relative_curvature(body(Kind::sphere, {0.1, 0, 0}), body(Kind::plane, {1, 0, 0}), n, c));
  EXPECT_NEAR(c.radius_eff / 0.1, 1, 1e-15);
  ASSERT_TRUE(relative_curvature(body(Kind::disc, {0.1, 0, 0}), body(Kind::line, {1, 0, 0}), {0.6, 0.8, 0}, c));
  EXPECT_NEAR(c.radius_eff / 0.1, 1, 1e-15);
  EXPECT_FALSE(relative_curvature(body(Kind::polyhedron, {1, 0, 0}), body(Kind::plane, {1, 0, 0}), n, c));
  EXPECT_FALSE(relative_curvature(body(Kind::plane, {1, 0, 0}), body(Kind::plane, {1, 0, 0}), n, c));
  // Crossed bodies, almost cylinders of one radius: a sphere of that radius on a flat; q → 1.
  const Vec3d needle{1e6, 1, 1};
  Mat3d crossed;
  crossed.row[0] = {0, -1, 0};
  crossed.row[1] = {1, 0, 0};
  crossed.row[2] = {0, 0, 1};
  ASSERT_TRUE(relative_curvature(body(Kind::ellipsoid, needle), body(Kind::ellipsoid, needle, crossed), {0, 0, 1}, c));
  EXPECT_NEAR(c.radius_eff, 1, 1e-11);
  EXPECT_NEAR(c.most / c.least, 1, 1e-11);
  // The ellipsoid of the equation sheet, 2, 1, 1 mm: on its side radii 4 and 1 mm, on its tip 0.5 mm.
  const Vec3d axes{2e-3, 1e-3, 1e-3};
  ASSERT_TRUE(relative_curvature(body(Kind::ellipsoid, axes), body(Kind::plane, {1, 0, 0}), {0, 0, -1}, c));
  EXPECT_NEAR(c.least * 2 * 4e-3, 1, 1e-15);
  EXPECT_NEAR(c.most * 2 * 1e-3, 1, 1e-15);
  EXPECT_NEAR(c.radius_eff / 2e-3, 1, 1e-15);
  EXPECT_NEAR(elliptical_hertz(c.most / c.least).axis_ratio, 0.399887, 5.1e-7);
  ASSERT_TRUE(relative_curvature(body(Kind::ellipsoid, axes), body(Kind::plane, {1, 0, 0}), {1, 0, 0}, c));
  EXPECT_NEAR(c.radius_eff / 0.5e-3, 1, 1e-15);
}

// k = 1 is a sphere; beyond one plane of α = (1 − k)/r² the body is an ellipsoid of revolution.
TEST(Curvature, PotentialParticles) {
  shapes::PotentialParticle p;
  p.sphere_weight = 1 / (0.2 * 0.2);
  p.planes.push_back({{0, 0, 1}, 10});
  Body b = body(Kind::potential_particle, {3, 0, 0});
  b.geometry = &p;
  Curvature c;
  ASSERT_TRUE(curvature(b, shapes::normalized(Vec3d{1, 2, 3}), c));
  EXPECT_NEAR(c.most, 1 / 0.6, 1e-14);
  EXPECT_NEAR(c.least, 1 / 0.6, 1e-14);
  // On the axis α(z − d)² + βz² = 1, with the radius (α(z − d) + βz)/β there.
  p.planes[0].offset = 0.1;
  p.plane_weight = 400;
  const double alpha = 400, beta = 25, d = 0.1;
  const double z =
      (alpha * d + std::sqrt(alpha * alpha * d * d - (alpha + beta) * (alpha * d * d - 1))) / (alpha + beta);
  ASSERT_TRUE(curvature(b, {0, 0, 1}, c));
  EXPECT_NEAR(c.most * 3 * (alpha * (z - d) + beta * z) / beta, 1, 1e-13);
  EXPECT_NEAR(c.least / c.most, 1, 1e-13);
}

TEST(Curvature, ChangeOfUnitsByPowersOfTwoKeepsTheBits) {
  Draw draw;
  for (int i = 0; i < 200; ++i) {
    const Vec3d one{draw.log_in(0.1, 10), draw.log_in(0.1, 10), draw.log_in(0.1, 10)}, n = draw.unit();
    const Vec3d two{draw.log_in(0.1, 10), draw.log_in(0.1, 10), draw.log_in(0.1, 10)};
    const Mat3d r1 = draw.rotation(), r2 = draw.rotation();
    RelativeCurvature c, d;
    ASSERT_TRUE(relative_curvature(body(Kind::ellipsoid, one, r1), body(Kind::ellipsoid, two, r2), n, c));
    const double l = std::ldexp(1.0, i % 2 == 0 ? -31 : 100);
    ASSERT_TRUE(relative_curvature(body(Kind::ellipsoid, one * l, r1), body(Kind::ellipsoid, two * l, r2), n, d));
    EXPECT_EQ(d.radius_eff, c.radius_eff * l);
    EXPECT_EQ(d.least * l, c.least);
    EXPECT_EQ(d.most * l, c.most);
  }
}

}  // namespace
}  // namespace contact
