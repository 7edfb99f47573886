// Volumes of overlaps and their slopes: closed forms in 50 digits, and for every pair of kinds dV = −(S·u + G·θ) by
// differences.
#include "libcontact/overlap_volume.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "shapes/math/quat.h"
#include "shapes/polygon_build.h"
#include "shapes/polyhedron_build.h"

#ifdef TEST_HAS_BOOST
#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#endif

namespace {

using namespace contact;
using shapes::Kind;

constexpr double pi = std::numbers::pi;

#ifdef TEST_HAS_BOOST
using Wide = boost::multiprecision::cpp_bin_float_100;

TEST(OverlapVolume, RoundBodiesInManyDigits) {
  const Wide wide_pi = boost::math::constants::pi<Wide>();
  for (const double ra : {1.0, 0.75})
    for (const double rb : {1.0, 0.125, 7.0})
      for (const double overlap : {0x1p-3, 0x1p-10, 0x1p-25, 0x1p-40}) {
        if (overlap > 0.9 * std::min(ra, rb)) continue;
        const Wide r = ra, s = rb, d = r + s - Wide(overlap);
        const Wide volume =
            wide_pi * (r + s - d) * (r + s - d) * (d * d + 2 * d * (r + s) - 3 * (r - s) * (r - s)) / (12 * d);
        const Wide x = (d * d + r * r - s * s) / (2 * d), rim2 = r * r - x * x;
        const VolumeSection v = sphere_overlap(overlap, ra, rb);
        EXPECT_NEAR(static_cast<double>(Wide(v.volume) / volume - 1), 0, 1e-15);
        EXPECT_NEAR(static_cast<double>(Wide(v.section) / (wide_pi * rim2) - 1), 0, 1e-15);
        const Wide area = r * r * acos(x / r) + s * s * acos((d - x) / s) - d * sqrt(rim2);
        const VolumeSection disc = disc_overlap(overlap, ra, rb);
        EXPECT_NEAR(static_cast<double>(Wide(disc.volume) / area - 1), 0, 4e-15) << ra << " " << rb << " " << overlap;
        EXPECT_NEAR(static_cast<double>(Wide(disc.section) / (2 * sqrt(rim2)) - 1), 0, 1e-15);
      }
}
#endif

struct Draw {
  std::mt19937_64 engine{29};
  double uniform(double low, double high) {
    return low + (high - low) * (static_cast<double>(engine() >> 11) * 0x1p-53);
  }
  Vec3d vector() { return {uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)}; }
  Vec3d direction(bool planar) {
    Vec3d v = vector();
    if (planar) v.z = 0;
    return v * (1 / norm(v));
  }
  Mat3d rotation(bool planar) {
    const double angle = uniform(0, 6);
    if (planar) return rotation_matrix(shapes::Quatd{std::cos(angle), 0, 0, std::sin(angle)});
    return rotation_matrix(normalized(shapes::Quatd{uniform(-1, 1), uniform(-1, 1), uniform(-1, 1), uniform(0.1, 1)}));
  }
};

double volume(const Body& a, const Body& b, const Vec3d& offset) {
  OverlapVolume v;
  return overlap_volume(a, b, offset, v) ? v.volume : 0;
}

// b turned by a small angle about a's origin.
double turned(const Body& a, Body b, const Vec3d& offset, const Vec3d& axis, double angle) {
  const double s = std::sin(0.5 * angle);
  const Mat3d r = rotation_matrix(shapes::Quatd{std::cos(0.5 * angle), axis.x * s, axis.y * s, axis.z * s});
  b.rotation = r * b.rotation;
  return volume(a, b, r * offset);
}

// Central differences of step h and h/2, of fourth order.
template <class F>
double slope(const F& f, double h) {
  const double wide = (f(h) - f(-h)) / (2 * h), narrow = (f(0.5 * h) - f(-0.5 * h)) / h;
  return (4 * narrow - wide) / 3;
}

struct Found {
  int count = 0;
  double most_screw = 0, worst = 0;
};
// Random poses of a pair of bodies about 1 in size; `reach`: how far the origins may be apart.
Found check(Body a, Body b, double reach, int tries) {
  const bool planar = shapes::dimension_of(a.kind) == 2;
  Draw draw;
  Found found;
  for (int i = 0; i < tries; ++i) {
    a.rotation = draw.rotation(planar);
    b.rotation = draw.rotation(planar);
    Vec3d offset = draw.direction(planar) * draw.uniform(0.3, reach);
    if (shapes::is_wall(b.kind)) offset = b.rotation.column(planar ? 1 : 2) * -draw.uniform(0.5, 1.2);
    OverlapVolume v;
    if (!overlap_volume(a, b, offset, v)) continue;
    const double size = planar ? std::sqrt(v.volume) : std::cbrt(v.volume);
    if (size < 0.05) continue;
    const double h = 1e-5 * size;
    double worst = 0;
    for (int k = 0; k < 3; ++k) {
      Vec3d e{};
      e[k] = 1;
      if (planar && k == 2) break;
      const double expected = -v.section * dot(v.normal, e);
      worst = std::max(worst, std::abs(slope([&](double t) { return volume(a, b, offset + t * e); }, h) - expected));
    }
    for (int k = planar ? 2 : 0; k < 3; ++k) {
      Vec3d e{};
      e[k] = 1;
      const double expected = -v.section * dot(cross(v.point, v.normal) + v.screw * v.normal, e);
      worst = std::max(worst, std::abs(slope([&](double t) { return turned(a, b, offset, e, t); }, h) - expected));
    }
    found.worst = std::max(found.worst, worst);
    found.most_screw = std::max(found.most_screw, std::abs(v.screw));
    ++found.count;
  }
  return found;
}

Body body(Kind kind, const void* geometry, const Vec3d& size) {
  Body b;
  b.kind = kind;
  b.geometry = geometry;
  b.size = size;
  return b;
}

// Where a corner of the overlap appears within the step the differences are of second order in it: a few of thousands.
TEST(OverlapVolume, SlopesBySmallSteps) {
  const shapes::Polyhedron pyramid = shapes::make_platonic(shapes::Platonic::tetrahedron, 1.2),
                           cube = shapes::make_box({1.2, 1.2, 1.2}), seven = shapes::make_prism(7, 0.7, 1.1);
  const shapes::Polygon triangle = shapes::make_regular_polygon(3, 1.1), five = shapes::make_regular_polygon(5, 0.9);
  const Body solids[] = {body(Kind::polyhedron, &pyramid, {1, 0, 0}), body(Kind::polyhedron, &cube, {1, 0, 0}),
                         body(Kind::polyhedron, &seven, {1, 0, 0})};
  const Body flat[] = {body(Kind::polygon, &triangle, {1, 0, 0}), body(Kind::polygon, &five, {1, 0, 0})};
  const Body plane = body(Kind::plane, nullptr, {}), line = body(Kind::line, nullptr, {});
  double screw = 0;
  const auto expect = [&](const Body& a, const Body& b, double tolerance) {
    const Found f = check(a, b, 1.4, 300);
    EXPECT_GT(f.count, 60);
    EXPECT_LT(f.worst, tolerance) << shapes::name_of(a.kind) << " " << shapes::name_of(b.kind);
    screw = std::max(screw, f.most_screw);
  };
  for (const Body& a : solids) {
    for (const Body& b : solids) expect(a, b, 2e-6);
    expect(a, plane, 2e-6);
  }
  EXPECT_GT(screw, 1e-3);  // a rim that lies in no plane: without the couple along S it would be no potential
  screw = 0;
  for (const Body& a : flat) {
    for (const Body& b : flat) expect(a, b, 2e-6);
    expect(a, line, 2e-6);
  }
  expect(body(Kind::sphere, nullptr, {1, 1, 1}), body(Kind::sphere, nullptr, {0.6, 0.6, 0.6}), 1e-9);
  expect(body(Kind::sphere, nullptr, {1, 1, 1}), plane, 1e-9);
  expect(body(Kind::ellipsoid, nullptr, {1.4, 1, 0.8}), plane, 1e-9);
  expect(body(Kind::disc, nullptr, {1, 0, 0}), body(Kind::disc, nullptr, {0.6, 0, 0}), 1e-9);
  expect(body(Kind::disc, nullptr, {1, 0, 0}), line, 1e-9);
  expect(body(Kind::ellipse, nullptr, {1.3, 0.9, 0}), line, 1e-9);
  EXPECT_EQ(screw, 0);
}

TEST(OverlapVolume, KnownOnes) {
  const shapes::Polyhedron cube = shapes::make_box({2, 2, 2});
  const Body a = body(Kind::polyhedron, &cube, {1, 0, 0}), plane = body(Kind::plane, nullptr, {});
  OverlapVolume v;
  // Half a face on half a face, 0.25 deep: the sides that lie in the other cube push, too.
  ASSERT_TRUE(overlap_volume(a, a, {1.75, 1, 0}, v));
  EXPECT_NEAR(v.volume, 0.5, 1e-15);
  EXPECT_NEAR(v.section * v.normal.x, 2, 1e-15);
  EXPECT_NEAR(v.section * v.normal.y, 0.5, 1e-15);
  ASSERT_TRUE(overlap_volume(a, plane, {0, 0, -0.75}, v));
  EXPECT_NEAR(v.volume, 1, 1e-15);
  EXPECT_NEAR(v.section, 4, 1e-15);
  EXPECT_EQ(v.normal.z, -1);
  EXPECT_NEAR(norm(v.point - Vec3d{0, 0, -0.875}), 0, 1e-15);
  const Body egg = body(Kind::ellipsoid, nullptr, {3, 2, 1});
  ASSERT_TRUE(overlap_volume(egg, plane, {}, v));
  EXPECT_NEAR(v.volume, 2.0 / 3.0 * pi * 6, 1e-14);
  EXPECT_NEAR(v.section, pi * 6, 1e-14);
  // None: apart, one inside the other, a pair without.
  EXPECT_FALSE(overlap_volume(a, a, {2.5, 0, 0}, v));
  Body small = a;
  small.size.x = 0.25;
  EXPECT_FALSE(overlap_volume(a, small, {0.125, 0, 0}, v));
  EXPECT_FALSE(overlap_volume(egg, egg, {1, 0, 0}, v));
}

// Sides that lie in one plane, or next to it by rounding: none counts twice, none is left out.
TEST(OverlapVolume, FacesInOnePlane) {
  const shapes::Polyhedron cube = shapes::make_box({2, 2, 2});
  Draw draw;
  for (int i = 0; i < 2000; ++i) {
    Body a = body(Kind::polyhedron, &cube, {1, 0, 0}), b = a;
    a.rotation = draw.rotation(false);
    b.rotation = i % 2 == 0 ? a.rotation : rotation_matrix(shapes::Quatd{1, 1e-16 * i, -3e-17 * i, 1e-17}) * a.rotation;
    const double slide = i % 4 == 0 ? 0 : draw.uniform(-1, 1) * std::exp2(-draw.uniform(1, 53));
    OverlapVolume v;
    ASSERT_TRUE(overlap_volume(a, b, a.rotation * Vec3d{1.75, slide, 0}, v));
    EXPECT_NEAR(v.volume, 0.25 * (2 - std::abs(slide)) * 2, 5e-12);
    EXPECT_NEAR(v.section * dot(v.normal, a.rotation.column(0)), (2 - std::abs(slide)) * 2, 5e-12);
  }
}

// The other way round the same bits with the sign turned; other units the same bits, scaled.
TEST(OverlapVolume, OrderAndUnits) {
  const shapes::Polyhedron cube = shapes::make_box({2, 2, 2}), seven = shapes::make_prism(7, 0.7, 1.1);
  Draw draw;
  int count = 0;
  for (int i = 0; i < 200; ++i) {
    Body a = body(Kind::polyhedron, &cube, {1, 0, 0}), b = body(Kind::polyhedron, &seven, {1, 0, 0});
    a.rotation = draw.rotation(false);
    b.rotation = draw.rotation(false);
    const Vec3d offset = draw.direction(false) * draw.uniform(0.7, 2);
    OverlapVolume v, w;
    if (!overlap_volume(a, b, offset, v)) continue;
    ++count;
    ASSERT_TRUE(overlap_volume(b, a, -offset, w));
    EXPECT_EQ(w.volume, v.volume);
    EXPECT_EQ(w.normal, -v.normal);
    EXPECT_EQ(w.screw, v.screw);
    a.size.x = b.size.x = 0x1p-20;
    ASSERT_TRUE(overlap_volume(a, b, offset * 0x1p-20, w));
    EXPECT_EQ(w.volume, v.volume * 0x1p-60);
    EXPECT_EQ(w.section, v.section * 0x1p-40);
    EXPECT_EQ(w.point, v.point * 0x1p-20);
  }
  EXPECT_GT(count, 50);
}

}  // namespace
