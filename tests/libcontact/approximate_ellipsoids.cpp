// The classical measures of ellipsoids and ellipses: closed forms, their limits against the true overlap as it
// vanishes, and what their bounds are worth.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "libcontact/dispatch.h"
#include "shapes/math/quat.h"

namespace {

using namespace contact;
using shapes::Kind;

Body round(Kind kind, const Vec3d& axes, const Mat3d& rotation = Mat3d::identity()) {
  Body b;
  b.kind = kind;
  b.size = axes;
  b.rotation = rotation;
  return b;
}
Mat3d about_z(double t) { return {{{std::cos(t), -std::sin(t), 0}, {std::sin(t), std::cos(t), 0}, {0, 0, 1}}}; }

const std::vector<std::string> of_ellipses{"geometric_potential", "perram_wertheim", "common_normal",
                                           "intersection_midpoint"};

TEST(ApproximateEllipsoids, all_measures_of_balls_are_the_overlap) {
  for (const Kind kind : {Kind::ellipse, Kind::ellipsoid})
    for (const std::string& method : of_ellipses) {
      if (contact::find(kind, kind, method) == nullptr) continue;
      const Body a = round(kind, {1, 1, kind == Kind::ellipse ? 0.0 : 1}),
                 b = round(kind, {2, 2, kind == Kind::ellipse ? 0.0 : 2});
      for (const double distance : {1.25, 2.75, 4.0}) {
        const Contact c = query(a, b, {0.6 * distance, 0.8 * distance, 0}, {}, method);
        SCOPED_TRACE(method + " " + std::to_string(distance));
        EXPECT_NEAR(c.gap, distance - 3, 32 * epsilon);
        EXPECT_NEAR(c.method_overlap, 3 - distance, 64 * epsilon);
        EXPECT_NEAR(c.method_normal.x, 0.6, 16 * epsilon);
        EXPECT_NEAR(c.method_normal.y, 0.8, 16 * epsilon);
        EXPECT_LE(c.gap_upper - c.gap_lower, 1e-13);
      }
    }
}

// Two crossing unit circles have the chord x = 1/2; others than two crossings are handed over.
TEST(ApproximateEllipsoids, intersection_midpoint_hands_over_but_for_two_crossings) {
  const Body circle = round(Kind::ellipse, {1, 1, 0}), flat = round(Kind::ellipse, {2, 0.5, 0});
  const auto ask = [](const Body& a, const Body& b, const Vec3d& d) {
    return query(a, b, d, {}, "intersection_midpoint");
  };
  const Contact two = ask(circle, circle, {1, 0, 0});
  EXPECT_FALSE(two.handed_over);
  EXPECT_NEAR(two.method_overlap, 1, 8 * epsilon);
  EXPECT_NEAR(two.method_point.x, 0.5, 8 * epsilon);
  for (const auto& [a, b, d] : {std::tuple{circle, circle, Vec3d{3, 0, 0}},
                                {circle, circle, Vec3d{2, 0, 0}},
                                {circle, flat, Vec3d{0.1, 0, 0}},
                                {flat, flat, Vec3d{0, 0, 0}}}) {
    const Contact c = ask(a, b, d), exact = query(a, b, d);
    EXPECT_TRUE(c.handed_over);
    EXPECT_EQ(c.gap, exact.gap);
    EXPECT_EQ(c.method_overlap, -exact.gap);
  }
}

// Of two parallel ellipses alike, both potential points and the growth of both lie on the line of centres: with
// |D⁻¹ d| = 2 − ε the measure is |d| (2/|D⁻¹ d| − 1), at any depth. As the overlap vanishes that is |S n|/(n·S n) of
// it, S = D², at most (q + 1/q)/2 at aspect ratio q, and off the normal n by the angle between S n and n.
TEST(ApproximateEllipsoids, closed_form_of_parallel_ellipses) {
  for (const double aspect : {2.0, 3.0, 10.0, 100.0}) {
    const Vec3d axes{1, 1 / aspect, 0};
    const Body a = round(Kind::ellipse, axes, about_z(0.375)), b = a;
    double most = 0;
    for (int i = 1; i < 60; ++i) {
      // One of them where the measure is at its largest.
      const double t = i == 1 ? std::atan(aspect) : M_PI / 2 * i / 60, overlap = 1e-5 / (aspect * aspect);
      const Vec3d n{std::cos(t), std::sin(t), 0}, sn{axes.x * axes.x * n.x, axes.y * axes.y * n.y, 0};
      const Vec3d d = (2 / std::sqrt(dot(sn, n))) * sn - overlap * n;
      const double scaled_distance = std::hypot(d.x / axes.x, d.y / axes.y);
      const double measure = norm(d) * (2 / scaled_distance - 1);
      const auto ask = [&](const char* name) { return query(a, b, a.rotation * d, {}, name); };
      for (const char* name : {"geometric_potential", "perram_wertheim"})
        EXPECT_NEAR(ask(name).method_overlap, measure, 1e-14 * aspect) << name << aspect << " " << i;
      const double ratio = ask("geometric_potential").method_overlap / overlap, limit = norm(sn) / dot(sn, n);
      EXPECT_NEAR(ratio, limit, 2e-3 * limit) << aspect << " " << i;
      EXPECT_NEAR(dot(ask("geometric_potential").method_normal, a.rotation * n), 1 / limit, 1e-3);
      most = std::max(most, ratio);
      // These two tend to the overlap.
      EXPECT_NEAR(ask("common_normal").method_overlap, overlap, 1e-13);
      EXPECT_NEAR(ask("intersection_midpoint").method_overlap, overlap, 2e-3 * overlap) << aspect << " " << i;
      // And so does the separation along the normal of each, well within its bounds.
      for (const std::string& name : of_ellipses) {
        const Contact c = ask(name.c_str());
        EXPECT_NEAR(c.gap, -overlap, 2e-3 * overlap) << name << aspect << " " << i;
        EXPECT_EQ(c.status, Status::overlapping) << name << aspect << " " << i;
      }
    }
    EXPECT_NEAR(most, 0.5 * (aspect + 1 / aspect), 1e-3 * most);
  }
}

// Any orientation and contact direction: the measures of common_normal and intersection_midpoint tend to the overlap,
// those of geometric_potential and perram_wertheim do not, and are never less.
TEST(ApproximateEllipsoids, limits_as_the_overlap_vanishes) {
  std::mt19937_64 engine(5);
  const auto uniform = [&](double low, double high) {
    return low + (high - low) * (static_cast<double>(engine() >> 11) * 0x1p-53);
  };
  const auto support = [](const Body& e, const Vec3d& n) {
    const Vec3d u = scaled(e.size, transposed_times(e.rotation, n));
    return e.rotation * scaled(e.size, u * (1 / norm(u)));
  };
  const auto turn = [&] {
    return rotation_matrix(normalized(shapes::Quatd{uniform(-1, 1), uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)}));
  };
  for (const Kind kind : {Kind::ellipse, Kind::ellipsoid})
    for (const double aspect : {2.0, 10.0}) {
      std::vector<double> potential;
      for (int i = 0; i < 400; ++i) {
        const bool flat = kind == Kind::ellipse;
        const Vec3d axes{1, 1 / aspect, flat ? 0 : 1 / uniform(1, aspect)};
        const Body a = round(kind, axes, flat ? about_z(uniform(-3, 3)) : turn()),
                   b = round(kind, axes, flat ? about_z(uniform(-3, 3)) : turn());
        const Vec3d n = normalized(Vec3d{uniform(-1, 1), uniform(-1, 1), flat ? 0 : uniform(-1, 1)});
        const double overlap = 1e-5 / (aspect * aspect);
        const Vec3d d = support(a, n) - support(b, -n) - overlap * n;
        for (const std::string& name : of_ellipses) {
          if (contact::find(kind, kind, name) == nullptr) continue;
          const Contact c = query(a, b, d, {}, name);
          SCOPED_TRACE(name + " " + std::to_string(i));
          EXPECT_NEAR(c.gap, -overlap, 2e-2 * overlap);
          const double ratio = c.method_overlap / overlap;
          if (name == "geometric_potential") potential.push_back(ratio);
          if (name[0] == 'c' || name[0] == 'i') {
            EXPECT_NEAR(ratio, 1, 2e-2);
          } else {
            EXPECT_GT(ratio, 0.98);
            EXPECT_LT(ratio, 0.51 * (aspect + 1 / aspect));
          }
        }
      }
      std::sort(potential.begin(), potential.end());
      EXPECT_GT(potential[potential.size() / 2], 1.01);
      EXPECT_GT(potential.back(), 1.15);
    }
}

}  // namespace
