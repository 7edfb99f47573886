// The kernel that tries one corner behind one side of two polygons, or of two convex parts: what it answers is what the
// searches answer, bit for bit, on every instruction set; whatever it is asked.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <vector>

#include "libcontact/kernels/chunk.h"
#include "libcontact/methods/planar.h"
#include "libcontact/methods/planar_apart.h"
#include "libcontact/methods/polygon_regions.h"
#include "shapes/math/random.h"
#include "shapes/math/trig.h"
#include "shapes/polygon_build.h"

namespace {

using namespace contact;
using kernels::PolygonChunk;
using shapes::Kind;
using shapes::Polygon;
using shapes::Random;

// What a lane is about.
struct Asked {
  Body a, b;
  Vec3d offset;
  PartSide side;
};
struct Expected {
  bool there = false;  // the search answers with this side
  Contact contact;
};

Polygon star(int points) {
  std::vector<Vec3d> outline;
  for (int i = 0; i < 2 * points; ++i) {
    const shapes::SineCosine t = shapes::sine_cosine(3.14159265358979 * i / points);
    const double r = i % 2 == 0 ? 1 : 0.45;
    outline.push_back({r * t.cosine, r * t.sine, 0});
  }
  return shapes::polygon_from_outline(outline);
}
Polygon cross_of(double w) {
  return shapes::polygon_from_outline(std::vector<Vec3d>{{w, -1, 0},
                                                         {w, -w, 0},
                                                         {1, -w, 0},
                                                         {1, w, 0},
                                                         {w, w, 0},
                                                         {w, 1, 0},
                                                         {-w, 1, 0},
                                                         {-w, w, 0},
                                                         {-1, w, 0},
                                                         {-1, -w, 0},
                                                         {-w, -w, 0},
                                                         {-w, -1, 0}});
}
const std::vector<Polygon>& whole() {
  static const std::vector<Polygon> list{
      shapes::make_regular_polygon(3, 1), shapes::make_regular_polygon(4, 1), shapes::make_regular_polygon(6, 1),
      shapes::make_regular_polygon(9, 1),
      shapes::polygon_hull(std::vector<Vec3d>{{-1, -0.1, 0}, {1, -0.1, 0}, {1, 0.1, 0}, {-1, 0.1, 0}})};
  return list;
}
const std::vector<Polygon>& cut() {
  static const std::vector<Polygon> list{
      cross_of(1.0 / 3),
      cross_of(0.1),
      star(5),
      star(3),
      shapes::centred(shapes::polygon_from_outline(
          std::vector<Vec3d>{{0, 0, 0}, {4, 0, 0}, {4, 1, 0}, {1, 1, 0}, {1, 4, 0}, {0, 4, 0}})),
      shapes::centred(shapes::polygon_from_outline(
          std::vector<Vec3d>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {3, 1, 0}, {3, 0, 0}, {4, 0, 0}, {4, 2, 0}, {0, 2, 0}})),
      shapes::make_regular_polygon(4, 1)};
  return list;
}

Body body(Random& draw, const std::vector<Polygon>& list, bool square) {
  Body b;
  b.kind = Kind::polygon;
  b.geometry = &list[static_cast<std::size_t>(draw.uniform(0, static_cast<double>(list.size())))];
  b.size = Vec3d{1, 1, 1} * draw.uniform(0.5, 2);
  const double half = square ? 0.25 * 3.14159265358979 * std::floor(draw.uniform(0, 8)) : draw.uniform(0, 3.14159);
  const shapes::SineCosine t = shapes::sine_cosine(half + draw.uniform(-1e-4, 1e-4));
  b.rotation = shapes::rotation_matrix(shapes::Quatd{t.cosine, 0, 0, t.sine});
  b.size.y = t.cosine;  // of the quaternion: a polygon's size is its first component
  b.size.z = t.sine;
  return b;
}

// b is brought nearer until it overlaps a by about `overlap`.
Vec3d place(Random& draw, const Body& a, const Body& b, double overlap) {
  const shapes::SineCosine t = shapes::sine_cosine(draw.uniform(0, 6.28));
  const Vec3d side = draw.uniform(-1, 1) * Vec3d{-t.sine, t.cosine, 0};
  double inside = 0, outside = 12;
  for (int i = 0; i < 45; ++i) {
    const double middle = 0.5 * (inside + outside);
    (query(a, b, side + middle * Vec3d{t.cosine, t.sine, 0}).gap < -overlap ? inside : outside) = middle;
  }
  return side + inside * Vec3d{t.cosine, t.sine, 0};
}

bool same_side(const PartSide& x, const PartSide& y) {
  return x.at.kind == y.at.kind && x.at.side == y.at.side && x.at.corner == y.at.corner && x.part_a == y.part_a &&
         x.part_b == y.part_b;
}

constexpr Options wanted{.overlap_only = true, .patch = true, .measure = true};

// The sides that a search answers with, and what it answers to each.
std::vector<std::pair<PartSide, Contact>> search(const Body& a, const Body& b, const Vec3d& offset, bool parts) {
  std::vector<std::pair<PartSide, Contact>> found;
  if (parts) {
    Contact list[max_regions];
    RegionSearch s;
    const std::size_t count = polygon_regions(a, b, offset, wanted, list, &s);
    for (std::size_t i = 0; i < count; ++i)
      if (s.side[i].at.kind != SideContact::none) found.emplace_back(s.side[i], list[i]);
    return found;
  }
  Cache cache;
  const Contact c = Planar::query(placed<Polygon>(a), placed<Polygon>(b), offset, wanted, &cache);
  const SideContact at = side_in(&cache, false);
  if (at.kind != SideContact::none) found.push_back({{at, 0, 0}, c});
  return found;
}

// Another side, corner or part, or the right one.
PartSide disturbed(Random& draw, PartSide side, const Asked& asked) {
  const auto count = [&](const Body& x, std::uint32_t part) {
    return static_cast<double>(static_cast<const Polygon*>(x.geometry)->parts[part].vertices.size());
  };
  const auto parts = [](const Body& x) {
    return static_cast<double>(static_cast<const Polygon*>(x.geometry)->parts.size());
  };
  const int what = static_cast<int>(draw.uniform(0, 5));
  if (what == 1) side.part_a = static_cast<std::uint32_t>(draw.uniform(0, parts(asked.a)));
  if (what == 2) side.part_b = static_cast<std::uint32_t>(draw.uniform(0, parts(asked.b)));
  if (what == 3)
    side.at.kind = side.at.kind == SideContact::side_of_a ? SideContact::side_of_b : SideContact::side_of_a;
  const bool of_b = side.at.kind == SideContact::side_of_b;
  const double sides = count(of_b ? asked.b : asked.a, of_b ? side.part_b : side.part_a),
               corners = count(of_b ? asked.a : asked.b, of_b ? side.part_a : side.part_b);
  if (what >= 1 || !(side.at.side < sides)) side.at.side = static_cast<std::uint32_t>(draw.uniform(0, sides));
  if (what == 4 || !(side.at.corner < corners)) side.at.corner = static_cast<std::uint32_t>(draw.uniform(0, corners));
  return side;
}

void fill(PolygonChunk& c, std::vector<Motion>& motion, std::size_t i, const Asked& q) {
  const Body* bodies[2] = {&q.a, &q.b};
  const bool of_b = q.side.at.kind == SideContact::side_of_b;
  for (int k = 0; k < 2; ++k) {
    const Body& x = *bodies[k];
    const auto& shape = *static_cast<const Polygon*>(x.geometry);
    const std::uint32_t part = k == 0 ? q.side.part_a : q.side.part_b;
    c.body[k][i] = static_cast<std::uint32_t>(motion.size());
    Motion m;
    m.position = k == 0 ? Vec3d{} : q.offset;
    m.bounding_radius = circumradius(x);
    m.equivalent_radius = m.inverse_mass = 1;
    motion.push_back(m);
    c.scale[k][i] = x.size.x;
    c.quat_w[k][i] = x.size.y;
    c.quat_z[k][i] = x.size.z;
    c.inertia[k][i] = 1;
    c.core[k][i] = shape.inscribed_radius;
    if (of_b == (k == 1))
      c.side[i] = shape.parts[part].side_rows[q.side.at.side].before;
    else
      c.corner[i] = shape.parts[part].corner_rows[q.side.at.corner].corner;
  }
  c.self_is_b[i] = of_b ? 1 : 0;
}

bool same(double x, double y) { return std::bit_cast<std::uint64_t>(x + 0.0) == std::bit_cast<std::uint64_t>(y + 0.0); }

// Lanes that were answered and held the right side, of how many; every answered lane is checked.
struct Count {
  int right = 0, answered = 0;
};
Count run(const kernels::KernelSet& set, bool parts, double overlap, bool square, std::uint64_t seed) {
  Count total;
  Random draw(seed, 1, 0);
  for (int chunk = 0; chunk < 40; ++chunk) {
    PolygonChunk c;
    kernels::LawChunk l;
    std::vector<Motion> motion;
    std::vector<Expected> expected;
    while (expected.size() < PolygonChunk::size) {
      const Body a = body(draw, parts ? cut() : whole(), square), b = body(draw, parts ? cut() : whole(), square);
      const Vec3d offset = place(draw, a, b, overlap);
      const auto found = search(a, b, offset, parts);
      if (found.empty()) continue;
      const auto& pick = found[static_cast<std::size_t>(draw.uniform(0, static_cast<double>(found.size())))];
      Asked q{a, b, offset, pick.first};
      q.side = disturbed(draw, q.side, q);
      fill(c, motion, expected.size(), q);
      Expected e;
      for (const auto& [side, contact] : found)
        if (same_side(side, q.side)) e = {true, contact};
      expected.push_back(e);
    }
    const std::uint32_t bits = set.polygon_sides(motion.data(), nullptr, c, PolygonChunk::size, parts, l);
    for (std::size_t i = 0; i < expected.size(); ++i) {
      const Expected& e = expected[i];
      total.right += e.there ? 1 : 0;
      if ((bits >> i & 1) == 0) continue;
      ++total.answered;
      EXPECT_TRUE(e.there) << set.name << " chunk " << chunk << " lane " << i;
      const Contact& q = e.contact;
      const OverlapDepth& d = q.measure;
      EXPECT_TRUE(same(l.overlap[i], d.depth) && same(l.normal.x[i], d.normal.x) && same(l.normal.y[i], d.normal.y) &&
                  same(c.arm_a[0][i], d.point.x) && same(c.arm_a[1][i], d.point.y) && same(c.gain[i], d.gain) &&
                  same(l.spread_xx[i], q.patch.spread[0]) && same(l.spread_yy[i], q.patch.spread[1]) &&
                  same(l.spread_xy[i], q.patch.spread[3]) && same(c.centre[0][i], q.patch.centre.x) &&
                  same(c.centre[1][i], q.patch.centre.y) && (parts || same(c.outward[0][i], q.normal.x)))
          << set.name << " chunk " << chunk << " lane " << i;
    }
  }
  return total;
}

TEST(PolygonLanes, AnswerWhatTheSearchOfWholePolygonsAnswers) {
  for (const kernels::KernelSet* set : kernels::kernel_sets())
    for (const double overlap : {1e-3, 1e-6, 0.05}) {
      const Count n = run(*set, false, overlap, false, 5);
      EXPECT_GT(n.answered, n.right / 2) << set->name << ' ' << overlap;
    }
}

TEST(PolygonLanes, AnswerWhatTheSearchOfRegionsAnswers) {
  for (const kernels::KernelSet* set : kernels::kernel_sets())
    for (const double overlap : {1e-3, 1e-6, 0.03}) {
      const Count n = run(*set, true, overlap, false, 6);
      EXPECT_GT(n.answered, n.right / 2) << set->name << ' ' << overlap;
    }
}

// Faces that lie on each other, arms in corners.
TEST(PolygonLanes, AnswerSoWhereBodiesStandSquare) {
  for (const kernels::KernelSet* set : kernels::kernel_sets())
    for (const bool parts : {false, true}) {
      const Count n = run(*set, parts, 1e-3, true, 7);
      EXPECT_GT(n.answered, n.right / 3) << set->name << ' ' << parts;
    }
}

}  // namespace
