// Sphere and ellipsoid against a polyhedron: proofs in 50 digits along the answer's own normal, and searches for a
// better one.
#include <gtest/gtest.h>

#include "libcontact/methods/features.h"
#include "tests/libcontact/poly_reference.h"

namespace {

using namespace contact;
using namespace reference;

std::vector<Polyhedron> zoo() {
  using enum shapes::Platonic;
  return {shapes::make_box({1, 1, 1}),
          shapes::make_box({1, 0.4, 0.1}),
          shapes::make_platonic(tetrahedron, 0.8),
          shapes::make_platonic(dodecahedron, 0.7),
          shapes::make_prism(5, 0.5, 1),
          grain("cement140_03.off")};
}

TEST(PolyFeatures, SphereAgainstFiftyDigits) {
  const auto solids = zoo();
  Draw draw(31);
  int inside = 0, overlapping = 0, separated = 0;
  for (int i = 0; i < 1500; ++i) {
    const Polyhedron& p = solids[draw.index(solids.size())];
    const double scale = std::exp2(draw.between(-3, 3)), radius = std::exp2(draw.between(-3, 3));
    const Quatd q = draw.orientation();
    const Vec3d d = draw.direction() * (draw.between(0, 1.3) * (scale * p.circumradius + (i % 2 ? radius : 0)));
    const Contact c = Features::query(Placed<shapes::Sphere>{radius}, place(p, scale, q), d, {}, nullptr);
    const Wide exact = point_gap(Vec<Wide>{}, Solid<Wide>(p, scale, q, d)) - Wide(radius);
    const double allowed = 64 * epsilon * (norm(d) + radius + scale * p.circumradius);
    ASSERT_LE(std::abs(static_cast<double>(Wide(c.gap) - exact)), allowed) << i;
    ASSERT_LE(Wide(c.gap_lower), exact) << i;
    ASSERT_GE(Wide(c.gap_upper), exact) << i;
    ASSERT_LE(norm(c.point_b - c.point_a - c.gap * c.normal), allowed) << i;
    ASSERT_NEAR(norm(c.point_a), radius, allowed) << i;
    ASSERT_LE(std::abs(static_cast<double>(point_gap(widen<Wide>(c.point_b), Solid<Wide>(p, scale, q, d)))), allowed)
        << i;
    (exact < Wide(-radius) ? inside : exact < Wide(0) ? overlapping : separated) += 1;
  }
  EXPECT_GT(inside, 100);
  EXPECT_GT(overlapping, 100);
  EXPECT_GT(separated, 100);
}

// The centre in a vertex, on an edge, on a face, and within rounding of them.
TEST(PolyFeatures, SphereCentreOnTheSurface) {
  const Polyhedron box = shapes::make_box({1, 1, 1});
  for (const Vec3d& centre : {Vec3d{0.5, 0.5, 0.5}, Vec3d{0.5, 0.5, 0.1}, Vec3d{0.5, 0.2, 0.1}})
    for (const double shift : {0.0, 1e-17, 1e-16, -1e-16, 1e-14, 1e-12}) {
      const Vec3d d = -(centre + Vec3d{shift, shift, shift});
      const Contact c = Features::query(Placed<shapes::Sphere>{0.25}, place(box, 1, {}), d, {}, nullptr);
      const double exact = static_cast<double>(point_gap(widen<Wide>(-d), Solid<Wide>(box, 1, {}, {}))) - 0.25;
      EXPECT_NEAR(c.gap, exact, 64 * epsilon * 2);
      EXPECT_NEAR(norm(c.normal), 1, 8 * epsilon);
    }
}

double most_of(const Vec3d& v) { return std::max({v.x, v.y, v.z}); }

struct Wider {
  Vec<Wide> centre, semi;
  shapes::Mat3<Wide> axes;
  Vec<Wide> deepest(const Vec<Wide>& m) const {
    const Vec<Wide> u = scaled(semi, transposed_times(axes, m));
    return centre - axes * scaled(semi, u * (Wide(1) / norm(u)));
  }
};

TEST(PolyFeatures, EllipsoidAgainstProofsAndSearch) {
  const auto solids = zoo();
  Draw draw(7);
  int shallow = 0;
  Options quick;
  quick.overlap_only = true;
  for (int i = 0; i < 500; ++i) {
    const Polyhedron& p = solids[draw.index(solids.size())];
    const double scale = std::exp2(draw.between(-2, 2)), ratio = std::exp2(draw.between(0, 3));
    const Vec3d semi{draw.between(1 / ratio, 1), draw.between(1 / ratio, 1), draw.between(1 / ratio, 1)};
    const Quatd qa = draw.orientation(), qb = draw.orientation();
    const Placed<shapes::Ellipsoid> a{semi, rotation_matrix(qa)};
    const auto b = place(p, scale, qb);
    // Shallow: at a distance where the overlap is small; every fourth pair anywhere.
    const Vec3d direction = draw.direction();
    double near = 0, far = most_of(semi) + scale * p.circumradius;
    for (int k = 0; k < 25; ++k) {
      const double middle = 0.5 * (near + far);
      const double gap = Features::query(a, b, direction * middle, quick, nullptr).gap;
      (gap < 0 ? near : far) = middle;
    }
    const double least = std::min({semi.x, semi.y, semi.z}), most = std::max({semi.x, semi.y, semi.z});
    const Vec3d d = i % 4 == 0 ? direction * draw.between(0, far)
                               : direction * (near - draw.between(-0.3, 0.3) * least * least / most);
    const Contact c = Features::query(a, b, d, {}, nullptr);
    const double allowed = 64 * epsilon * (norm(d) + most + scale * p.circumradius);
    const Solid<Wide> solid(p, scale, qb, d);
    const shapes::Quat<Wide> q = normalized(shapes::Quat<Wide>{Wide(qa.w), Wide(qa.x), Wide(qa.y), Wide(qa.z)});
    const Wider body{{}, widen<Wide>(semi), rotation_matrix(q)};
    const Vec<Wide> m = -normalized(widen<Wide>(c.normal));
    const Vec<Wide> touch = body.deepest(m);
    const Wide proven = dot(m, touch) - solid.highest(m);
    ASSERT_LE(std::abs(static_cast<double>(proven - Wide(c.gap))), allowed) << i;
    ASSERT_LE(Wide(c.gap_lower), proven + Wide(allowed)) << i;
    // While the overlap is below ρ = c²/a, the distance of a point of the body shrunk by ρ bounds the gap from above.
    const Wide rho = Wide(least) * Wide(least) / Wide(most);
    if (Wide(c.gap) + rho > Wide(1e-3) * rho) {
      ++shallow;
      const Wide bound = point_gap(touch + rho * m, solid) - rho;
      ASSERT_LE(std::abs(static_cast<double>(bound - Wide(c.gap))), allowed) << i;
      ASSERT_GE(Wide(c.gap_upper), proven) << i;
    }
    ASSERT_TRUE(c.certified) << i;
    // No direction that a search finds is better.
    const shapes::Mat3d ra = rotation_matrix(qa), rb = rotation_matrix(qb);
    const auto separation_along = [&](const Vec3d& n) {
      double low = 1e300;
      for (const auto& v : p.vertices) low = std::min(low, dot(n, d + rb * (scale * v)));
      return low - norm(scaled(semi, transposed_times(ra, n)));
    };
    for (int start = 0; start < 12; ++start) {
      Vec3d n = draw.direction();
      double value = separation_along(n), step = 0.5;
      for (int k = 0; k < 300 && step > 1e-6; ++k) {
        const Vec3d trial = normalized(n + step * draw.direction());
        const double v = separation_along(trial);
        if (v > value)
          value = v, n = trial;
        else
          step *= 0.93;
      }
      ASSERT_LE(value, c.gap + 2 * allowed) << i;
    }
  }
  EXPECT_GT(shallow, 280);
}

// Deep pairs, where there may be many maxima: all are found, so no search finds a better direction, and every answer is
// certified.
TEST(PolyFeatures, DeepEllipsoidsAgainstManyClimbs) {
  const auto solids = zoo();
  Draw draw(17);
  int deep = 0;
  for (int i = 0; i < 300; ++i) {
    const Polyhedron& p = solids[draw.index(solids.size())];
    const double scale = std::exp2(draw.between(-1, 1)) / p.circumradius;
    const Vec3d semi{1, draw.between(0.1, 1), draw.between(0.05, 0.5)};
    const Mat3d ra = rotation_matrix(draw.orientation());
    const auto b = place(p, scale, draw.orientation());
    const Vec3d d = draw.direction() * draw.between(0, 0.6 * (1 + scale * p.circumradius));
    const Contact c = Features::query(Placed<shapes::Ellipsoid>{semi, ra}, b, d, {}, nullptr);
    ASSERT_TRUE(c.certified) << i;
    const double least = std::min({semi.x, semi.y, semi.z});
    deep += c.gap < -least * least;
    const auto separation_along = [&](const Vec3d& n) {
      double low = 1e300;
      for (const auto& v : p.vertices) low = std::min(low, dot(n, d + b.rotation * (scale * v)));
      return low - norm(scaled(semi, transposed_times(ra, n)));
    };
    for (int start = 0; start < 60; ++start) {
      Vec3d n = draw.direction();
      double value = separation_along(n), step = 0.3;
      for (int k = 0; k < 250 && step > 1e-7; ++k) {
        const Vec3d trial = normalized(n + step * draw.direction());
        const double v = separation_along(trial);
        if (v > value)
          value = v, n = trial;
        else
          step *= 0.92;
      }
      ASSERT_LE(value, c.gap_upper) << i;
    }
  }
  EXPECT_GT(deep, 150);
}

TEST(PolyFeatures, EllipsoidWithEqualAxesIsASphere) {
  const Polyhedron box = shapes::make_box({1, 0.8, 0.6});
  Draw draw(2);
  for (int i = 0; i < 500; ++i) {
    const Vec3d d = draw.direction() * draw.between(0, 1.6);
    const auto b = place(box, 1, draw.orientation());
    const Contact ball = Features::query(Placed<shapes::Sphere>{0.5}, b, d, {}, nullptr);
    const Contact round =
        Features::query(Placed<shapes::Ellipsoid>{{0.5, 0.5, 0.5}, Mat3d::identity()}, b, d, {}, nullptr);
    EXPECT_NEAR(ball.gap, round.gap, 64 * epsilon * 3);
  }
}

}  // namespace
