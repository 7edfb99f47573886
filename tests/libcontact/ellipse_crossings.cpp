// Counts and points of the crossings of two ellipses: closed forms, and a scan of one outline against the other.
#include "libcontact/methods/ellipse_crossings.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace {

using namespace contact;

struct Ellipse {
  double a, b, angle;
};

QuadricPair pair_of(const Ellipse& p, const Ellipse& q, const Vec3d& d) {
  const auto turn = [](double t) {
    return Mat3d{{{std::cos(t), -std::sin(t), 0}, {std::sin(t), std::cos(t), 0}, {0, 0, 1}}};
  };
  return {{p.a, p.b, std::max(p.a, p.b)},
          {q.a, q.b, std::max(q.a, q.b)},
          turn(p.angle),
          turn(q.angle),
          d,
          norm(d),
          1,
          true};
}

EllipseCrossings cross(const Ellipse& p, const Ellipse& q, const Vec3d& d) {
  return ellipse_crossings(unit_ball_space(pair_of(p, q, d)));
}

TEST(EllipseCrossings, counts_of_circles_and_concentric_ellipses) {
  EXPECT_EQ(cross({1, 1, 0}, {1, 1, 0}, {3, 0, 0}).count, 0);        // apart
  EXPECT_EQ(cross({3, 3, 0}, {1, 1, 0}, {0.5, 0.25, 0}).count, 0);   // contained
  EXPECT_EQ(cross({1, 1, 0}, {1, 1, 0}, {1, 0.5, 0}).count, 2);      // two
  EXPECT_TRUE(cross({2, 1, 0}, {2, 1, 0}, {0, 0, 0}).everywhere);    // one outline
  EXPECT_TRUE(cross({1, 1, 0}, {1, 1, 0.3}, {0, 0, 0}).everywhere);  // of circles too
  EXPECT_EQ(cross({2, 1, 0}, {1, 2, 0}, {0, 0, 0}).count, 4);        // a cross
  EXPECT_EQ(cross({2, 1, 0}, {2, 1, 0.01}, {0, 0, 0}).count, 4);     // hardly turned
  EXPECT_EQ(cross({2, 1, 0}, {2, 1, 0.5}, {0.125, 0, 0}).count, 4);
  EXPECT_EQ(cross({2, 1, 0}, {2, 1, 0}, {0.125, 0.25, 0}).count, 2);
  const EllipseCrossings outside = cross({1, 1, 0}, {2, 0.5, 0}, {3, 0, 0}),
                         inside = cross({2, 2, 0}, {1, 0.5, 0}, {1, 0, 0});
  EXPECT_EQ(outside.count, 1);
  EXPECT_EQ(outside.tangencies, 1);
  EXPECT_EQ(inside.count, 1);
  EXPECT_EQ(inside.tangencies, 1);
  // A circle through the tip of an ellipse that it crosses twice more, from inside.
  const EllipseCrossings three = cross({2, 1, 0}, {1.5, 1.5, 0}, {0.5, 0, 0});
  EXPECT_EQ(three.count, 3);
  EXPECT_EQ(three.tangencies, 1);
}

TEST(EllipseCrossings, points_of_two_circles) {
  const EllipseCrossings c = cross({1, 1, 0}, {1, 1, 0}, {1, 0, 0});
  ASSERT_EQ(c.count, 2);
  for (int i = 0; i < 2; ++i) {
    EXPECT_NEAR(c.point[i].x, 0.5, 4 * epsilon);
    EXPECT_NEAR(std::abs(c.point[i].y), std::sqrt(0.75), 4 * epsilon);
    EXPECT_EQ(c.point[i].z, 0);
  }
  EXPECT_LT(c.point[0].y * c.point[1].y, 0);
}

// Changes of side along B's outline in 20000 steps are a lower bound of the count, and all but always the count.
TEST(EllipseCrossings, agree_with_a_scan) {
  std::mt19937_64 engine(11);
  const auto uniform = [&](double low, double high) {
    return low + (high - low) * (static_cast<double>(engine() >> 11) * 0x1p-53);
  };
  int seen[5] = {}, differ = 0;
  for (int i = 0; i < 300; ++i) {
    const double aspect = i % 3 == 0 ? 1.5 : i % 3 == 1 ? 10 : 100;
    const Ellipse p{1, 1 / uniform(1, aspect), uniform(-3, 3)},
        q{uniform(0.3, 1), uniform(0.3, 1) / aspect, uniform(-3, 3)};
    const Vec3d d{uniform(-1, 1), uniform(-1, 1), 0};
    const QuadricPair pair = pair_of(p, q, d);
    const EllipseCrossings found = ellipse_crossings(unit_ball_space(pair));
    ASSERT_FALSE(found.everywhere);
    ASSERT_LE(found.count, 4);
    // Each body's axes are seen through the other's: rounding grows by both aspect ratios.
    const double tolerance = 8 * epsilon * (p.a / p.b) * (q.a / q.b);
    for (int k = 0; k < found.count; ++k) {
      EXPECT_NEAR(quadric_value(pair.axes_a, pair.rotation_a, found.point[k]), 1, tolerance) << i;
      EXPECT_NEAR(quadric_value(pair.axes_b, pair.rotation_b, found.point[k] - d), 1, tolerance) << i;
    }
    constexpr int steps = 20000;
    int changes = 0;
    bool last = false;
    for (int k = 0; k <= steps; ++k) {
      const double t = 2 * M_PI * k / steps;
      const Vec3d x = d + pair.rotation_b * Vec3d{q.a * std::cos(t), q.b * std::sin(t), 0};
      const bool inside = quadric_value(pair.axes_a, pair.rotation_a, x) < 1;
      changes += k > 0 && inside != last;
      last = inside;
    }
    EXPECT_GE(found.count, changes) << i;
    differ += found.count != changes;
    ++seen[found.count];
  }
  EXPECT_LE(differ, 2);
  EXPECT_GT(seen[0], 20);
  EXPECT_GT(seen[2], 20);
  EXPECT_GT(seen[4], 5);
}

}  // namespace
