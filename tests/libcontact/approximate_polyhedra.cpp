// Largest ball, analytic centre and clipped volume of polyhedra: closed forms, certificates, gradients.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "libcontact/dispatch.h"
#include "libcontact/methods/half_space_program.h"
#include "libcontact/methods/polyhedron_measure.h"
#include "shapes/math/quat.h"
#include "shapes/polyhedron_build.h"

namespace {

using namespace contact;
using shapes::Kind;

const shapes::Polyhedron& cube() {
  static const shapes::Polyhedron p = shapes::make_box({2, 2, 2});
  return p;
}
const std::vector<shapes::Polyhedron>& solids() {
  using enum shapes::Platonic;
  static const std::vector<shapes::Polyhedron> list{
      shapes::make_box({1, 1.5, 2}),         shapes::make_box({2, 2, 0.125}),
      shapes::make_platonic(tetrahedron, 1), shapes::make_platonic(octahedron, 1),
      shapes::make_platonic(icosahedron, 1), shapes::make_prism(7, 0.5, 1.5)};
  return list;
}

Body body(const shapes::Polyhedron& p, const Mat3d& rotation = Mat3d::identity()) {
  return {Kind::polyhedron, 0, &p, {1, 0, 0}, rotation};
}
Contact ask(const char* method, const Body& a, const Body& b, const Vec3d& d) { return query(a, b, d, {}, method); }

struct Draw {
  std::mt19937_64 engine{17};
  double uniform(double low, double high) {
    return low + (high - low) * (static_cast<double>(engine() >> 11) * 0x1p-53);
  }
  Vec3d vector() { return {uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)}; }
  Mat3d rotation() {
    return rotation_matrix(normalized(shapes::Quatd{uniform(-1, 1), uniform(-1, 1), uniform(-1, 1), uniform(0.1, 1)}));
  }
};

TEST(ConstrainedMinimisation, cubes_face_to_face) {
  for (const double overlap : {0.25, 1e-3, 1e-9}) {
    const Contact c = ask("constrained_minimisation", body(cube()), body(cube()), {2 - overlap, 0.25, -0.5});
    SCOPED_TRACE(overlap);
    EXPECT_FALSE(c.handed_over);
    EXPECT_NEAR(c.method_overlap, 0.5 * overlap, 64 * epsilon);  // the radius of the largest ball
    EXPECT_NEAR(c.gap, -overlap, 256 * epsilon);
    EXPECT_NEAR(c.method_normal.x, 1, 8 * epsilon);
    // The centre of a box whose other faces lie in pairs, at 2 and at 1.75 or 1.5 apart: of four planes each the
    // centre of symmetry.
    EXPECT_NEAR(c.method_point.x, 1 - 0.5 * overlap, 1e-9 * overlap + 16 * epsilon);
    EXPECT_NEAR(c.method_point.y, 0.125, 1e-8);
    EXPECT_NEAR(c.method_point.z, -0.25, 1e-8);
    EXPECT_EQ(c.status, Status::overlapping);
  }
  const Contact apart = ask("constrained_minimisation", body(cube()), body(cube()), {2.5, 0.25, 0});
  EXPECT_EQ(apart.status, Status::separated);
  EXPECT_NEAR(apart.gap, 0.5, 64 * epsilon);
  EXPECT_NEAR(apart.method_overlap, -0.25, 64 * epsilon);
}

TEST(ConstrainedMinimisation, a_body_inside_another_is_handed_over) {
  const shapes::Polyhedron small = shapes::make_box({0.25, 0.25, 0.25});
  const Contact c = ask("constrained_minimisation", body(cube()), body(small), {0.125, 0.25, 0});
  EXPECT_TRUE(c.handed_over);
  EXPECT_EQ(c.gap, query(body(cube()), body(small), {0.125, 0.25, 0}).gap);
}

Body plane() {
  Body b;
  b.kind = Kind::plane;
  return b;
}

TEST(ConstrainedMinimisation, a_cube_on_a_plane) {
  for (const double overlap : {0.25, 1e-6, 1e-12, -0.5}) {
    // The body's origin is its centre, at 1 − overlap over the plane.
    const Contact c = ask("constrained_minimisation", body(cube()), plane(), {0.5, 0.25, -1 + overlap});
    SCOPED_TRACE(overlap);
    EXPECT_FALSE(c.handed_over);
    EXPECT_NEAR(c.gap, -overlap, 64 * epsilon);
    EXPECT_NEAR(c.method_overlap, 0.5 * overlap, 64 * epsilon);
    EXPECT_TRUE(c.method_normal == (Vec3d{0, 0, -1}));
    EXPECT_EQ(c.status, overlap > 0 ? Status::overlapping : Status::separated);
    if (!(overlap > 0)) continue;
    EXPECT_NEAR(c.method_point.x, 0, 1e-8);
    EXPECT_NEAR(c.method_point.y, 0, 1e-8);
    // u over the lower face: 1/u = 1/(overlap − u) + 1/(2 − u), of the three planes along z.
    const double sum = 2 * overlap + 4, u = 4 * overlap / (sum + std::sqrt(sum * sum - 24 * overlap));
    EXPECT_NEAR(c.method_point.z, -1 + u, 1e-6 * overlap + 4 * epsilon);
  }
  // Wholly under the plane the ball is the cube's own.
  const Contact under = ask("constrained_minimisation", body(cube()), plane(), {0, 0, 5});
  EXPECT_FALSE(under.handed_over);
  EXPECT_NEAR(under.gap, -6, 64 * epsilon);
  EXPECT_NEAR(under.method_overlap, 1, 64 * epsilon);
}

// In a slab a million million times thinner than wide the second derivative is singular to rounding; the centre is not.
TEST(ConstrainedMinimisation, the_centre_of_a_thin_overlap_is_found) {
  Draw draw;
  for (int i = 0; i < 200; ++i) {
    const Body a = body(solids()[draw.engine() % solids().size()], draw.rotation());
    const Vec3d far = 3.0 * draw.vector();
    const Contact apart = query(a, plane(), far);
    const double overlap = std::pow(10.0, -draw.uniform(3, 12));
    const Contact c = ask("constrained_minimisation", a, plane(), far - (apart.gap + overlap) * apart.normal);
    SCOPED_TRACE(i);
    EXPECT_EQ(c.status, Status::overlapping);
    const Contact face = ask("constrained_minimisation", body(cube()), body(cube()), {2 - overlap, 1e-3 * i, 0.5});
    EXPECT_EQ(face.status, Status::overlapping);
    EXPECT_NEAR(face.method_point.y, 0.5e-3 * i, 1e-6);
  }
}

// Primal and dual meet; the ball is inside all planes; no other point has a larger one.
TEST(ConstrainedMinimisation, the_optimum_is_certified) {
  Draw draw;
  int overlapping = 0;
  for (int i = 0; i < 600; ++i) {
    const auto &a = solids()[draw.engine() % solids().size()], &b = solids()[draw.engine() % solids().size()];
    const PolyhedronPair pair{&a, &b, 1, 1, draw.rotation(), draw.uniform(0.1, 1.6) * draw.vector()};
    const double size = a.circumradius + b.circumradius + norm(pair.offset);
    const HalfSpaceOptimum best = largest_ball(pair, size);
    ASSERT_TRUE(best.converged) << i;
    EXPECT_LE(best.pivots, 60);
    EXPECT_NEAR(best.lower, best.upper, 64 * epsilon * size) << i;
    const auto slack = [&](const Vec3d& x) {
      return std::min(depth_in(a, 1, x), depth_in(b, 1, transposed_times(pair.other_to_self, x - pair.offset)));
    };
    EXPECT_NEAR(slack(best.x), best.lower, 32 * epsilon * size);
    for (int k = 0; k < 20; ++k)
      EXPECT_LE(slack(best.x + std::pow(10.0, -k % 5) * draw.vector()), best.upper + 64 * epsilon * size);
    // A sign of t is a proof: of separation along the multipliers, of overlap at x.
    if (!(norm(best.normal) > 1e-9)) continue;  // the ball touches one body alone
    const double separation = pair.separation(normalized(best.normal)).value;
    if (best.upper < -1e-12) {
      EXPECT_GT(separation, 0) << i;
    }
    if (best.lower > 1e-12) {
      EXPECT_LT(separation, 0);
      ++overlapping;
      Vec3d centre = best.x;
      int steps = 0;
      ASSERT_TRUE(analytic_centre(pair, centre, steps)) << i;
      EXPECT_GT(slack(centre), 0);
      EXPECT_LE(steps, 40);
    }
  }
  EXPECT_GT(overlapping, 100);
}

TEST(ClipVolume, closed_forms) {
  // A slab δ thick, 1.75 × 1.5, of two cubes shifted sideways: its two other pairs of sides count too.
  const double overlap = 0.125;
  const Contact slab = ask("clip_volume", body(cube()), body(cube()), {2 - overlap, 0.25, -0.5});
  EXPECT_FALSE(slab.handed_over);
  const Vec3d s{1.75 * 1.5, overlap * 1.5, -overlap * 1.75};
  EXPECT_NEAR(slab.method_overlap, overlap * 1.75 * 1.5 / norm(s), 32 * epsilon);
  EXPECT_LE(norm(slab.method_normal - s * (1 / norm(s))), 32 * epsilon);
  EXPECT_LE(norm(slab.method_point - Vec3d{1 - 0.5 * overlap, 0.125, -0.25}), 32 * epsilon);
  // A corner h deep in a face: V = A h/3.
  const double h = 0.25, r = 1 / std::sqrt(3.0);
  const Vec3d diagonal{r, r, r};
  // Turns the diagonal of the cube to −x.
  const Vec3d axis = normalized(cross(diagonal, Vec3d{-1, 0, 0}));
  const double angle = std::acos(-r);
  const Mat3d turn = rotation_matrix(shapes::Quatd{std::cos(angle / 2), std::sin(angle / 2) * axis.x,
                                                   std::sin(angle / 2) * axis.y, std::sin(angle / 2) * axis.z});
  const Contact corner = ask("clip_volume", body(cube()), body(cube(), turn), {1 + std::sqrt(3.0) - h, 0.125, 0});
  EXPECT_NEAR(corner.method_overlap, h / 3, 256 * epsilon);
  EXPECT_NEAR(corner.method_normal.x, 1, 8 * epsilon);
  EXPECT_NEAR(corner.gap, -h, 64 * epsilon);
  EXPECT_NEAR(corner.method_point.x, 1 - h / 4, 256 * epsilon);
  EXPECT_LE(corner.gap_upper, 0);
  EXPECT_TRUE(ask("clip_volume", body(cube()), body(cube()), {2.5, 0, 0}).handed_over);
}

// Shared volume does not depend on which body's faces are clipped by which, and it grows along the normal only.
TEST(ClipVolume, depth_falls_as_the_bodies_part) {
  Draw draw;
  int used = 0;
  for (int i = 0; i < 300; ++i) {
    const Body a = body(solids()[draw.engine() % solids().size()], draw.rotation()),
               b = body(solids()[draw.engine() % solids().size()], draw.rotation());
    const Vec3d d = draw.uniform(0.2, 1.2) * draw.vector();
    const Contact c = ask("clip_volume", a, b, d);
    if (c.handed_over) continue;
    ++used;
    const double length = circumradius(a) + circumradius(b);
    // The centroid of the overlap lies in both bodies, and the overlap ends within the depth along the normal.
    EXPECT_LE(c.gap_upper, 64 * epsilon * length);
    const Contact apart = ask("clip_volume", a, b, d + (1e-9 - c.gap) * c.normal);
    EXPECT_TRUE(apart.handed_over);
    EXPECT_EQ(apart.status, Status::separated);
  }
  EXPECT_GT(used, 50);
}

}  // namespace
