// Contacts of polygons that are not convex: as the convex body where only convex material is met, one per region, cuts
// never seen.
#include "libcontact/methods/polygon_regions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "shapes/polygon_build.h"

namespace {

using contact::Body;
using contact::Contact;
using shapes::Kind;
using shapes::Polygon;
using shapes::Vec3d;

shapes::Mat3d turned(double angle) {
  return {{{std::cos(angle), -std::sin(angle), 0}, {std::sin(angle), std::cos(angle), 0}, {0, 0, 1}}};
}

Body body(const Polygon& p, double angle = 0, double scale = 1) {
  Body b;
  b.kind = Kind::polygon;
  b.geometry = &p;
  b.size = {scale, scale, scale};
  b.rotation = turned(angle);
  return b;
}
Body disc(double radius) {
  Body b;
  b.kind = Kind::disc;
  b.size = {radius, radius, radius};
  return b;
}
Body ellipse(double a, double b, double angle) {
  Body e;
  e.kind = Kind::ellipse;
  e.size = {a, b, 0};
  e.rotation = turned(angle);
  return e;
}
Body line(double angle = 0) {
  Body b;
  b.kind = Kind::line;
  b.rotation = turned(angle);
  return b;
}

std::vector<Contact> regions(const Body& a, const Body& b, const Vec3d& offset) {
  Contact found[contact::max_regions];
  const std::size_t count = contact::polygon_regions(a, b, offset, {true, true}, found);
  std::vector<Contact> list(found, found + count);
  std::sort(list.begin(), list.end(), [](const Contact& x, const Contact& y) {
    return x.patch.centre.x != y.patch.centre.x ? x.patch.centre.x < y.patch.centre.x
                                                : x.patch.centre.y < y.patch.centre.y;
  });
  return list;
}

// Largest difference of what a law sees.
double difference(const Contact& x, const Contact& y) {
  double d = std::max({std::abs(x.gap - y.gap), norm(x.normal - y.normal), norm(x.patch.centre - y.patch.centre)});
  for (int k = 0; k < 6; ++k) d = std::max(d, std::abs(x.patch.spread[k] - y.patch.spread[k]));
  return d;
}

const Polygon& ell() {  // legs of width 1 along the axes, the inner corner at (1, 1)
  static const Polygon p = shapes::polygon_from_outline(
      std::vector<Vec3d>{{0, 0, 0}, {4, 0, 0}, {4, 1, 0}, {1, 1, 0}, {1, 4, 0}, {0, 4, 0}});
  return p;
}
const Polygon& box() {
  static const Polygon p =
      shapes::polygon_from_outline(std::vector<Vec3d>{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}});
  return p;
}

TEST(PolygonRegions, a_flat_side_on_a_line_is_one_contact_over_its_whole_length) {
  const auto found = regions(body(ell()), line(), {0, 0.01, 0});
  ASSERT_EQ(found.size(), 1u);
  const Contact& c = found[0];
  EXPECT_NEAR(c.gap, -0.01, 1e-15);
  EXPECT_TRUE(c.certified && c.gap_lower <= -0.01 && c.gap_upper >= -0.01);
  EXPECT_TRUE(c.normal == (Vec3d{0, -1, 0}));
  EXPECT_LE(norm(c.patch.centre - Vec3d{2, 0.005, 0}), 1e-14);
  EXPECT_NEAR(c.patch.spread[0], 16.0 / 12, 1e-13);
}

TEST(PolygonRegions, feet_are_contacts_of_their_own) {
  const Polygon bridge = shapes::polygon_from_outline(
      std::vector<Vec3d>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {3, 1, 0}, {3, 0, 0}, {4, 0, 0}, {4, 2, 0}, {0, 2, 0}});
  const auto found = regions(body(bridge), line(), {0, 0.01, 0});
  ASSERT_EQ(found.size(), 2u);
  EXPECT_NEAR(found[0].patch.centre.x, 0.5, 1e-14);
  EXPECT_NEAR(found[1].patch.centre.x, 3.5, 1e-14);
  for (const Contact& c : found) EXPECT_NEAR(c.gap, -0.01, 1e-15);
  // On a block that it straddles: still two; on one that reaches one foot: one.
  const Polygon slab = shapes::polygon_from_outline(std::vector<Vec3d>{{-1, -1, 0}, {5, -1, 0}, {5, 0, 0}, {-1, 0, 0}});
  EXPECT_EQ(regions(body(bridge), body(slab), {0, 0.01, 0}).size(), 2u);
  EXPECT_EQ(regions(body(bridge), body(slab), {2.5, 0.01, 0}).size(), 1u);
}

TEST(PolygonRegions, a_block_in_the_corner_touches_both_legs) {
  const double down = 0.01, left = 0.003;
  const auto found = regions(body(box()), body(ell()), {-2 + left, -2 + down, 0});
  ASSERT_EQ(found.size(), 2u);
  const Contact &wall = found[0], &floor = found[1];
  EXPECT_NEAR(wall.gap, -left, 1e-15);
  EXPECT_LE(norm(wall.normal - Vec3d{-1, 0, 0}), 1e-15);
  EXPECT_NEAR(floor.gap, -down, 1e-15);
  EXPECT_LE(norm(floor.normal - Vec3d{0, -1, 0}), 1e-15);
  EXPECT_NEAR(floor.patch.centre.x, left / 2, 0.01);
  EXPECT_NEAR(wall.patch.centre.y, down / 2, 0.01);
}

TEST(PolygonRegions, a_disc_or_an_ellipse_in_the_corner_touches_both_legs) {
  const double r = 0.5, down = 0.01, left = 0.003;
  const Body bodies[] = {disc(r), ellipse(r, r, 0.3)};
  for (const Body& a : bodies) {
    const auto found = regions(a, body(ell()), {-1 - r + left, -1 - r + down, 0});
    ASSERT_EQ(found.size(), 2u);
    EXPECT_NEAR(found[0].gap, -left, 1e-15);
    EXPECT_NEAR(found[1].gap, -down, 1e-15);
    EXPECT_LE(norm(found[0].normal - Vec3d{-1, 0, 0}), 1e-15);
    EXPECT_LE(norm(found[1].normal - Vec3d{0, -1, 0}), 1e-15);
  }
  // So small that it covers the corner itself: still two.
  EXPECT_EQ(regions(disc(0.004), body(ell()), {-1 - 0.001, -1 - 0.001, 0}).size(), 2u);
}

TEST(PolygonRegions, crossing_bars_without_a_corner_inside_are_detected) {
  const auto bar = [](double length, double width) {
    return shapes::polygon_from_outline(
        std::vector<Vec3d>{{-length, -width, 0}, {length, -width, 0}, {length, width, 0}, {-length, width, 0}});
  };
  const Polygon a = bar(3, 0.1), b = bar(2, 0.2);
  const double quarter = std::acos(0.0);
  const Contact plus = contact::query(body(a), body(b, quarter), {0.5, 0.25, 0});
  EXPECT_EQ(plus.status, contact::Status::overlapping);
  EXPECT_NEAR(plus.gap, -(2 + 0.1 - 0.25), 1e-14);
  // The leg of an L across the leg of another: out along it, by the shorter way.
  const auto crossed = regions(body(ell()), body(ell()), {2, -2, 0});
  ASSERT_EQ(crossed.size(), 1u);
  EXPECT_NEAR(crossed[0].gap, -2, 1e-14);
  EXPECT_EQ(contact::query(body(ell()), body(ell()), {2, -2, 0}).status, contact::Status::overlapping);
}

// Convex bodies, also by way of regions: the separating axis answers the same.
TEST(PolygonRegions, convex_bodies_in_shallow_contact_are_one_region_with_the_same_answer) {
  std::mt19937_64 engine(11);
  std::uniform_real_distribution<double> unit(0, 1);
  const Polygon shapes_[] = {shapes::make_regular_polygon(3, 1), box(), shapes::make_regular_polygon(7, 1)};
  int compared = 0;
  for (int trial = 0; trial < 3000; ++trial) {
    const Polygon& p = shapes_[engine() % 3];
    const Polygon& q = shapes_[engine() % 3];
    Body a = body(p, 7 * unit(engine)), b = body(q, 7 * unit(engine), 0.5 + unit(engine));
    if (trial % 3 == 1) a = disc(0.5 + unit(engine));
    if (trial % 3 == 2) a = ellipse(0.5 + unit(engine), 0.5 + unit(engine), 7 * unit(engine));
    const double direction = 7 * unit(engine);
    Vec3d offset{4 * std::cos(direction), 4 * std::sin(direction), 0};
    const Contact apart = contact::query(a, b, offset);
    ASSERT_GT(apart.gap, 0);
    // Towards each other, along the normal, into an overlap of about 1e-3.
    offset -= (apart.gap + 1e-3 * unit(engine)) * apart.normal;
    const Contact whole = contact::query(a, b, offset, {false, true});
    if (!(whole.gap < 0)) continue;
    ASSERT_LE(difference(contact::query(a, b, offset, {true, true}), whole), 0);
    const auto found = regions(a, b, offset);
    ASSERT_EQ(found.size(), 1u) << trial;
    EXPECT_LE(difference(found[0], whole), 1e-12) << trial;
    ++compared;
  }
  EXPECT_GT(compared, 2500);
}

// A bar with a notch in its back is cut in three; on its flat side that must not show.
TEST(PolygonRegions, cuts_do_not_show) {
  const Polygon plain = shapes::polygon_from_outline(std::vector<Vec3d>{{0, 0, 0}, {4, 0, 0}, {4, 1, 0}, {0, 1, 0}});
  const Polygon notched = shapes::polygon_from_outline(std::vector<Vec3d>{
      {0, 0, 0}, {4, 0, 0}, {4, 1, 0}, {2.2, 1, 0}, {2.1, 0.8, 0}, {1.9, 0.8, 0}, {1.8, 1, 0}, {0, 1, 0}});
  ASSERT_FALSE(notched.convex);
  ASSERT_GE(notched.parts.size(), 3u);
  std::mt19937_64 engine(3);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int trial = 0; trial < 500; ++trial) {
    const double tilt = 0.02 * (unit(engine) - 0.5), x = 4 * unit(engine);
    const Body others[] = {body(box(), tilt), disc(1), ellipse(1, 0.6, tilt), line(tilt)};
    const double reach[] = {1, 1, contact::query(others[2], line(), {0, -9, 0}).gap * -1 + 9, 0};
    for (int k = 0; k < 4; ++k) {
      const bool last = k == 3;
      const Vec3d offset = last ? Vec3d{0, 0.02 * unit(engine), 0} : Vec3d{x, -reach[k] + 0.03 * unit(engine), 0};
      const auto answers = [&](const Polygon& p) {
        if (!last && others[k].kind != Kind::polygon) return regions(others[k], body(p), -offset);
        return regions(body(p), others[k], offset);
      };
      const auto want = answers(plain), got = answers(notched);
      ASSERT_EQ(got.size(), want.size()) << trial << ' ' << k;
      for (std::size_t i = 0; i < got.size(); ++i) EXPECT_LE(difference(got[i], want[i]), 1e-13) << trial << ' ' << k;
    }
  }
}

// A square cut along either diagonal and an L cut in three ways, turned in the plane so that corners that are one come
// out with their last bits apart: every query answers as that of the whole.
TEST(PolygonRegions, a_body_cut_anyhow_answers_as_the_whole) {
  using Outline = std::vector<Vec3d>;
  struct Cuts {
    Outline whole;
    std::vector<std::vector<Outline>> pieces;
  };
  const Outline q{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  const std::vector<Cuts> bodies{
      {q, {{{q[0], q[1], q[2]}, {q[0], q[2], q[3]}}, {{q[3], q[0], q[1]}, {q[3], q[1], q[2]}}}},
      {{{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}},
       {{{{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}}, {{0, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}}},
        {{{0, 0, 0}, {1, 0, 0}, {1, 2, 0}, {0, 2, 0}}, {{1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}}},
        {{{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}}, {{0, 0, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}}}}}};
  const auto placed_as_given = [](const Outline& corners, double shift) {  // the same points by another way
    Outline out;
    for (const Vec3d& v : corners)
      out.push_back(turned(0.3) * (v + Vec3d{shift, shift, 0}) - turned(0.3) * Vec3d{shift, shift, 0});
    return out;
  };
  std::mt19937_64 engine(7);
  std::uniform_real_distribution<double> unit(0, 1);
  const Polygon tip = shapes::make_regular_polygon(3, 0.7);
  int touching = 0;
  for (const Cuts& body_of : bodies) {
    const Polygon whole = shapes::polygon_from_outline(placed_as_given(body_of.whole, 0));
    for (const auto& list : body_of.pieces) {
      std::vector<Outline> pieces;
      for (const Outline& piece : list)
        pieces.push_back(placed_as_given(piece, 0.1 * static_cast<double>(pieces.size() + 1)));
      const Polygon welded = shapes::polygon_from_pieces(pieces);
      ASSERT_EQ(welded.vertices.size(), whole.vertices.size());
      for (int trial = 0; trial < 400; ++trial) {
        const double angle = 7 * unit(engine), direction = 7 * unit(engine), far = 2.2 * unit(engine);
        const Vec3d offset{far * std::cos(direction) + 0.5, far * std::sin(direction) + 0.5, 0};
        const Body others[] = {disc(0.4), ellipse(0.5, 0.3, angle), body(tip, angle), body(welded, angle)};
        for (const Body& other : others) {
          const bool first = other.kind != Kind::polygon;
          const auto answer = [&](const Polygon& p) {
            return first ? regions(other, body(p), offset) : regions(body(p), other, offset);
          };
          const auto want = answer(whole), got = answer(welded);
          ASSERT_EQ(got.size(), want.size()) << trial;
          for (std::size_t i = 0; i < got.size(); ++i) {
            ++touching;
            EXPECT_LE(std::abs(got[i].gap - want[i].gap), 1e-13) << trial;
            EXPECT_LE(norm(got[i].normal - want[i].normal), 1e-12) << trial;
          }
        }
      }
    }
  }
  EXPECT_GT(touching, 2000);
}

// The normal of every answer is that of an edge of one of the two outlines, or of a corner of the body against a round
// one; never that of a cut.
TEST(PolygonRegions, no_normal_is_that_of_a_cut) {
  std::mt19937_64 engine(23);
  std::uniform_real_distribution<double> unit(0, 1);
  std::size_t asked = 0;
  for (int trial = 0; trial < 3000; ++trial) {
    const double angle = 7 * unit(engine), direction = 7 * unit(engine), far = 5 * unit(engine);
    const Body a = body(ell()), b = body(ell(), angle);
    for (const Contact& c : regions(a, b, {far * std::cos(direction), far * std::sin(direction), 0})) {
      double nearest = 2;
      for (const Vec3d& n : ell().normals)
        nearest = std::min({nearest, norm(c.normal - n), norm(c.normal + b.rotation * n)});
      EXPECT_LE(nearest, 1e-15) << trial;
      ++asked;
    }
  }
  EXPECT_GT(asked, 1000u);
}

Polygon star(int tips) {
  std::vector<Vec3d> v;
  for (int i = 0; i < 2 * tips; ++i) {
    const double r = i % 2 == 0 ? 1 : 0.5, angle = 3.14159265358979324 * i / tips;
    v.push_back({r * std::cos(angle), r * std::sin(angle), 0});
  }
  return shapes::polygon_from_outline(v);
}

// Turned together, exchanged, scaled by a power of two.
TEST(PolygonRegions, answers_turn_and_scale_with_the_pair) {
  const Polygon tips = star(5);
  std::mt19937_64 engine(5);
  std::uniform_real_distribution<double> unit(0, 1);
  std::size_t several = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    const double angle = 7 * unit(engine), turn = 7 * unit(engine), direction = 7 * unit(engine);
    const double distance = 1.1 + 0.5 * unit(engine);
    const Vec3d offset{distance * std::cos(direction), distance * std::sin(direction), 0};
    const auto found = regions(body(tips), body(tips, angle), offset);
    several += found.size() > 1 ? 1 : 0;
    const auto turned_pair = regions(body(tips, turn), body(tips, angle + turn), turned(turn) * offset);
    ASSERT_EQ(found.size(), turned_pair.size()) << trial;
    std::vector<double> gaps, turned_gaps;
    for (const Contact& c : found) gaps.push_back(c.gap);
    for (const Contact& c : turned_pair) turned_gaps.push_back(c.gap);
    std::sort(gaps.begin(), gaps.end());
    std::sort(turned_gaps.begin(), turned_gaps.end());
    for (std::size_t i = 0; i < gaps.size(); ++i) EXPECT_NEAR(gaps[i], turned_gaps[i], 1e-13) << trial;
    const auto exchanged = regions(body(tips, angle), body(tips), -offset);
    ASSERT_EQ(found.size(), exchanged.size());
    const auto large = regions(body(tips, 0, 0x1p20), body(tips, angle, 0x1p20), offset * 0x1p20);
    ASSERT_EQ(found.size(), large.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
      EXPECT_EQ(found[i].gap * 0x1p20, large[i].gap);
      EXPECT_TRUE(found[i].normal == large[i].normal && found[i].patch.centre * 0x1p20 == large[i].patch.centre);
    }
  }
  EXPECT_GT(several, 50u);
}

TEST(PolygonRegions, more_than_a_pair_may_hold_are_not_certified) {
  std::vector<Vec3d> comb;
  // Teeth down: (i, 0) – (i + 0.4, 0) – (i + 0.5, 1) – (i + 1, 0) …
  for (int i = 0; i < 10; ++i) {
    comb.push_back({double(i), 0, 0});
    comb.push_back({i + 0.5, 0, 0});
    comb.push_back({i + 0.6, 1, 0});
    if (i < 9) comb.push_back({i + 0.9, 1, 0});
  }
  comb.push_back({10, 2, 0});
  comb.push_back({0, 2, 0});
  const Polygon p = shapes::polygon_from_outline(comb);
  const auto found = regions(body(p), line(), {0, 0.01, 0});
  ASSERT_EQ(found.size(), contact::max_regions);
  for (const Contact& c : found) EXPECT_FALSE(c.certified);
}

TEST(PolygonRegions, apart_the_nearest_part_answers) {
  EXPECT_NEAR(contact::query(body(ell()), body(box()), {3, 3, 0}).gap, 1, 1e-14);
  EXPECT_NEAR(contact::query(disc(0.5), body(ell()), {-2, -3, 0}).gap, 0.5, 1e-14);
  EXPECT_NEAR(contact::query(ellipse(0.5, 0.5, 1), body(ell()), {-2, -3, 0}).gap, 0.5, 1e-13);
  EXPECT_NEAR(contact::query(body(ell()), line(), {0, -0.25, 0}).gap, 0.25, 1e-15);
}

}  // namespace
