// Potential particles against what is known otherwise: spheres, ellipsoids, planes, and all directions that there are.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "libcontact/dispatch.h"
#include "shapes/math/quat.h"
#include "shapes/mesh_generate.h"
#include "tests/shapes/potential_samples.h"

namespace {

using namespace contact;
using shape_tests::planes_of_faces;
using shapes::Kind;
using shapes::PotentialParticle;

struct Draw {
  std::mt19937_64 engine{7};
  double uniform(double low, double high) {
    return low + (high - low) * (static_cast<double>(engine() >> 11) * 0x1p-53);
  }
  Vec3d direction() {
    for (;;) {
      const Vec3d v{uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)};
      if (const double s = norm(v); s > 0.1 && s < 1) return normalized(v);
    }
  }
  Mat3d rotation() {
    const Vec3d v = direction();
    const double half = uniform(0, 3);
    return rotation_matrix(
        shapes::Quatd{std::cos(half), std::sin(half) * v.x, std::sin(half) * v.y, std::sin(half) * v.z});
  }
};

Body body_of(const PotentialParticle& p, double scale, const Mat3d& rotation) {
  Body b;
  b.kind = Kind::potential_particle;
  b.geometry = &p;
  b.size = {scale, 0, 0};
  b.rotation = rotation;
  return b;
}
Body round(Kind kind, const Vec3d& size, const Mat3d& rotation) {
  Body b;
  b.kind = kind;
  b.size = size;
  b.rotation = rotation;
  return b;
}

using Wide = long double;
Wide height(const Body& b, const shapes::Vec3<Wide>& n) {
  const auto& p = *static_cast<const PotentialParticle*>(b.geometry);
  shapes::Mat3<Wide> r;
  for (int i = 0; i < 3; ++i) r.row[i] = {b.rotation.row[i].x, b.rotation.row[i].y, b.rotation.row[i].z};
  shapes::Vec3<Wide> m = normalized(transposed_times(r, n));
  const shapes::Vec3<Wide> centre{p.centre.x, p.centre.y, p.centre.z};
  return b.size.x * (shapes::support_from_centre<Wide>(p, m).height + dot(m, centre));
}
Wide separation(const Body& a, const Body& b, const Vec3d& d, const Vec3d& direction) {
  const shapes::Vec3<Wide> n = normalized(shapes::Vec3<Wide>{direction.x, direction.y, direction.z});
  return dot(n, shapes::Vec3<Wide>{d.x, d.y, d.z}) - height(a, n) - height(b, -n);
}

TEST(Potential, k_of_one_is_a_sphere) {
  const auto ball = shapes::make_potential_particle(planes_of_faces(shapes::make_box({1, 1, 1})), 1, 0.1, 0.5,
                                                    shapes::Frame::principal, 1e-3);
  Draw draw;
  for (int i = 0; i < 300; ++i) {
    const Body p = body_of(ball, 1.5, draw.rotation()), s = round(Kind::sphere, {0.75, 0, 0}, draw.rotation());
    const Body other = round(Kind::ellipsoid, {0.8, 0.5, 0.6}, draw.rotation());
    const Vec3d d = draw.uniform(0.3, 2) * draw.direction();
    const double tolerance = 64 * epsilon * (norm(d) + 1.5);
    const Contact x = query(other, p, d), y = query(other, s, d);
    EXPECT_NEAR(x.gap, y.gap, tolerance);
    EXPECT_LE(norm(x.point_b - y.point_b), 1e-9);
    EXPECT_NEAR(query(p, p, d).gap, query(s, s, d).gap, tolerance);
  }
}

// Planes through the centre: the body is an ellipsoid, and answers as one.
TEST(Potential, planes_through_the_centre_answer_as_an_ellipsoid) {
  const double tiny = 1e-17, k = 0.3, r = 0.4, R = 0.9;
  const std::vector<shapes::HalfSpace> planes{
      {{1, 0, 0}, tiny}, {{-1, 0, 0}, tiny}, {{0, 1, 0}, tiny}, {{0, -1, 0}, tiny}};
  const auto p = shapes::make_potential_particle(planes, k, r, R, shapes::Frame::principal, 1e-3);
  const double c = R / std::sqrt(k), a = 1 / std::sqrt((1 - k) / (r * r) + k / (R * R));
  Draw draw;
  int overlapping = 0;
  for (int i = 0; i < 300; ++i) {
    const Mat3d turn = draw.rotation(), other = draw.rotation();
    const Vec3d d = draw.uniform(0.8, 3) * draw.direction();
    const Contact x = query(body_of(p, 1, turn), body_of(p, 0.7, other), d);
    const Contact y =
        query(round(Kind::ellipsoid, {a, a, c}, turn), round(Kind::ellipsoid, {0.7 * a, 0.7 * a, 0.7 * c}, other), d);
    if (!y.certified) continue;
    overlapping += y.gap < 0;
    EXPECT_NEAR(x.gap, y.gap, 64 * epsilon * (norm(d) + 2 * c));
    EXPECT_LE(norm(x.point_a - y.point_a), 1e-9);
  }
  EXPECT_GT(overlapping, 15);
}

// No direction separates more than the proven upper bound, and the returned one as much as the lower bound says.
TEST(Potential, bounds_hold_in_extended_precision) {
  Draw draw;
  const auto& shapes = shape_tests::potential_particles();
  int certified = 0, overlapping = 0;
  for (int i = 0; i < 400; ++i) {
    const PotentialParticle &p = shapes[draw.engine() % shapes.size()], &q = shapes[draw.engine() % shapes.size()];
    const Body a = body_of(p, draw.uniform(0.4, 1.2), draw.rotation());
    const Body b = body_of(q, draw.uniform(0.4, 1.2), draw.rotation());
    // Near to touching: first apart, then pushed together by a little.
    Vec3d d = (a.size.x * p.circumradius + b.size.x * q.circumradius) * draw.direction();
    Contact c = query(a, b, d);
    d -= (c.gap + draw.uniform(-0.01, 0.03)) * c.normal;
    c = query(a, b, d);
    ASSERT_NE(c.status, Status::not_converged);
    certified += c.certified;
    overlapping += c.status == Status::overlapping;
    EXPECT_GE(static_cast<double>(separation(a, b, d, c.normal)), c.gap_lower);
    if (!c.certified) continue;
    for (int k = 0; k < 60; ++k) {
      const Vec3d n = k < 20 ? draw.direction() : c.normal + std::exp(-draw.uniform(1, 20)) * draw.direction();
      EXPECT_LE(static_cast<double>(separation(a, b, d, n)), c.gap_upper);
    }
  }
  EXPECT_GT(certified, 300);
  EXPECT_GT(overlapping, 150);
}

Body solid_of(const shapes::Polyhedron& p, double scale, double rounding, const Mat3d& rotation) {
  Body b;
  b.kind = rounding > 0 ? Kind::rounded_polyhedron : Kind::polyhedron;
  b.geometry = &p;
  b.size = {scale, rounding, 0};
  b.rotation = rotation;
  return b;
}

const std::vector<shapes::Polyhedron>& solids() {
  static const std::vector<shapes::Polyhedron> list{shapes::make_box({2, 1, 0.6}),
                                                    shapes::make_platonic(shapes::Platonic::tetrahedron, 1),
                                                    shapes::make_platonic(shapes::Platonic::icosahedron, 0.9)};
  return list;
}

// A sphere, and an ellipsoid, in the form of potential particles answer polyhedra as those do, at any depth.
TEST(Potential, round_ones_meet_polyhedra_as_spheres_and_ellipsoids_do) {
  const auto ball = shapes::make_potential_particle(planes_of_faces(shapes::make_box({1, 1, 1})), 1, 0.1, 0.5,
                                                    shapes::Frame::principal, 1e-3);
  const double tiny = 1e-17, k = 0.3, r = 0.4, R = 0.9;
  const std::vector<shapes::HalfSpace> planes{
      {{1, 0, 0}, tiny}, {{-1, 0, 0}, tiny}, {{0, 1, 0}, tiny}, {{0, -1, 0}, tiny}};
  const auto egg = shapes::make_potential_particle(planes, k, r, R, shapes::Frame::principal, 1e-3);
  const double c = R / std::sqrt(k), a = 1 / std::sqrt((1 - k) / (r * r) + k / (R * R));
  Draw draw;
  int overlapping = 0, certified = 0;
  for (int i = 0; i < 400; ++i) {
    const double rounding = i % 2 == 0 ? 0 : 0.1;
    const Body solid = solid_of(solids()[static_cast<std::size_t>(i) % solids().size()], 1, rounding, draw.rotation());
    const Mat3d turn = draw.rotation();
    const Vec3d d = draw.uniform(0.1, 2.5) * draw.direction();
    const bool round_one = i % 4 < 2;
    const Contact x = query(solid, round_one ? body_of(ball, 1, turn) : body_of(egg, 1, turn), d);
    const Contact y =
        query(solid, round_one ? round(Kind::sphere, {0.5, 0, 0}, turn) : round(Kind::ellipsoid, {a, a, c}, turn), d);
    overlapping += y.gap < 0;
    certified += x.certified;
    EXPECT_NEAR(x.gap, y.gap, 64 * epsilon * (norm(d) + 4)) << i;
    if (y.gap > 0) {
      EXPECT_LE(norm(x.point_b - y.point_b), 1e-7) << i;
    }
  }
  EXPECT_GT(overlapping, 100);
  EXPECT_GT(certified, 300);
}

Wide solid_height(const Body& b, const shapes::Vec3<Wide>& n) {
  Wide highest = -1e9L;
  for (const Vec3d& v : static_cast<const shapes::Polyhedron*>(b.geometry)->vertices) {
    Wide h = 0;
    for (int i = 0; i < 3; ++i) {
      Wide x = 0;
      for (int j = 0; j < 3; ++j) x += Wide(b.rotation.row[i][j]) * Wide(b.size.x) * Wide(v[j]);
      h += n[i] * x;
    }
    highest = std::max(highest, h);
  }
  return highest + Wide(b.size.y);
}

// Polyhedra likewise: no direction separates more than the upper bound, at any depth where it is certified.
TEST(Potential, bounds_against_polyhedra_hold_in_extended_precision) {
  Draw draw;
  const auto& shapes = shape_tests::potential_particles();
  int certified = 0, overlapping = 0, shallow = 0;
  for (int i = 0; i < 600; ++i) {
    const PotentialParticle& p = shapes[draw.engine() % shapes.size()];
    const Body a = solid_of(solids()[static_cast<std::size_t>(i) % solids().size()], draw.uniform(0.4, 1.2),
                            i % 2 == 0 ? 0 : draw.uniform(0.01, 0.2), draw.rotation());
    const Body b = body_of(p, draw.uniform(0.4, 1.2), draw.rotation());
    Vec3d d = 4.0 * draw.direction();
    Contact c = query(a, b, d);
    ASSERT_TRUE(c.certified);
    d -= (c.gap + draw.uniform(-0.02, i % 3 == 0 ? 0.3 : 0.03)) * c.normal;
    c = query(a, b, d);
    ASSERT_NE(c.status, Status::not_converged);
    certified += c.certified;
    overlapping += c.status == Status::overlapping;
    const auto wide = [&](const Vec3d& direction) {
      const shapes::Vec3<Wide> n = normalized(shapes::Vec3<Wide>{direction.x, direction.y, direction.z});
      return static_cast<double>(dot(n, shapes::Vec3<Wide>{d.x, d.y, d.z}) - solid_height(a, n) - height(b, -n));
    };
    EXPECT_GE(wide(c.normal), c.gap_lower);
    if (c.gap + a.size.y + b.size.x * p.least_curvature_radius > 0) {
      ++shallow;
      EXPECT_TRUE(c.certified) << i;
    }
    if (!c.certified) continue;
    for (int k = 0; k < 60; ++k) {
      const Vec3d n = k < 20 ? draw.direction() : c.normal + std::exp(-draw.uniform(1, 20)) * draw.direction();
      EXPECT_LE(wide(n), c.gap_upper) << i;
    }
  }
  EXPECT_GT(shallow, 300);
  EXPECT_GT(certified, 400);
  EXPECT_GT(overlapping, 300);
}

// A floor of triangles is the plane, once.
TEST(Potential, a_floor_of_triangles_answers_as_the_plane) {
  const shapes::Mesh floor = shapes::make_panel({-8, -8, 0}, {16, 0, 0}, {0, 16, 0});
  Draw draw;
  for (const PotentialParticle& p : shape_tests::potential_particles()) {
    for (int i = 0; i < 40; ++i) {
      const Body a = body_of(p, 1, draw.rotation());
      const Vec3d d{draw.uniform(-2, 2), draw.uniform(-2, 2), -draw.uniform(0.3, 1) * p.circumradius};
      Body plane;
      plane.kind = Kind::plane;
      const Contact x = query(a, plane, d);
      int met = 0;
      for (std::uint32_t f = 0; f < floor.facets.size(); ++f) {
        Body facet;
        facet.kind = Kind::mesh;
        facet.geometry = &floor;
        facet.size = {1, 0, 0};
        facet.part = f;
        const Contact y = query(a, facet, d);
        if (y.status == Status::separated && x.status != Status::separated) continue;
        ++met;
        EXPECT_NEAR(x.gap, y.gap, 64 * epsilon * (norm(d) + p.circumradius));
      }
      EXPECT_EQ(met, 1);
    }
  }
}

TEST(Potential, identical_bodies_at_one_place_are_answered) {
  for (const PotentialParticle& p : shape_tests::potential_particles()) {
    const Contact c = query(body_of(p, 1, Mat3d::identity()), body_of(p, 1, Mat3d::identity()), {0, 0, 0});
    EXPECT_EQ(c.status, Status::overlapping);
    EXPECT_LT(c.gap, -2 * p.inner_radius);
  }
}

}  // namespace
