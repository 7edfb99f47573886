// Bands along chains: the outline that they stand for, one part for each side, rings, refusals.
#include "shapes/polygon_band.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "shapes/polygon_build.h"
#include "shapes/polyhedron_build.h"

namespace {

using shapes::Polygon;
using shapes::Vec3d;
using Chain = std::vector<Vec3d>;

double cross(const Vec3d& a, const Vec3d& b) { return a.x * b.y - a.y * b.x; }

// Of a regular polygon, counter-clockwise.
Chain circle(int sides, double radius, double from = 0.1) {
  Chain v;
  for (int i = 0; i < sides; ++i) {
    const double angle = from + 2 * 3.14159265358979324 * i / sides;
    v.push_back({radius * std::cos(angle), radius * std::sin(angle), 0});
  }
  return v;
}

const std::vector<Chain> open_chains{
    {{0, 0, 0}, {1, 0.3, 0}, {2, 0, 0}},                                          // ridge
    {{0, 1, 0}, {0.7, -0.2, 0}, {2, 1.5, 0}},                                     // valley
    {{-1, 3, 0}, {-1, 1, 0}, {-0.2, 0, 0}, {0.3, 0, 0}, {1, 1, 0}, {1.1, 3, 0}},  // hopper
    {{0, 0, 0}, {1, 1, 0}, {2, 0, 0}, {3, 1, 0}, {4, -0.5, 0}},                   // zigzag
};

// What an open band is, the polygon of its border is too: area, moments, and the convex parts, to round-off.
TEST(PolygonBand, is_the_polygon_of_its_border_cut_at_the_seams) {
  for (const Chain& chain : open_chains) {
    const Polygon band = shapes::band_along(chain, 0.1, false), p = shapes::polygon_from_outline(band.vertices);
    EXPECT_FALSE(band.convex);
    EXPECT_NEAR(band.area, p.area, 1e-14 * p.area);
    EXPECT_LT(norm(band.centroid - p.centroid), 1e-14);
    EXPECT_NEAR(band.second_moment, p.second_moment, 1e-13 * p.second_moment);
    EXPECT_DOUBLE_EQ(band.circumradius, p.circumradius);
    ASSERT_EQ(band.parts.size(), chain.size() - 1);
    ASSERT_EQ(p.parts.size(), band.parts.size());
    ASSERT_EQ(p.seams.size(), band.seams.size());
    for (const Polygon::Part& part : band.parts) {
      const auto twin = std::find_if(p.parts.begin(), p.parts.end(), [&](const Polygon::Part& q) {
        return norm(q.centre - part.centre) < 1e-13 && std::abs(q.radius - part.radius) < 1e-13;
      });
      ASSERT_NE(twin, p.parts.end());
      EXPECT_EQ(twin->vertices.size(), 4u);
    }
    for (const Polygon::Seam& seam : band.seams) {
      const Vec3d& reflex = band.vertices[seam.corner[0]];
      EXPECT_TRUE(std::any_of(p.seams.begin(), p.seams.end(),
                              [&](const Polygon::Seam& s) { return norm(p.vertices[s.corner[0]] - reflex) < 1e-14; }));
    }
    for (std::uint32_t i = 0; i < band.vertices.size(); ++i) EXPECT_EQ(band.next(band.before(i)), i);
  }
}

// Each side keeps its own place and normal, with the bodies on its left and the solid `depth` deep on its right.
TEST(PolygonBand, sides_are_those_of_the_chain) {
  for (const bool closed : {false, true})
    for (const Chain& chain : closed ? std::vector<Chain>{circle(3, 1), circle(12, 2)} : open_chains) {
      const double depth = 0.1;
      const Polygon p = shapes::band_along(chain, depth, closed);
      for (std::size_t k = 0; k < p.parts.size(); ++k) {
        const Vec3d &a = chain[k], &b = chain[(k + 1) % chain.size()];
        const Polygon::Part& part = p.parts[k];
        ASSERT_EQ(part.vertices.size(), 4u);
        EXPECT_TRUE(part.vertices[0] == b && part.vertices[1] == a);
        const Vec3d along = normalized(b - a), left{-along.y, along.x, 0};
        EXPECT_LT(norm(part.normals[0] - left), 1e-15);
        EXPECT_NEAR(part.offsets[0], dot(left, a), 1e-14);
        EXPECT_NEAR(part.offsets[2], -dot(left, a) + depth, 1e-14);
        for (std::size_t i = 0; i < 4; ++i) {
          const Vec3d &v = part.vertices[i], &next = part.vertices[(i + 1) % 4];
          EXPECT_GT(cross(next - v, part.vertices[(i + 2) % 4] - next), 0);
          EXPECT_NEAR(dot(part.normals[i], v), part.offsets[i], 1e-14);
          EXPECT_NEAR(dot(part.normals[i], next), part.offsets[i], 1e-14);
          if (part.edge[i] == Polygon::none) continue;
          EXPECT_TRUE(part.normals[i] == p.normals[part.edge[i]]);
          EXPECT_TRUE(p.vertices[part.edge[i]] == v && p.vertices[p.next(part.edge[i])] == next);
        }
      }
    }
}

// A ring either way: between two regular polygons whose sides are `depth` apart.
TEST(PolygonBand, a_closed_chain_makes_a_ring) {
  const int n = 12;
  const double radius = 2, depth = 0.25, height = radius * std::cos(3.14159265358979324 / n);
  const auto area = [&](double h) { return n * h * h * std::tan(3.14159265358979324 / n); };
  Chain outwards = circle(n, radius), inwards = outwards;
  std::reverse(inwards.begin(), inwards.end());
  const Polygon drum = shapes::band_along(outwards, depth, true), pipe = shapes::band_along(inwards, depth, true);
  EXPECT_NEAR(drum.area, area(height + depth) - area(height), 1e-13);
  EXPECT_NEAR(pipe.area, area(height) - area(height - depth), 1e-13);
  for (const Polygon* p : {&drum, &pipe}) {
    EXPECT_EQ(p->parts.size(), 12u);
    EXPECT_EQ(p->seams.size(), 12u);
    EXPECT_EQ(p->second_border, 12u);
    EXPECT_LT(norm(p->centroid), 1e-15);
    double twice = 0;  // the border about the hole runs against the other
    for (std::uint32_t i = 0; i < p->vertices.size(); ++i) twice += cross(p->vertices[i], p->vertices[p->next(i)]);
    EXPECT_NEAR(0.5 * twice, p->area, 1e-13);
    for (const Polygon::Seam& s : p->seams) {
      const Vec3d &before = p->normals[p->before(s.corner[0])], &after = p->normals[s.corner[0]];
      EXPECT_LT(cross(before, after), 0) << "a seam begins in a reflex corner";
    }
  }
}

TEST(PolygonBand, vertices_on_the_way_are_dropped_and_one_side_is_convex) {
  const Polygon p = shapes::band_along(Chain{{0, 0, 0}, {0.25, 0, 0}, {0.75, 0, 0}, {1, 0, 0}}, 0.5, false);
  EXPECT_TRUE(p.convex);
  EXPECT_EQ(p.parts.size(), 1u);
  EXPECT_DOUBLE_EQ(p.area, 0.5);
  EXPECT_TRUE(p.vertices[0] == (Vec3d{0, -0.5, 0}));
  const Polygon bent = shapes::band_along(Chain{{0, 0, 0}, {0.5, 0, 0}, {1, 0, 0}, {2, 1, 0}}, 0.5, false);
  const Polygon same = shapes::band_along(Chain{{0, 0, 0}, {1, 0, 0}, {2, 1, 0}}, 0.5, false);
  EXPECT_TRUE(bent.vertices == same.vertices);
  // A closed chain may begin anywhere on a side.
  const Chain square{{0.5, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 0}};
  EXPECT_EQ(shapes::band_along(square, 0.1, true).parts.size(), 4u);
}

TEST(PolygonBand, powers_of_two_scale_bit_for_bit) {
  for (const bool closed : {false, true}) {
    Chain chain = closed ? circle(7, 0.3) : open_chains[3];
    const Polygon p = shapes::band_along(chain, 0.03, closed);
    const double u = 0x1p-20;
    for (Vec3d& v : chain) v *= u;
    const Polygon q = shapes::band_along(chain, 0.03 * u, closed);
    EXPECT_EQ(q.area, p.area * u * u);
    EXPECT_EQ(q.circumradius, p.circumradius * u);
    ASSERT_EQ(q.vertices.size(), p.vertices.size());
    for (std::size_t i = 0; i < p.vertices.size(); ++i) {
      EXPECT_TRUE(q.vertices[i] == p.vertices[i] * u);
      EXPECT_TRUE(q.normals[i] == p.normals[i]);
      EXPECT_EQ(q.offsets[i], p.offsets[i] * u);
    }
  }
}

struct Refused {
  Chain chain;
  double depth;
  bool closed;
  const char* message;
};

TEST(PolygonBand, what_has_no_band_is_refused) {
  Chain clockwise = circle(6, 1);
  std::reverse(clockwise.begin(), clockwise.end());
  const Refused list[] = {
      {{{0, 0, 0}}, 1, false, "1 vertices: allowed at least 2"},
      {{{0, 0, 0}, {1, 0, 0}}, 1, true, "2 vertices: allowed at least 3"},
      {{{0, 0, 0}, {1, 0, 0}}, 0, false, "depth: allowed > 0"},
      {{{0, 0, 0}, {1, 0, 0}}, 1e-12, false, "below 1e-9 of its largest coordinate"},
      {{{0, 0, 0}, {1, NAN, 0}}, 1, false, "not finite"},
      {{{0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {2, 1, 0}}, 0.1, false, "vertices 1 and 2 are one point"},
      {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 0, 0}}, 0.1, false, "it ends at vertex 3 where it begins"},
      {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 0, 0}}, 0.1, true, "it ends at vertex 3 where it begins"},
      {{{0, 0, 0}, {1, 0, 0}, {0.5, 0, 0}}, 0.1, false, "turns back on itself at vertex 1"},
      {{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, 0.1, true, "enclose no area"},
      {{{0, 0, 0}, {2, 2, 0}, {2, 0, 0}, {0, 2, 0}},
       0.1,
       false,
       "from vertex 0 to 1 and the side from vertex 2 to 3 meet"},
      {{{0, 0, 0}, {2, 0, 0}, {2, -1, 0}, {0, -1, 0}}, 0.6, false, "depth is too large between the bends"},
      {{{0, 0, 0}, {0, 1, 0}, {1, 1, 0}, {1, 0, 0}, {0.2, 0, 0}}, 0.3, false, "meet: with its depth"},
      {clockwise, 0.9, true,
       "depth is too large between the bends of the side from vertex 0 to 1; allowed: below 0.86"},
  };
  for (const Refused& r : list) {
    std::string message = "accepted";
    try {
      shapes::band_along(r.chain, r.depth, r.closed);
    } catch (const shapes::Error& error) {
      message = error.what();
    }
    EXPECT_NE(message.find(r.message), std::string::npos) << r.message << "\n  " << message;
  }
}

}  // namespace
