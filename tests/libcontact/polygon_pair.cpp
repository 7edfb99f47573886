// Convex polygons: what is in the cache changes no bit of the answer, and the patch is that of the clipped area.
#include "libcontact/methods/polygon_pair.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <vector>

#include "libcontact/methods/planar.h"
#include "libcontact/overlap_depth.h"
#include "shapes/math/random.h"
#include "shapes/math/trig.h"
#include "shapes/polygon_build.h"

namespace {

using namespace contact;
using shapes::Polygon;
using shapes::Random;

const std::vector<Polygon>& polygons() {
  static const std::vector<Polygon> list = [] {
    std::vector<Polygon> made;
    for (const int n : {3, 4, 5, 8, 40}) made.push_back(shapes::make_regular_polygon(n, 1));
    made.push_back(shapes::polygon_hull(std::vector<Vec3d>{{-1, -0.1, 0}, {1, -0.1, 0}, {1, 0.1, 0}, {-1, 0.1, 0}}));
    // The origin beyond its border: no circle inside is known.
    made.push_back(shapes::polygon_hull(std::vector<Vec3d>{{1, 1, 0}, {2, 1.25, 0}, {1.25, 2, 0}, {0.9, 1.4, 0}}));
    Random draw(3, 1, 0);
    std::vector<Vec3d> points;
    for (int i = 0; i < 12; ++i) {
      const shapes::SineCosine t = shapes::sine_cosine(draw.uniform(0, 6.28));
      points.push_back({t.cosine, draw.uniform(0.6, 1) * t.sine, 0});
    }
    made.push_back(shapes::polygon_hull(points));
    return made;
  }();
  return list;
}

struct Case {
  Placed<Polygon> a, b;
  Vec3d offset;
};

Contact ask(const Case& c, const Options& options, Cache* cache) {
  return Planar::query(c.a, c.b, c.offset, options, cache);
}

// Two of the list, overlapping by about `overlap`; along axes when `square`.
Case overlapping(Random& draw, double overlap, bool square) {
  const auto pick = [&] {
    const Polygon& p = polygons()[static_cast<std::size_t>(draw.uniform(0, static_cast<double>(polygons().size())))];
    const double angle = square ? 0 : draw.uniform(0, 6.28);
    const shapes::SineCosine t = shapes::sine_cosine(angle);
    return Placed<Polygon>{&p, std::exp2(draw.uniform(-1, 1)), t.cosine, t.sine};
  };
  Case c{pick(), pick(), {}};
  const Vec3d together =
      placement(c.a, 1, {}).point(c.a.shape->centroid) - placement(c.b, 1, {}).point(c.b.shape->centroid);
  const shapes::SineCosine t = shapes::sine_cosine(square ? 0 : draw.uniform(0, 6.28));
  double inside = 0, outside = 12;
  for (int i = 0; i < 50; ++i) {
    const double middle = 0.5 * (inside + outside);
    c.offset = together + middle * Vec3d{t.cosine, t.sine, 0};
    (ask(c, {}, nullptr).gap < -overlap ? inside : outside) = middle;
  }
  c.offset = together + inside * Vec3d{t.cosine, t.sine, 0};
  return c;
}

bool same_bits(const Contact& x, const Contact& y) {
  const auto same = [](double u, double v) {
    return std::bit_cast<std::uint64_t>(u) == std::bit_cast<std::uint64_t>(v);
  };
  const auto same_vector = [&](const Vec3d& u, const Vec3d& v) { return same(u.x, v.x) && same(u.y, v.y); };
  return x.status == y.status && same(x.gap, y.gap) && same(x.gap_lower, y.gap_lower) &&
         same(x.gap_upper, y.gap_upper) && same_vector(x.normal, y.normal) && same_vector(x.point_a, y.point_a) &&
         same_vector(x.point_b, y.point_b) && same_vector(x.patch.centre, y.patch.centre) &&
         same(x.patch.spread[0], y.patch.spread[0]) && same(x.patch.spread[1], y.patch.spread[1]) &&
         same(x.patch.spread[3], y.patch.spread[3]);
}

TEST(PolygonPair, NoCacheChangesABitOfAnOverlap) {
  Random draw(5, 2, 0);
  for (int i = 0; i < 3000; ++i) {
    const double overlap = i % 3 == 0 ? draw.uniform(0, 0.05) : std::exp2(draw.uniform(-50, -3));
    const Case c = overlapping(draw, overlap, i % 5 == 0);
    const Contact cold = ask(c, {}, nullptr);
    Cache kept;
    ask(c, {}, &kept);
    EXPECT_TRUE(same_bits(ask(c, {}, &kept), cold)) << i;
    // Every side with some corner, and nonsense.
    for (std::uint32_t kind = 1; kind <= 3; ++kind)
      for (std::uint32_t side = 0; side < 9; ++side) {
        Cache other{{}, {kind << 30 | side, static_cast<std::uint32_t>(draw.uniform(0, 9))}};
        EXPECT_TRUE(same_bits(ask(c, {.overlap_only = true}, &other), cold)) << i;
      }
  }
}

// Its sides: 2 · side of a, 2 · side + 1 of b.
Corners overlap_of(const Case& c) {
  Corners buffer[2], *region = buffer, *spare = buffer + 1;
  const Loop a(*c.a.shape, placement(c.a, 1, {})), b(*c.b.shape, placement(c.b, 1, c.offset));
  for (std::uint32_t k = 0; k < a.size(); ++k) region->push_back({a.vertex(k), 2 * k});
  for (std::uint32_t k = 0; k < b.size(); ++k) {
    const Vec3d n = b.normal(k);
    cut(*region, n, b.height(k, n), 2 * k + 1, *spare);
    std::swap(region, spare);
  }
  return *region;
}

TEST(PolygonPair, PatchIsTheClippedArea) {
  Random draw(7, 2, 0);
  for (int i = 0; i < 2000; ++i) {
    const Case c = overlapping(draw, std::exp2(draw.uniform(-20, -5)), i % 5 == 0);
    const Contact answer = ask(c, {}, nullptr);
    ASSERT_LT(answer.gap, 0);
    AreaMoments moments;
    moments.add(overlap_of(c));
    Patch expected;
    ASSERT_TRUE(moments.patch(answer.normal, expected)) << i;
    const double size = max_abs(c.offset) + 4, error = 1e-15 * size * (1 + size / -answer.gap);
    EXPECT_LT(norm(answer.patch.centre - expected.centre), error) << i;
    for (const int k : {0, 1, 3}) EXPECT_NEAR(answer.patch.spread[k], expected.spread[k], 4 * size * error) << i;
  }
}

// The depth that comes with an answer, mostly in closed form, is that of the outline cut side by side.
TEST(PolygonPair, DepthIsThatOfTheClippedOutline) {
  Random draw(9, 2, 0);
  const auto body = [](const Placed<Polygon>& p) {
    return Body{.kind = shapes::Kind::polygon,
                .geometry = p.shape,
                .size = {p.scale, 0, 0},
                .rotation = {{{p.cosine, -p.sine, 0}, {p.sine, p.cosine, 0}, {0, 0, 1}}}};
  };
  int measured = 0;
  for (int i = 0; i < 3000; ++i) {
    const double overlap = i % 4 == 0 ? draw.uniform(0.01, 0.5) : std::exp2(draw.uniform(-20, -5));
    const Case c = overlapping(draw, overlap, i % 7 == 0);
    const Contact answer = ask(c, {.measure = true}, nullptr);
    OverlapDepth expected;
    if (!overlap_depth(body(c.a), body(c.b), c.offset, answer.normal, expected)) {
      EXPECT_EQ(answer.measure.depth, 0) << i;
      continue;
    }
    ++measured;
    // A side that is cut short has lost digits of its direction, a crossing of sides along each other of its place.
    double shortest = -answer.gap;
    const Corners region = overlap_of(c);
    const auto normal = [&](std::uint32_t side) {
      const Placed<Polygon>& p = side % 2 == 0 ? c.a : c.b;
      return placement(p, 1, {}).direction(p.shape->normals[side / 2]);
    };
    Vec3d chord{};
    for (std::size_t k = 0; k < region.size(); ++k) {
      const LoopCorner &before = region[k == 0 ? region.size() - 1 : k - 1], &corner = region[k];
      const double sine =
          before.side % 2 == corner.side % 2 ? 1 : norm(cross(normal(before.side), normal(corner.side)));
      shortest = std::min(shortest, sine * norm(corner.x - before.x));
      if (before.side % 2 != corner.side % 2) chord = corner.x - chord;
    }
    // Where it is deeper than wide, a way across turns it by that much more.
    const double deep = std::max(1.0, expected.depth / norm(chord));
    const double size = max_abs(c.offset) + 4, error = 1e-15 * size * (1 + size / shortest) * (deep * deep);
    EXPECT_NEAR(answer.measure.depth, expected.depth, 1e-14 * size) << i;
    EXPECT_NEAR(answer.measure.gain, expected.gain, error) << i;
    // As the slope of d: of bodies deep in each other it may be next to nothing, and has no direction then.
    EXPECT_LT(expected.gain * norm(answer.measure.normal - expected.normal), error) << i;
    EXPECT_LT(expected.gain * norm(answer.measure.point - expected.point), 4 * error) << i;
    // The same without the patch, and from the other body.
    EXPECT_EQ(ask(c, {.patch = false, .measure = true}, nullptr).measure.depth, answer.measure.depth) << i;
    EXPECT_EQ(ask({c.b, c.a, -c.offset}, {.measure = true}, nullptr).measure.depth, answer.measure.depth) << i;
  }
  EXPECT_GT(measured, 2800);
}

// Along an axis that held a step ago bodies are known to be apart without a search; the axis may be anything.
TEST(PolygonPair, ACachedAxisIsOnlyAProof) {
  Random draw(8, 2, 0);
  int proven = 0;
  for (int i = 0; i < 500; ++i) {
    Case c = overlapping(draw, 1e-3, false);
    Cache cache;
    c.offset = c.offset + 0.02 * ask(c, {}, nullptr).normal;
    if (ask(c, {}, &cache).status != Status::separated) continue;
    const Vec3d axis = cache.axis;
    EXPECT_FALSE(axis == Vec3d{});
    c.offset = c.offset + 1e-3 * Vec3d{draw.uniform(-1, 1), draw.uniform(-1, 1), 0};
    const Contact full = ask(c, {}, nullptr), quick = ask(c, {.overlap_only = true}, &cache);
    EXPECT_EQ(quick.status, Status::separated);
    EXPECT_LE(quick.gap, full.gap_upper);
    proven += cache.axis == axis ? 1 : 0;
    const shapes::SineCosine t = shapes::sine_cosine(draw.uniform(0, 6.28));
    Cache wrong{{t.cosine, t.sine, 0}, {7, 7}};
    const Contact misled = ask(c, {.overlap_only = true}, &wrong);
    EXPECT_EQ(misled.status, Status::separated);
    EXPECT_LE(misled.gap, full.gap_upper);
  }
  EXPECT_GT(proven, 200);
}

}  // namespace
