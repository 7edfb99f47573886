// Potential particles by constrained minimisation: balls in closed form, the conditions of the minimum, and the limit
// of a vanishing overlap.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "libcontact/dispatch.h"
#include "shapes/math/quat.h"
#include "shapes/potential_build.h"
#include "tests/shapes/potential_samples.h"

namespace {

using namespace contact;
using shapes::Kind;
using shapes::PotentialParticle;

Body body(const PotentialParticle& p, const Mat3d& rotation = Mat3d::identity()) {
  return {Kind::potential_particle, 0, &p, {1, 0, 0}, rotation};
}
Contact ask(const Body& a, const Body& b, const Vec3d& d, const char* method = "constrained_minimisation") {
  return query(a, b, d, {}, method);
}

struct Draw {
  std::mt19937_64 engine{23};
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
  const PotentialParticle& particle() {
    return shape_tests::potential_particles()[engine() % shape_tests::potential_particles().size()];
  }
};

// f = |x|²/R² − 1 of balls: equal where the distances are as the radii.
TEST(PotentialMinimisation, balls) {
  const auto planes = shape_tests::planes_of_faces(shapes::make_box({2, 2, 2}));
  const PotentialParticle ball = shapes::make_potential_particle(planes, 1, 1, 0.75, shapes::Frame::as_given, 1e-5);
  const double radius = ball.R;
  Body sphere;
  sphere.size = {0.5 * radius, 0, 0};
  const double distance = 1.25 * radius;
  const Contact c = ask(sphere, body(ball), {0.6 * distance, 0, 0.8 * distance});
  EXPECT_FALSE(c.handed_over);
  EXPECT_NEAR(c.gap, -0.25 * radius, 1e-14);
  EXPECT_NEAR(c.method_overlap, 0.25 * radius, 1e-12);
  EXPECT_NEAR(c.method_normal.x, 0.6, 1e-12);
  EXPECT_NEAR(norm(c.method_point), distance / 3, 1e-11);
}

// f_A = f_B with opposite gradients; as the overlap vanishes the measure and the separation tend to it.
TEST(PotentialMinimisation, the_point_is_the_minimum) {
  Draw draw;
  for (int i = 0; i < 100; ++i) {
    const PotentialParticle &p = draw.particle(), &q = draw.particle();
    const Body a = body(p, draw.rotation()), b = body(q, draw.rotation());
    Vec3d d = (p.circumradius + q.circumradius) * draw.direction();
    const Contact apart = query(a, b, d);
    const double overlap = 1e-6;
    d -= (apart.gap + overlap) * apart.normal;  // the least translation stays along this normal
    const Contact c = ask(a, b, d), exact = query(a, b, d);
    SCOPED_TRACE(i);
    EXPECT_FALSE(c.handed_over);
    EXPECT_NE(c.status, Status::not_converged);
    const auto level = [](const Body& at, const Vec3d& y) {
      const auto& shape = *static_cast<const PotentialParticle*>(at.geometry);
      auto l = shapes::level_at<double>(shape, transposed_times(at.rotation, y) - shape.centre);
      l.half_gradient = at.rotation * l.half_gradient;
      return l;
    };
    const auto la = level(a, c.method_point), lb = level(b, c.method_point - d);
    EXPECT_NEAR(la.g, lb.g, 1e-10);
    EXPECT_LT(la.g, 1);
    const double slopes = norm(la.half_gradient) * norm(lb.half_gradient);
    EXPECT_LE(norm(cross(la.half_gradient, lb.half_gradient)), 1e-6 * slopes);
    EXPECT_LT(dot(la.half_gradient, lb.half_gradient), 0);
    EXPECT_NEAR(c.gap, exact.gap, 0.05 * overlap);
    EXPECT_NEAR(c.method_overlap, overlap, 0.05 * overlap);
  }
}

// On a plane the gradient is along its normal, and as the overlap vanishes the measure is the overlap; of a ball
// always.
TEST(PotentialMinimisation, a_plane) {
  Draw draw;
  Body plane;
  plane.kind = Kind::plane;
  for (int i = 0; i < 100; ++i) {
    const PotentialParticle& p = draw.particle();
    const Body a = body(p, draw.rotation());
    plane.rotation = draw.rotation();
    const Vec3d normal = plane.rotation.column(2);
    const double overlap = i % 2 == 0 ? 1e-6 : 0.05 * p.inner_radius;
    Vec3d d = 2.0 * draw.direction();
    d -= (query(a, plane, d).gap + overlap) * -normal;
    const Contact c = ask(a, plane, d);
    SCOPED_TRACE(i);
    EXPECT_FALSE(c.handed_over);
    EXPECT_EQ(c.status, Status::overlapping);
    EXPECT_NEAR(c.gap, -overlap, 1e-13);
    EXPECT_NEAR(dot(normal, c.method_point - d), 0, 1e-14);  // on the plane
    const auto l = shapes::level_at<double>(p, transposed_times(a.rotation, c.method_point) - p.centre);
    EXPECT_LT(l.g, 1);
    const Vec3d slope = a.rotation * l.half_gradient;
    EXPECT_LE(norm(cross(slope, normal)), 1e-8 * norm(slope));
    EXPECT_LT(dot(slope, normal), 0);
    EXPECT_LE(c.method_overlap, overlap + 1e-13);  // the deepest point lies at most beside the line
    if (i % 2 == 0) {
      EXPECT_NEAR(c.method_overlap, overlap, 0.05 * overlap);
    }
  }
  const auto planes = shape_tests::planes_of_faces(shapes::make_box({2, 2, 2}));
  const PotentialParticle ball = shapes::make_potential_particle(planes, 1, 1, 0.75, shapes::Frame::as_given, 1e-5);
  plane.rotation = Mat3d::identity();
  const Contact c = ask(body(ball), plane, {0.5, 0.25, -0.8 * ball.R});
  EXPECT_NEAR(c.method_overlap, 0.2 * ball.R, 1e-14);
  EXPECT_LE(norm(c.method_point - Vec3d{0, 0, -0.8 * ball.R}), 1e-12);
}

}  // namespace
