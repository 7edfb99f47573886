// Pairs on which the fuzzers found a fault, as they were found.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "libcontact/dispatch.h"
#include "shapes/math/quat.h"
#include "shapes/polygon_build.h"

namespace {

using namespace contact;
using shapes::Kind;

double height(const Body& e, const Vec3d& n) { return norm(scaled(e.size, transposed_times(e.rotation, n))); }

// Coaxial spheroids, one deep in the other: f hardly curves, and the last step of Newton's method led away from the
// direction that `gap_lower` was proven along.
TEST(FoundByFuzz, the_normal_of_deep_spheroids_keeps_the_lower_bound) {
  Body a, b;
  a.kind = b.kind = Kind::ellipsoid;
  a.size = {0.093209229359639573, 0.093209229359639573, 1.0129434196817901};
  b.size = {39.00049512820614, 39.00049512820614, 102.75073920907261};
  a.rotation = rotation_matrix(shapes::Quatd{0.70710678118654746, 0.70710678118654746, 0, 0});
  b.rotation = rotation_matrix(shapes::normalized(
      shapes::Quatd{0.70710678118654668, 0.70710678118654846, 2.677039325391471e-15, 1.3719490572503684e-15}));
  const Vec3d offset{0, 26.440228676195503, 0};
  const Contact c = query(a, b, offset);
  const double along = dot(c.normal, offset) - height(a, c.normal) - height(b, c.normal);
  EXPECT_GE(along, c.gap_lower - 16 * epsilon * 130);
}

// An ellipse about the centre of a rhombus: opposite corners are equally good, and the witness point was on the wrong
// one.
TEST(FoundByFuzz, witness_points_of_an_ellipse_about_the_centre_of_a_polygon_are_as_far_apart_as_the_gap) {
  const shapes::Polygon rhombus =
      shapes::polygon_hull(std::vector<Vec3d>{{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}});
  Body a, b;
  a.kind = Kind::ellipse;
  a.size = {1.0011173035608703, 0.4522913028970106, 0};
  b.kind = Kind::polygon;
  b.geometry = &rhombus;
  b.size = {1, 0, 0};
  const Contact c = query(a, b, {0, 0, 0});
  EXPECT_NEAR(c.gap, -1.4522913028970106, 1e-13);
  EXPECT_NEAR(norm(c.point_b - c.point_a), 1.4522913028970106, 1e-13);
  EXPECT_NEAR(dot(c.point_b - c.point_a, c.normal), c.gap, 1e-13);
}

}  // namespace
