// Exact parts of balls, cylinders, discs and solids: two closed forms against each other, against numerical
// integration and against what parts must add up to.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "libdem/analysis/cut_solid.h"
#include "libdem/analysis/round_in_box.h"
#include "libdem/random.h"
#include "shapes/quadrature.h"

namespace dem::analysis {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double ball = 4 * pi / 3;

Vec3d random_point(Random& random, double half) {
  const double x = random.uniform(-half, half), y = random.uniform(-half, half);
  return {x, y, random.uniform(-half, half)};
}
Vec3d random_unit(Random& random) {
  for (;;) {
    const Vec3d v = random_point(random, 1);
    if (dot(v, v) > 0.01 && dot(v, v) < 1) return normalized(v);
  }
}

TEST(AnalysisCutSolid, TwoClosedFormsOfABallInABoxAgree) {
  Random random(3, 0, 0);
  for (int t = 0; t < 20000; ++t) {
    const Vec3d a = random_point(random, 1.3), b = random_point(random, 1.3);
    Vec3d lower{}, upper{};
    for (int k = 0; k < 3; ++k) lower[k] = std::min(a[k], b[k]), upper[k] = std::max(a[k], b[k]);
    const double v = volume_in_ball(CutSolid::box(lower, upper), RoundFrame{});
    ASSERT_NEAR(ball_in_box({}, 1, lower, upper), v, 2e-14);
  }
}

TEST(AnalysisCutSolid, FacesEdgesAndCornersThroughTheCentreOrTouching) {
  // Every combination of planes that touch the ball, miss it, or go through its centre.
  const double at[] = {-2, -1, -0.6, 0, 0.6, 1, 2};
  for (const double x0 : at)
    for (const double x1 : at)
      for (const double y0 : at)
        for (const double y1 : at) {
          if (!(x0 < x1) || !(y0 < y1)) continue;
          for (const double z : {-1.0, 0.0, 0.5}) {
            const Vec3d lower{x0, y0, z}, upper{x1, y1, 1.5};
            ASSERT_NEAR(ball_in_box({}, 1, lower, upper), volume_in_ball(CutSolid::box(lower, upper), RoundFrame{}),
                        2e-14);
          }
        }
  EXPECT_NEAR(ball_in_box({}, 1, {0, 0, 0}, {2, 2, 2}), ball / 8, 1e-15);
  EXPECT_NEAR(ball_in_box({}, 1, {-2, -2, 0.25}, {2, 2, 2}), pi / 3 * 0.75 * 0.75 * 2.25, 1e-15);
}

TEST(AnalysisCutSolid, BelowOnePlane) {
  for (double h = -1.2; h < 1.3; h += 0.1) {
    EXPECT_NEAR(unit_ball_below(h), ball_in_box({}, 1, {-2, -2, -2}, {2, 2, h}), 1e-15);
    EXPECT_NEAR(unit_disc_below(h), disc_in_box({}, 1, {-2, -2, 0}, {2, h, 0}), 1e-15);
  }
}

TEST(AnalysisCutSolid, PartsOfABallAddUp) {
  Random random(4, 0, 0);
  for (int t = 0; t < 200; ++t) {
    const Vec3d centre = random_point(random, 0.5);
    const double radius = random.uniform(0.1, 1.4), edge = 0.5;
    double sum = 0, general = 0;
    for (int i = -4; i < 4; ++i)
      for (int j = -4; j < 4; ++j)
        for (int k = -4; k < 4; ++k) {
          const Vec3d lower{i * edge, j * edge, k * edge}, upper = lower + Vec3d{edge, edge, edge};
          sum += ball_in_box(centre, radius, lower, upper);
          general += volume_in_ball(CutSolid::box(lower, upper),
                                    round_frame(centre, Mat3d::identity(), {radius, radius, radius}));
        }
    EXPECT_NEAR(sum / (ball * std::pow(radius, 3)), 1, 1e-13);
    EXPECT_NEAR(general / (ball * std::pow(radius, 3)), 1, 1e-13);
  }
}

// ∫ of the sections of a ball with a rectangle, by the closed form of a disc in a rectangle.
double by_sections(double lower_z, double upper_z, const Vec3d& lower, const Vec3d& upper) {
  std::array<double, 1> sum{};
  std::vector<double> breaks{lower_z, upper_z};
  const auto add = [&](double square) {
    if (!(square > 0)) return;
    for (const double z : {-std::sqrt(square), std::sqrt(square)})
      if (z > lower_z && z < upper_z) breaks.push_back(z);
  };
  for (const double x : {0.0, lower.x, upper.x})
    for (const double y : {0.0, lower.y, upper.y}) add(1 - x * x - y * y);
  std::sort(breaks.begin(), breaks.end());
  auto area = [&](double z) {
    const double square = 1 - z * z;
    return std::array{square > 0 ? disc_in_box({}, std::sqrt(square), lower, upper) : 0};
  };
  for (std::size_t i = 0; i + 1 < breaks.size(); ++i)
    shapes::integrate(area, breaks[i], breaks[i + 1], 2.0, std::array{1e-13}, 20, sum);
  return sum[0];
}

TEST(AnalysisCutSolid, BallInBoxIsTheIntegralOfItsSections) {
  Random random(5, 0, 0);
  for (int t = 0; t < 200; ++t) {
    const Vec3d a = random_point(random, 1), b = random_point(random, 1);
    Vec3d lower{}, upper{};
    for (int k = 0; k < 3; ++k) lower[k] = std::min(a[k], b[k]), upper[k] = std::max(a[k], b[k]);
    ASSERT_NEAR(ball_in_box({}, 1, lower, upper), by_sections(lower.z, upper.z, lower, upper), 1e-12);
  }
}

TEST(AnalysisCutSolid, DiscInRectangleAgreesWithTheSumOverEdges) {
  Random random(6, 0, 0);
  for (int t = 0; t < 5000; ++t) {
    const Vec3d a = random_point(random, 1.2), b = random_point(random, 1.2);
    const double x0 = std::min(a.x, b.x), x1 = std::max(a.x, b.x), y0 = std::min(a.y, b.y), y1 = std::max(a.y, b.y);
    DiscSums sums;
    add_edge_in_disc(x0, y0, x1, y0, 1, sums);
    add_edge_in_disc(x1, y0, x1, y1, 1, sums);
    add_edge_in_disc(x1, y1, x0, y1, 1, sums);
    add_edge_in_disc(x0, y1, x0, y0, 1, sums);
    ASSERT_NEAR(sums.area, disc_in_box({}, 1, {x0, y0, 0}, {x1, y1, 0}), 1e-14);
    // The first moment is the integral of the area beyond.
    std::array<double, 1> moment{};
    auto strip = [&](double x) {
      const double half = std::sqrt(std::max(0.0, 1 - x * x));
      return std::array{x * std::max(0.0, std::min(y1, half) - std::max(y0, -half))};
    };
    if (t % 20 != 0) continue;
    std::vector<double> breaks{std::clamp(x0, -1.0, 1.0), std::clamp(x1, -1.0, 1.0)};
    for (const double y : {y0, y1})
      if (y * y < 1)
        for (const double x : {-std::sqrt(1 - y * y), std::sqrt(1 - y * y)})
          if (x > breaks[0] && x < breaks[1]) breaks.push_back(x);
    std::sort(breaks.begin(), breaks.end());
    for (std::size_t i = 0; i + 1 < breaks.size(); ++i)
      shapes::integrate(strip, breaks[i], breaks[i + 1], 2.0, std::array{1e-13}, 20, moment);
    ASSERT_NEAR(sums.x, moment[0], 1e-12);
  }
}

TEST(AnalysisCutSolid, PiecesOfASolidAddUp) {
  Random random(7, 0, 0);
  for (int t = 0; t < 300; ++t) {
    std::vector<CutSolid> pieces{CutSolid::of(shapes::make_prism(3 + t % 5, 0.8, 1.1))};
    const double whole = pieces[0].volume();
    for (int cut = 0; cut < 5; ++cut) {
      const Vec3d n = random_unit(random);
      const double offset = random.uniform(-0.3, 0.3);
      std::vector<CutSolid> next;
      for (const CutSolid& p : pieces)
        for (const double sign : {1.0, -1.0}) {
          next.push_back(p);
          next.back().cut(sign * n, sign * offset);
          if (next.back().empty()) next.pop_back();
        }
      pieces = std::move(next);
    }
    double sum = 0;
    for (const CutSolid& p : pieces) sum += p.volume();
    EXPECT_NEAR(sum, whole, 1e-14);
    EXPECT_GT(pieces.size(), 5u);
  }
}

TEST(AnalysisCutSolid, CutsThroughFacesEdgesAndCorners) {
  const auto cube = [] { return CutSolid::box({0, 0, 0}, {1, 1, 1}); };
  const auto after = [&](const Vec3d& n, double offset) {
    CutSolid s = cube();
    s.cut(normalized(n), offset / norm(n));
    return s.volume();
  };
  EXPECT_EQ(after({1, 0, 0}, 1), 1);                 // along a face, the solid kept
  EXPECT_EQ(after({-1, 0, 0}, -1), 0);               // and not kept
  EXPECT_NEAR(after({1, 1, 0}, 1), 0.5, 1e-15);      // through two edges
  EXPECT_NEAR(after({1, 1, 1}, 1), 1.0 / 6, 1e-15);  // through three corners
  EXPECT_NEAR(after({1, 1, 1}, 2), 5.0 / 6, 1e-15);
  EXPECT_NEAR(after({1, -1, 0}, 0), 0.5, 1e-15);
  EXPECT_NEAR(after({1, 1, 1}, 3), 1, 1e-15);  // a corner
}

TEST(AnalysisCutSolid, EllipsoidsAreBallsInOtherCoordinates) {
  // Three planes along conjugate directions through the centre: an eighth of any ellipsoid.
  Random random(8, 0, 0);
  for (int t = 0; t < 100; ++t) {
    const Vec3d axes{random.uniform(0.01, 1), random.uniform(0.01, 1), random.uniform(0.01, 1)};
    const Vec3d z = random_unit(random);
    Vec3d x, y;
    tangent_frame(z, x, y);
    const Mat3d turn{{{x.x, y.x, z.x}, {x.y, y.y, z.y}, {x.z, y.z, z.z}}};
    const Vec3d centre = random_point(random, 1);
    const RoundFrame frame = round_frame(centre, turn, axes);
    CutSolid s = CutSolid::box(centre - Vec3d{2, 2, 2}, centre + Vec3d{2, 2, 2});
    const double whole = ball * axes.x * axes.y * axes.z;
    EXPECT_NEAR(volume_in_ball(s, frame) / whole, 1, 1e-12);
    for (const Vec3d& n : {x, y, z}) s.cut(n, dot(n, centre));
    EXPECT_NEAR(volume_in_ball(s, frame) / whole, 0.125, 1e-12);
  }
}

TEST(AnalysisCutSolid, CylindersCutByBoxes) {
  Random random(9, 0, 0);
  // A slanted plane cuts half of a stretch that is centred on it.
  for (int t = 0; t < 200; ++t) {
    const Vec3d along = random_unit(random), n = random_unit(random), middle = random_point(random, 0.2);
    if (std::fabs(dot(n, along)) < 0.3) continue;
    CutSolid s = CutSolid::box({-9, -9, -9}, {9, 9, 9});
    s.cut(along, dot(along, middle) + 4);
    s.cut(-along, -dot(along, middle) + 4);
    EXPECT_NEAR(volume_in_cylinder(s, middle, along, 0.5), 8 * pi * 0.25, 1e-12);
    s.cut(n, dot(n, middle));
    EXPECT_NEAR(volume_in_cylinder(s, middle, along, 0.5), 4 * pi * 0.25, 1e-12);
  }
  // Boxes that fill space share a finite piece out among them.
  for (int t = 0; t < 30; ++t) {
    const Vec3d along = random_unit(random), middle = random_point(random, 0.2);
    double sum = 0;
    for (int i = -3; i < 3; ++i)
      for (int j = -3; j < 3; ++j)
        for (int k = -3; k < 3; ++k) {
          CutSolid s = CutSolid::box({i * 0.5, j * 0.5, k * 0.5}, {(i + 1) * 0.5, (j + 1) * 0.5, (k + 1) * 0.5});
          s.cut(along, dot(along, middle) + 0.6);
          s.cut(-along, -dot(along, middle) + 0.6);
          sum += volume_in_cylinder(s, middle, along, 0.4);
        }
    EXPECT_NEAR(sum, 1.2 * pi * 0.16, 1e-12);
  }
}

}  // namespace
}  // namespace dem::analysis
