// The depth of a region and the force that goes with it: its slope as the bodies move, also where the region ends at a
// cut, which moves with the body that it is of.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "libcontact/methods/polygon_regions.h"
#include "shapes/math/random.h"
#include "shapes/math/trig.h"
#include "shapes/polygon_build.h"

namespace {

using namespace contact;
using shapes::Polygon;
using shapes::Random;

const std::vector<Polygon>& polygons() {
  static const std::vector<Polygon> list{shapes::polygon_from_outline(std::vector<Vec3d>{{1, -3, 0},
                                                                                         {1, -1, 0},
                                                                                         {3, -1, 0},
                                                                                         {3, 1, 0},
                                                                                         {1, 1, 0},
                                                                                         {1, 3, 0},
                                                                                         {-1, 3, 0},
                                                                                         {-1, 1, 0},
                                                                                         {-3, 1, 0},
                                                                                         {-3, -1, 0},
                                                                                         {-1, -1, 0},
                                                                                         {-1, -3, 0}}),
                                         shapes::centred(shapes::polygon_from_outline(std::vector<Vec3d>{
                                             {0, 0, 0}, {4, 0, 0}, {4, 1, 0}, {1, 1, 0}, {1, 4, 0}, {0, 4, 0}})),
                                         shapes::make_regular_polygon(4, 2)};
  return list;
}

struct Pair {
  const Polygon *a, *b;
  Vec3d offset;
  double angle_a, angle_b;

  static Body body(const Polygon* p, double angle) {
    Body x{.kind = shapes::Kind::polygon, .geometry = p, .size = {1, 1, 1}};
    const double c = std::cos(angle), s = std::sin(angle);
    x.rotation = {{{c, -s, 0}, {s, c, 0}, {0, 0, 1}}};
    return x;
  }
  std::vector<Contact> regions(RegionSearch* search = nullptr) const {
    Contact list[max_regions];
    const std::size_t count =
        polygon_regions(body(a, angle_a), body(b, angle_b), offset, {.patch = true, .measure = true}, list, search);
    return {list, list + count};
  }
};

const Contact& nearest(const std::vector<Contact>& list, const Vec3d& to) {
  const Contact* best = &list[0];
  for (const Contact& c : list)
    if (norm(c.patch.centre - to) < norm(best->patch.centre - to)) best = &c;
  return *best;
}

// Along both edges from vertex i.
struct Corner {
  Vec3d at, along, back;
  Corner(const Polygon& p, std::uint32_t i) : at(p.vertices[i]) {
    const Vec3d next = p.vertices[p.next(i)] - at, before = p.vertices[p.before(i)] - at;
    along = next * (1 / norm(next));
    back = before * (1 / norm(before));
  }
  bool reflex() const { return along.x * back.y - along.y * back.x < 0; }
};
Vec3d turned(const Vec3d& v, double angle) {
  return {std::cos(angle) * v.x - std::sin(angle) * v.y, std::sin(angle) * v.x + std::cos(angle) * v.y, 0};
}

// A convex corner of the second body in a reflex one of the first, under both edges by about `overlap`; one of the two
// bodies, drawn, is called a.
Pair nested(Random& draw, double overlap, double tilt) {
  const auto pick = [&](std::size_t count) {
    return &polygons()[static_cast<std::size_t>(draw.uniform(0, static_cast<double>(count)))];
  };
  const auto corner = [&](const Polygon& p, bool reflex) {
    for (;;) {
      const Corner c(p, static_cast<std::uint32_t>(draw.uniform(0, static_cast<double>(p.vertices.size()))));
      if (c.reflex() == reflex) return c;
    }
  };
  const Polygon *holder = pick(2), *guest = pick(3);
  const Corner hole = corner(*holder, true), tip = corner(*guest, false);
  const Vec3d into = hole.along + hole.back, inside = tip.along + tip.back;
  const double angle = draw.uniform(0, 6.28),
               turn = angle + std::atan2(into.y, into.x) - std::atan2(inside.y, inside.x) + draw.uniform(-tilt, tilt);
  const Vec3d under = hole.at - overlap * (draw.uniform(0.5, 1.5) * hole.along + draw.uniform(0.5, 1.5) * hole.back);
  const Vec3d offset = turned(under, angle) - turned(tip.at, turn);
  if (draw.uniform(0, 1) < 0.5) return {holder, guest, offset, angle, turn};
  return {guest, holder, -offset, turn, angle};
}

struct Count {
  int regions = 0, several = 0;
};

void expect_slopes(double overlap, double tilt, std::uint64_t seed, Count& count) {
  Random draw(seed, 1, 0);
  for (int i = 0; i < 60; ++i) {
    const Pair p = nested(draw, overlap, tilt);
    const auto list = p.regions();
    if (list.size() > 1) ++count.several;
    for (const Contact& c : list) {
      const OverlapDepth& d = c.measure;
      if (!(d.depth > 0.05 * overlap)) continue;
      ++count.regions;
      for (int k = 0; k < 3; ++k) {
        const Vec3d u = k == 0 ? Vec3d{1, 0, 0} : k == 1 ? Vec3d{0, 1, 0} : Vec3d{};
        const double turn = k == 2 ? 1 : 0, step = 1e-4 * overlap;
        const auto depth_at = [&](double way) {
          Pair moved = p;
          moved.offset += way * u;
          moved.angle_b += way * turn;
          const auto there = moved.regions();
          return there.size() == list.size() ? nearest(there, c.patch.centre).measure.depth : 0;
        };
        const double high = depth_at(step), low = depth_at(-step);
        if (!(high > 0 && low > 0)) continue;
        const Vec3d arm = d.point - p.offset, motion = u + turn * Vec3d{-arm.y, arm.x, 0};
        EXPECT_NEAR((low - high) / (2 * step), d.gain * dot(d.normal, motion), 2e-4)
            << "pair " << i << " overlap " << overlap << " along " << k;
      }
    }
  }
}

TEST(PolygonRegionSlope, ForceIsTheSlopeOfTheDepth) {
  Count count;
  for (const double overlap : {3e-3, 3e-2})
    for (const double tilt : {1e-3, 0.1}) expect_slopes(overlap, tilt, 11, count);
  EXPECT_GT(count.regions, 200);
  EXPECT_GT(count.several, 100);
}

}  // namespace
