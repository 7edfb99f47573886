// Mass properties of unions: closed forms, agreement of the ways to integrate, Monte Carlo.
#include <gtest/gtest.h>

#include <cstdio>
#include <numbers>

#include "shapes/compound_build.h"
#include "shapes/compound_parts.h"
#include "shapes/geometry.h"
#include "shapes/polyhedron_build.h"
#include "shapes/quadrature.h"
#include "tests/shapes/support.h"

namespace {

using namespace shapes;
using shape_tests::Random;
constexpr double pi = std::numbers::pi;

CompoundPart ball(const Vec3d& centre, double radius) { return {Sphere{radius}, {centre, {}}}; }

TEST(Quadrature, knows_its_rules) {
  double kronrod = kronrod_weight[0], gauss = gauss_weight[0], second = 0;
  for (int k = 1; k < 8; ++k) {
    kronrod += 2 * kronrod_weight[k];
    gauss += 2 * gauss_weight[k];
    second += 2 * kronrod_weight[k] * kronrod_node[k] * kronrod_node[k];
  }
  EXPECT_NEAR(kronrod, 2, 4e-16);
  EXPECT_NEAR(gauss, 2, 4e-16);
  EXPECT_NEAR(second, 2.0 / 3.0, 4e-16);
  const auto half_disc = [](double x) { return std::array<double, 1>{std::sqrt(1 - x * x)}; };
  std::array<double, 1> sum{};
  const double error = integrate(half_disc, -1, 1, 2, {1e-12}, 20, sum) * 1e-12;
  EXPECT_NEAR(sum[0], pi / 2, 1e-14);
  EXPECT_LT(error, 1e-12);
}

// Two balls of radii R, r at a distance d along x: the union is two balls less a lens of two caps. A cap of the ball of
// radius R beyond the plane at x = a from its centre has
//   V = π (2R³/3 − R² a + a³/3),  ∫x = π (R² − a²)²/4,  ∫x² = π (2R⁵/15 − R² a³/3 + a⁵/5),
//   ∫y² = π/4 (8R⁵/15 − R⁴ a + 2R² a³/3 − a⁵/5)
struct Cap {
  double v, x, xx, yy;
  Cap(double R, double a)
      : v(pi * (2 * R * R * R / 3 - R * R * a + a * a * a / 3)),
        x(pi * std::pow(R * R - a * a, 2) / 4),
        xx(pi * (2 * std::pow(R, 5) / 15 - R * R * a * a * a / 3 + std::pow(a, 5) / 5)),
        yy(pi / 4 * (8 * std::pow(R, 5) / 15 - std::pow(R, 4) * a + 2 * R * R * a * a * a / 3 - std::pow(a, 5) / 5)) {}
};

TEST(CompoundMass, two_balls_have_a_closed_form) {
  double worst = 0;
  for (const double R : {1.0, 0.3})
    for (const double r : {0.25, 0.5, 0.99})
      for (const double d : {0.1, 0.4, 0.8, 1.1, 1.24}) {
        if (d >= R + r || d <= std::abs(R - r)) continue;
        // seen from each centre, the plane of the circle
        const double a = (d * d + R * R - r * r) / (2 * d), b = d - a;
        const Cap first(R, a), second(r, b);  // of the one towards the other, and back
        const double one = 4 * pi / 3 * R * R * R, two = 4 * pi / 3 * r * r * r;
        const double V = one + two - first.v - second.v;
        const double X = two * d - first.x - (second.v * d - second.x);
        const double XX =
            one * R * R / 5 + two * (r * r / 5 + d * d) - first.xx - (second.xx - 2 * d * second.x + d * d * second.v);
        const double YY = one * R * R / 5 + two * r * r / 5 - first.yy - second.yy;
        const double centre = X / V, xx = XX - V * centre * centre;
        for (const Vec3d& along : {Vec3d{1, 0, 0}, Vec3d{0, 0, 1}, normalized(Vec3d{1, -2, 0.7})}) {
          const Compound body =
              make_compound(std::vector{ball({0.1, 0.2, -0.3}, R), ball(Vec3d{0.1, 0.2, -0.3} + d * along, r)});
          ASSERT_EQ(body.parts.size(), 2u);
          const auto error = [&](double got, double expected) {
            worst = std::max(worst, std::abs(got / expected - 1));
            EXPECT_NEAR(got / expected, 1, 1e-10) << R << " " << r << " " << d;
          };
          error(body.mass.volume, V);
          for (int k = 0; k < 3; ++k)
            EXPECT_NEAR(body.frame.position[k], Vec3d({0.1, 0.2, -0.3})[k] + centre * along[k], 1e-10);
          const Mat3d& inertia = body.mass.inertia;
          const double x = inertia.row[0].x, y = inertia.row[1].y, z = inertia.row[2].z;
          error(std::min({x, y, z}), 2 * YY);  // about the line of the centres
          error(std::max({x, y, z}), xx + YY);
          error(x + y + z - std::min({x, y, z}), 2 * (xx + YY));
          EXPECT_LE(body.mass_error, 1e-9);
        }
      }
  std::printf("  largest relative error of two balls: %.1e\n", worst);
}

std::vector<compound::Part> random_balls(Random& random, int count) {
  std::vector<compound::Part> parts;
  for (int i = 0; i < count; ++i) {
    compound::Part p;
    p.centre = {random.uniform(-0.4, 0.4), random.uniform(-0.4, 0.4), random.uniform(-0.4, 0.4)};
    const double r = random.uniform(0.1, 0.4);
    p.size = {r, r, r};
    parts.push_back(p);
  }
  return parts;
}
std::vector<const compound::Part*> pointers(const std::vector<compound::Part>& parts) {
  std::vector<const compound::Part*> list;
  for (const auto& p : parts) list.push_back(&p);
  return list;
}
double largest_difference(const compound::Moments& a, const compound::Moments& b) {
  return std::max({std::abs(a.zeroth - b.zeroth), max_abs(a.first - b.first), max_abs(a.diagonal - b.diagonal),
                   max_abs(a.mixed - b.mixed)});
}

// Arcs of sections and lines in all directions are different ways: they agree to what the coarser one promises.
TEST(CompoundMass, many_balls_agree_with_lines) {
  Random random(11);
  double worst = 0;
  for (const int count : {2, 3, 7}) {
    const auto parts = random_balls(random, count);
    const auto list = pointers(parts);
    const compound::Moments arcs = compound::moments_of_balls(list), lines = compound::moments_by_lines(list);
    worst = std::max(worst, largest_difference(arcs, lines) / arcs.zeroth);
    EXPECT_LT(largest_difference(arcs, lines), 1e-6 * arcs.zeroth);
    EXPECT_LT(arcs.error, 1e-9 * arcs.zeroth);
    EXPECT_LT(lines.error, 1e-5 * lines.zeroth);
  }
  std::printf("  balls by arcs and by lines differ by %.1e\n", worst);
}

TEST(CompoundMass, overlapping_boxes_are_exact) {
  // A plus of three bars 1 × 1 × 3: V = 3·3 − 2, I from the parts: three bars less twice the common cube.
  const Compound plus = make_compound(
      std::vector<CompoundPart>{{make_box({3, 1, 1}), {}}, {make_box({1, 3, 1}), {}}, {make_box({1, 1, 3}), {}}});
  EXPECT_EQ(plus.parts.size(), 3u);
  EXPECT_EQ(plus.mass_error, 0);
  EXPECT_NEAR(plus.mass.volume, 7, 1e-14);
  const double moment = 3.0 * (2 * 10 + 2) / 12 - 2 * (1.0 / 6);
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(plus.mass.inertia.row[k][k], moment, 1e-14);
  EXPECT_LT(max_abs(plus.frame.position), 1e-15);
  EXPECT_TRUE(plus.frame.orientation.w == 1);
}

TEST(CompoundMass, turned_boxes_agree_with_lines) {
  Random random(3);
  for (int n = 0; n < 4; ++n) {
    std::vector<compound::Part> parts;
    for (int i = 0; i < 3; ++i) {
      compound::Part p;
      p.kind = Compound::PartKind::polyhedron;
      std::vector<Vec3d> points;
      const Mat3d r = rotation_matrix(random.rotation());
      const Vec3d at{random.uniform(-0.2, 0.2), random.uniform(-0.2, 0.2), random.uniform(-0.2, 0.2)};
      for (const Vec3d& v : make_box({0.3, 0.4, 0.7}).vertices) points.push_back(at + r * v);
      p.solid = polyhedron_from_points(points, Frame::as_given);
      parts.push_back(p);
    }
    const compound::Moments cells = compound::moments_of_union(parts),
                            lines = compound::moments_by_lines(pointers(parts));
    EXPECT_EQ(cells.error, 0);
    EXPECT_LT(largest_difference(cells, lines), 5e-6 * cells.zeroth);
  }
}

TEST(CompoundMass, mixed_parts_agree_with_monte_carlo) {
  const Compound body = make_compound(std::vector<CompoundPart>{
      {make_box({1.1, 0.7, 0.6}), {{0.3, 0.2, 0.1}, normalized(Quatd{0.9, 0.1, 0.2, 0.3})}},
      {Sphere{0.4}, {{0.9, 0.4, 0.1}, {}}},
      {Ellipsoid{{0.4, 0.3, 0.8}}, {{-0.3, 0.3, 0.2}, normalized(Quatd{0.8, 0.3, -0.2, 0.3})}}});
  ASSERT_EQ(body.parts.size(), 3u);
  EXPECT_LT(body.mass_error, 1e-5);
  EXPECT_GT(body.mass_error, 0);
  Random random(17);
  const double R = body.circumradius;
  const int samples = 3000000;
  double hits = 0, xx = 0, yy = 0, zz = 0;
  Vec3d first{};
  for (int i = 0; i < samples; ++i) {
    const Vec3d x{random.uniform(-R, R), random.uniform(-R, R), random.uniform(-R, R)};
    bool inside = false;
    for (const auto& p : body.parts) inside = inside || distance(p, x) < 0;
    if (!inside) continue;
    hits += 1;
    first += x;
    xx += x.x * x.x, yy += x.y * x.y, zz += x.z * x.z;
  }
  const double cell = 8 * R * R * R / samples;
  EXPECT_NEAR(hits * cell / body.mass.volume, 1, 0.01);
  EXPECT_LT(max_abs(first) / hits, 0.005 * R);
  EXPECT_NEAR((yy + zz) * cell / body.mass.inertia.row[0].x, 1, 0.02);
  EXPECT_NEAR((zz + xx) * cell / body.mass.inertia.row[1].y, 1, 0.02);
  EXPECT_NEAR((xx + yy) * cell / body.mass.inertia.row[2].z, 1, 0.02);
}

TEST(CompoundMass, parts_apart_add_up) {
  const Compound body = make_compound(std::vector<CompoundPart>{
      {make_box({2, 1, 1}), {}}, {Sphere{0.5}, {{1.5, 0, 0}, {}}}, {Ellipsoid{{0.5, 0.2, 0.3}}, {{-1.5, 0, 0}, {}}}});
  EXPECT_EQ(body.mass_error, 0);
  EXPECT_NEAR(body.mass.volume, 2 + 4 * pi / 3 * (0.125 + 0.03), 1e-14);
}

}  // namespace
