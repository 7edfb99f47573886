// Gaps of smooth pairs against 50-digit references, and the self-consistency of normal and witness points.
#include <gtest/gtest.h>

#include <random>

#include "tests/libcontact/reference.h"

namespace {

using contact::Contact;
using contact::epsilon;
using contact::Status;
using reference::Body;
using reference::Real;
using shapes::Kind;
using shapes::Vec3d;

struct Draw {
  std::mt19937_64 engine;
  explicit Draw(std::uint64_t seed) : engine(seed) {}
  double uniform(double low, double high) {
    return low + (high - low) * (static_cast<double>(engine() >> 11) * 0x1p-53);
  }
  Vec3d direction() {
    for (;;) {
      const Vec3d v{uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)};
      if (const double s = dot(v, v); s > 0.01 && s < 1) return normalized(v);
    }
  }
  Body body(Kind kind, double aspect) {
    const Vec3d a = direction();
    Body b{kind, {}, normalized(shapes::Quatd{uniform(-1, 1), a.x, a.y, a.z})};
    const auto size = [&] { return std::pow(aspect, -uniform(0, 1)) * std::exp2(uniform(-1, 1)); };
    b.size = {size(), size(), size()};
    return b;
  }
};

Vec3d support(const Body& b, const Vec3d& n) {
  if (b.kind == Kind::sphere) return b.size.x * n;
  const auto r = b.placed().rotation;
  return r * shapes::support(shapes::Ellipsoid{b.size}, transposed_times(r, n));
}

// Offset of B at which the pair touches along n, moved apart by `gap` (against a plane: along its normal).
Vec3d offset_for(Draw& draw, const Body& a, const Body& b, double gap) {
  if (b.kind == Kind::plane) {
    const Vec3d n = b.placed().rotation.column(2);
    return support(a, -n) - gap * n + cross(n, draw.direction());
  }
  const Vec3d n = draw.direction();
  return support(a, n) + support(b, n) + gap * n;
}

double extent(const Body& a, const Body& b, const Vec3d& offset) {
  return norm(offset) + a.circumradius() + b.circumradius();
}

double smallest_axis(const Body& b) {
  return b.kind == Kind::plane ? 1e300 : (b.kind == Kind::sphere ? b.size.x : std::min({b.size.x, b.size.y, b.size.z}));
}

void expect_right(const Body& a, const Body& b, const Vec3d& offset, const Real& truth, const std::string& what) {
  SCOPED_TRACE(what);
  const Contact c = contact::query(a.placed(), b.placed(), offset);
  const double length = extent(a, b, offset), tolerance = 64 * epsilon * length;
  ASSERT_NE(c.status, Status::refused);
  EXPECT_NE(c.status, Status::not_converged);
  EXPECT_LE(abs(Real(c.gap) - truth), tolerance) << c.gap << " " << truth;
  EXPECT_LE(Real(c.gap_lower), truth);
  EXPECT_GE(Real(c.gap_upper), truth);
  EXPECT_LE(c.gap_lower, c.gap);
  EXPECT_LE(c.gap, c.gap_upper);
  EXPECT_LE(c.gap_upper - c.gap_lower, 4 * tolerance);
  EXPECT_EQ(c.status == Status::separated, c.gap_lower > 0);
  EXPECT_EQ(c.status == Status::overlapping, c.gap_upper < 0);
  // Witness points: a gap apart along the normal, and on both bodies.
  EXPECT_LE(norm(c.point_b - c.point_a - c.gap * c.normal), tolerance);
  EXPECT_LE(std::abs(norm(c.normal) - 1), 8 * epsilon);
  if (b.kind != Kind::plane) {
    reference::Vector n = reference::exact(c.normal);
    n = n * (1 / norm(n));
    EXPECT_LE(abs(reference::separation(a, b, reference::exact(offset), n) - truth), tolerance);
  }
  const auto from_surface = [](const Body& body, const Vec3d& point) {
    const reference::Vector p = reference::exact(point);
    if (body.kind == Kind::plane) return Real(dot(body.rotation().column(2), p));
    if (body.kind == Kind::sphere) return Real(norm(p) - Real(body.size.x));
    return reference::ellipsoid_distance(semi_axes(body), transposed_times(body.rotation(), p));
  };
  EXPECT_LE(abs(from_surface(a, c.point_a)), tolerance);
  EXPECT_LE(abs(from_surface(b, c.point_b - offset)), tolerance);
}

// Random pairs of every smooth pair of kinds: apart, and overlapping by 1e-12 to 0.2 of the smallest semi-axis.
class SmoothPairs : public testing::TestWithParam<std::pair<Kind, Kind>> {};

TEST_P(SmoothPairs, match_the_reference) {
  const auto [ka, kb] = GetParam();
  Draw draw(17 + 8 * static_cast<unsigned>(ka) + static_cast<unsigned>(kb));
  for (const double aspect : {1.0, 3.0, 100.0}) {
    for (const double part : {3.0, 0.3, 1e-3, 1e-9, 0.0, -1e-12, -1e-9, -1e-6, -1e-3, -0.05, -0.2}) {
      for (int repeat = 0; repeat < 8; ++repeat) {
        const Body a = draw.body(ka, aspect), b = draw.body(kb, aspect);
        const Vec3d offset = offset_for(draw, a, b, part * std::min(smallest_axis(a), smallest_axis(b)));
        expect_right(
            a, b, offset, reference::gap(a, b, offset),
            "aspect " + std::to_string(aspect) + " part " + std::to_string(part) + " #" + std::to_string(repeat));
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, SmoothPairs,
                         testing::Values(std::pair{Kind::sphere, Kind::sphere},
                                         std::pair{Kind::sphere, Kind::ellipsoid}, std::pair{Kind::sphere, Kind::plane},
                                         std::pair{Kind::ellipsoid, Kind::ellipsoid},
                                         std::pair{Kind::ellipsoid, Kind::plane}),
                         [](const auto& info) {
                           return std::string(name_of(info.param.first)) + "_" + name_of(info.param.second);
                         });

// Deep overlaps, containment included: several maxima, and the largest must be found.
TEST(SmoothDeep, ellipsoids_inside_each_other) {
  Draw draw(5);
  for (const double aspect : {2.0, 10.0, 100.0}) {
    for (int repeat = 0; repeat < 40; ++repeat) {
      const Body a = draw.body(Kind::ellipsoid, aspect), b = draw.body(Kind::ellipsoid, aspect);
      const Vec3d offset = draw.uniform(0, 1) * offset_for(draw, a, b, 0);
      expect_right(a, b, offset, reference::gap(a, b, offset),
                   "aspect " + std::to_string(aspect) + " #" + std::to_string(repeat));
    }
  }
}

TEST(SmoothDeep, sphere_centres_inside_ellipsoids) {
  Draw draw(6);
  for (const double aspect : {1.001, 2.0, 10.0, 1e3, 1e6}) {
    for (int repeat = 0; repeat < 40; ++repeat) {
      const Body a = draw.body(Kind::sphere, 1), b = draw.body(Kind::ellipsoid, aspect);
      const Vec3d offset = draw.uniform(0, 1) * support(b, draw.direction());
      expect_right(a, b, offset, reference::gap(a, b, offset),
                   "aspect " + std::to_string(aspect) + " #" + std::to_string(repeat));
    }
  }
}

// Needles, discs and unlike sizes: the pair is built about a known normal, from which the reference starts. Overlaps
// stay below the sum of the least radii of curvature, where the stationary point near that normal is the only maximum.
TEST(SmoothExtremes, aspect_and_size_ratios_to_a_million) {
  Draw draw(7);
  const auto least_radius = [](const Vec3d& a) { return std::pow(std::min({a.x, a.y, a.z}), 2) / max_abs(a); };
  int compared = 0;
  for (const double aspect : {1.5, 1e3, 1e6}) {
    for (const double size : {1.0, 1e-6}) {
      for (int repeat = 0; repeat < 40; ++repeat) {
        const Body a = draw.body(Kind::ellipsoid, aspect);
        Body b = draw.body(Kind::ellipsoid, aspect);
        b.size *= size;
        const double m = least_radius(a.size) + least_radius(b.size);
        const Vec3d normal = draw.direction();
        const double gaps[] = {0.5, 1e-6, 0, -0.5 * m};
        const Vec3d offset = support(a, normal) + support(b, normal) + gaps[repeat % 4] * normal;
        reference::Vector n = reference::exact(normal);
        Real truth;
        if (!reference::stationary_point(reference::support_matrix(a), reference::support_matrix(b),
                                         reference::exact(offset), n, truth) ||
            truth <= -m)
          continue;
        ++compared;
        expect_right(
            a, b, offset, truth,
            "aspect " + std::to_string(aspect) + " size " + std::to_string(size) + " #" + std::to_string(repeat));
      }
    }
  }
  EXPECT_GT(compared, 200);
}

const shapes::Quatd upright{1, 0, 0, 0};

// Ties on the axes and on the medial disc, where the plain equation divides zero by zero.
TEST(SmoothTies, sphere_centre_on_the_medial_disc) {
  const Body ball{Kind::sphere, {0.25, 0, 0}, upright};
  for (const Vec3d axes :
       {Vec3d{1, 2, 4}, Vec3d{4, 1, 2}, Vec3d{2, 2, 2}, Vec3d{3, 3, 0.5}, Vec3d{3, 0.5, 0.5}, Vec3d{3, 3, 3e-6}}) {
    const Body e{Kind::ellipsoid, axes, upright};
    for (const Vec3d y : {Vec3d{0, 0, 0}, Vec3d{0.5, 0, 0}, Vec3d{0, 0.5, 0}, Vec3d{0, 0, 0.5}, Vec3d{0.25, -0.5, 0},
                          Vec3d{0, 0.25, -0.25}, Vec3d{2.9, 0, 0}, Vec3d{0, 0, 3.99}, Vec3d{1e-30, 1e-20, 1e-25}}) {
      expect_right(ball, e, y, reference::gap(ball, e, y), "");
    }
  }
}

struct Known {
  Vec3d axes_a, axes_b, offset;
  double gap;
};

TEST(SmoothTies, ellipsoids_on_common_axes) {
  for (const Known& k : {Known{{1, 2, 3}, {2, 3, 4}, {0, 0, 0}, -3},  // concentric: the smallest axes
                         Known{{1, 1, 1}, {1, 1, 1}, {0, 0, 0}, -2}, Known{{1, 2, 3}, {1, 2, 3}, {0, 0, 0}, -2},
                         Known{{1, 1, 1e-3}, {1, 1, 1e-3}, {0, 0, 0.00225}, 0.00025},  // discs face to face
                         Known{{1, 1, 1e-6}, {1, 1, 1e-6}, {0, 0, 1e-6}, -1e-6},
                         Known{{1, 1, 0.5}, {1, 1, 0.5}, {0, 0, -1}, 0},              // exact touch
                         Known{{8, 1e-3, 1e-3}, {8, 1e-3, 1e-3}, {16.5, 0, 0}, 0.5},  // needles tip to tip
                         // max of n·d − h_A − h_B over the plane of the thin axis and d, by hand:
                         Known{{10, 10, 10}, {1, 2, 3}, {0, 0.5, 0}, -10 - 5.5 / std::sqrt(33.0)},
                         Known{{2, 3, 4}, {2, 3, 4}, {0, 0, 1}, -47 / std::sqrt(141.0)}}) {
    const Body a{Kind::ellipsoid, k.axes_a, upright}, b{Kind::ellipsoid, k.axes_b, upright};
    const Contact c = contact::query(a.placed(), b.placed(), k.offset);
    const double tolerance = 64 * epsilon * extent(a, b, k.offset);
    EXPECT_NE(c.status, Status::not_converged);
    EXPECT_NEAR(c.gap, k.gap, tolerance);
    EXPECT_LE(c.gap_lower, k.gap);
    EXPECT_GE(c.gap_upper, k.gap);
    EXPECT_NEAR(norm(c.point_b - c.point_a), std::abs(k.gap), tolerance);
  }
}

// An ellipsoid with equal axes is a sphere, whichever method answers.
TEST(SmoothTies, equal_axes_are_a_sphere) {
  Draw draw(9);
  for (int repeat = 0; repeat < 50; ++repeat) {
    const double ra = draw.uniform(0.1, 1), rb = draw.uniform(0.1, 1);
    Body ball = draw.body(Kind::sphere, 1), as_ellipsoid = draw.body(Kind::ellipsoid, 1),
         other = draw.body(Kind::ellipsoid, 1);
    ball.size.x = ra;
    as_ellipsoid.size = {ra, ra, ra};
    other.size = {rb, rb, rb};
    const Vec3d offset = draw.uniform(0, 1.5) * (ra + rb) * draw.direction();
    const double expected = norm(offset) - ra - rb, tolerance = 64 * epsilon * extent(ball, other, offset);
    EXPECT_NEAR(contact::query(ball.placed(), other.placed(), offset).gap, expected, tolerance);
    EXPECT_NEAR(contact::query(as_ellipsoid.placed(), other.placed(), offset).gap, expected, tolerance);
  }
}

TEST(SmoothTies, coincident_spheres_answer_with_a_unit_normal) {
  const Body a{Kind::sphere, {2, 0, 0}, upright}, b{Kind::sphere, {3, 0, 0}, upright};
  const Contact c = contact::query(a.placed(), b.placed(), {0, 0, 0});
  EXPECT_EQ(c.gap, -5);
  EXPECT_EQ(norm(c.normal), 1);
  EXPECT_EQ(c.status, Status::overlapping);
}

// Centres so near that their distance lies below every extent that is accepted: the same bits in other units.
TEST(SmoothTies, all_but_coincident_spheres_scale_every_bit) {
  const Vec3d offset{2e-300, -3e-300, 6e-300};
  const double scale = 0x1p300;
  const Body a{Kind::sphere, {2, 0, 0}, upright}, b{Kind::sphere, {3, 0, 0}, upright};
  Body large_a = a, large_b = b;
  large_a.size *= scale;
  large_b.size *= scale;
  const Contact c = contact::query(a.placed(), b.placed(), offset),
                d = contact::query(large_a.placed(), large_b.placed(), offset * scale);
  EXPECT_NEAR(c.normal.z, 6.0 / 7, 4 * epsilon);
  EXPECT_TRUE(c.normal == d.normal);
  EXPECT_TRUE(c.point_a * scale == d.point_a);
  EXPECT_EQ(c.gap * scale, d.gap);
}

}  // namespace
