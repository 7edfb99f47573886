// Convex parts of polygons: they cover the polygon once, are convex, meet along seams; pieces become one outline.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <vector>

#include "shapes/polygon_build.h"
#include "shapes/polyhedron_build.h"

namespace {

using shapes::Polygon;
using shapes::Vec3d;

struct Named {
  const char* name;
  std::vector<Vec3d> outline;
};

std::vector<Vec3d> star(int tips, double inner) {
  std::vector<Vec3d> v;
  for (int i = 0; i < 2 * tips; ++i) {
    const double r = i % 2 == 0 ? 1 : inner, angle = 3.14159265358979324 * i / tips;
    v.push_back({r * std::cos(angle), r * std::sin(angle), 0});
  }
  return v;
}

const std::vector<Named> outlines{
    {"square", {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}},
    {"l", {{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}}},
    {"plus",
     {{1, 0, 0},
      {2, 0, 0},
      {2, 1, 0},
      {3, 1, 0},
      {3, 2, 0},
      {2, 2, 0},
      {2, 3, 0},
      {1, 3, 0},
      {1, 2, 0},
      {0, 2, 0},
      {0, 1, 0},
      {1, 1, 0}}},
    {"u", {{0, 0, 0}, {3, 0, 0}, {3, 3, 0}, {2, 3, 0}, {2, 1, 0}, {1, 1, 0}, {1, 3, 0}, {0, 3, 0}}},
    {"z", {{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {3, 1, 0}, {3, 2, 0}, {1, 2, 0}, {1, 1, 0}, {0, 1, 0}}},
    {"arrow", {{0, 0, 0}, {2, 1, 0}, {0, 2, 0}, {0.5, 1, 0}}},
    {"star", star(5, 0.4)},
    {"gear", star(24, 0.9)},
    {"hardly_reflex", {{0, 0, 0}, {1, 1e-9, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}}},
    {"spike", {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0.5 + 1e-6, 1, 0}, {0.5, 0.2, 0}, {0.5 - 1e-6, 1, 0}, {0, 1, 0}}},
};

double cross(const Vec3d& a, const Vec3d& b) { return a.x * b.y - a.y * b.x; }

double area(const std::vector<Vec3d>& v) {
  double sum = 0;
  for (std::size_t i = 0; i < v.size(); ++i) sum += 0.5 * cross(v[i], v[(i + 1) % v.size()]);
  return sum;
}

TEST(PolygonParts, cover_the_polygon_once_and_are_convex) {
  for (const Named& shape : outlines) {
    const Polygon p = shapes::polygon_from_outline(shape.outline);
    double sum = 0, outer = 0, rim = 0;
    int reflex = 0;
    const std::size_t n = p.vertices.size();
    for (std::size_t i = 0; i < n; ++i) {
      reflex += cross(p.vertices[(i + 1) % n] - p.vertices[i], p.vertices[(i + 2) % n] - p.vertices[i]) < 0 ? 1 : 0;
      rim += norm(p.vertices[(i + 1) % n] - p.vertices[i]);
    }
    EXPECT_LE(p.parts.size(), static_cast<std::size_t>(reflex) + 1) << shape.name;
    EXPECT_EQ(p.parts.size() == 1, p.convex) << shape.name;
    for (const Polygon::Part& part : p.parts) {
      const std::size_t m = part.vertices.size();
      sum += area(part.vertices);
      for (std::size_t k = 0; k < m; ++k) {
        const Vec3d &a = part.vertices[k], &b = part.vertices[(k + 1) % m];
        EXPECT_GE(cross(b - a, part.vertices[(k + 2) % m] - b), -1e-15) << shape.name;
        EXPECT_LE(norm(a - part.centre), part.radius * (1 + 1e-15)) << shape.name;
        EXPECT_NEAR(dot(part.normals[k], a), part.offsets[k], 1e-14) << shape.name;
        EXPECT_NEAR(dot(part.normals[k], b), part.offsets[k], 1e-14) << shape.name;
        if (part.edge[k] == Polygon::none) continue;
        outer += norm(b - a);
        EXPECT_TRUE(part.normals[k] == p.normals[part.edge[k]]) << shape.name;
      }
    }
    EXPECT_NEAR(sum, p.area, 1e-14 * p.area) << shape.name;
    EXPECT_NEAR(outer, rim, 1e-13 * rim) << shape.name;
  }
}

// All parts hang together by the seams, every reflex corner has one, and each seam lies on a cut of both its parts.
TEST(PolygonParts, seams_join_the_parts) {
  for (const Named& shape : outlines) {
    const Polygon p = shapes::polygon_from_outline(shape.outline);
    std::vector<std::size_t> root(p.parts.size());
    for (std::size_t i = 0; i < root.size(); ++i) root[i] = i;
    const std::function<std::size_t(std::size_t)> find = [&](std::size_t i) {
      return root[i] == i ? i : root[i] = find(root[i]);
    };
    std::vector<bool> served(p.vertices.size());
    for (const Polygon::Seam& s : p.seams) {
      root[find(s.part[0])] = find(s.part[1]);
      for (const std::uint32_t c : s.corner)
        if (c != Polygon::none) served[c] = true;
      for (const std::uint32_t part : s.part)
        for (const Vec3d& end : s.end) {
          double nearest = 1;
          for (std::size_t k = 0; k < p.parts[part].vertices.size(); ++k)
            if (p.parts[part].edge[k] == Polygon::none)
              nearest = std::min(nearest, std::abs(dot(p.parts[part].normals[k], end) - p.parts[part].offsets[k]));
          EXPECT_LE(nearest, 1e-14) << shape.name;
        }
    }
    for (std::size_t i = 0; i < root.size(); ++i) EXPECT_EQ(find(i), find(0)) << shape.name;
    const std::size_t n = p.vertices.size();
    for (std::size_t i = 0; i < n; ++i) {
      const Vec3d &a = p.vertices[(i + n - 1) % n], &b = p.vertices[i], &c = p.vertices[(i + 1) % n];
      EXPECT_TRUE(cross(b - a, c - b) > 0 || served[i]) << shape.name << " corner " << i;
    }
  }
}

TEST(PolygonParts, units_scale_bit_for_bit) {
  for (const Named& shape : outlines) {
    std::vector<Vec3d> large = shape.outline;
    for (Vec3d& v : large) v *= 0x1p40;
    const Polygon a = shapes::polygon_from_outline(shape.outline), b = shapes::polygon_from_outline(large);
    ASSERT_EQ(a.parts.size(), b.parts.size()) << shape.name;
    for (std::size_t i = 0; i < a.parts.size(); ++i)
      for (std::size_t k = 0; k < a.parts[i].vertices.size(); ++k)
        EXPECT_TRUE(a.parts[i].vertices[k] * 0x1p40 == b.parts[i].vertices[k]) << shape.name;
  }
}

bool same(const Polygon& a, const Polygon& b) {
  if (a.vertices.size() != b.vertices.size() || a.parts.size() != b.parts.size()) return false;
  for (std::size_t i = 0; i < a.vertices.size(); ++i)
    if (!(a.vertices[i] == b.vertices[i])) return false;
  return a.area == b.area && a.second_moment == b.second_moment;
}

using Pieces = std::vector<std::vector<Vec3d>>;

TEST(PolygonPieces, any_cut_of_a_body_gives_the_same_body) {
  const Polygon square = shapes::polygon_from_outline(outlines[0].outline);
  EXPECT_TRUE(same(square, shapes::polygon_from_pieces(
                               Pieces{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}, {{0, 1, 0}, {1, 1, 0}, {0, 0, 0}}})));
  EXPECT_TRUE(same(square, shapes::polygon_from_pieces(
                               Pieces{{{1, 0, 0}, {0, 0, 0}, {0, 1, 0}}, {{0, 1, 0}, {1, 1, 0}, {1, 0, 0}}})));
  // Four triangles about an inner point, and a corner of one piece on the edge of another.
  EXPECT_TRUE(same(square, shapes::polygon_from_pieces(Pieces{{{0, 0, 0}, {1, 0, 0}, {0.3, 0.7, 0}},
                                                              {{1, 0, 0}, {1, 1, 0}, {0.3, 0.7, 0}},
                                                              {{1, 1, 0}, {0, 1, 0}, {0.3, 0.7, 0}},
                                                              {{0, 1, 0}, {0, 0, 0}, {0.3, 0.7, 0}}})));
  const Polygon l = shapes::polygon_from_outline(outlines[1].outline);
  EXPECT_TRUE(same(l, shapes::polygon_from_pieces(Pieces{{{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}},
                                                         {{0, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}}})));
  EXPECT_TRUE(same(l, shapes::polygon_from_pieces(Pieces{{{1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}},
                                                         {{0, 0, 0}, {1, 0, 0}, {1, 2, 0}, {0, 2, 0}}})));
}

TEST(PolygonPieces, what_is_no_one_body_is_refused) {
  const std::vector<Vec3d> square{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  const auto moved = [&](double x, double y) {
    std::vector<Vec3d> v = square;
    for (Vec3d& p : v) p += Vec3d{x, y, 0};
    return v;
  };
  EXPECT_THROW(shapes::polygon_from_pieces(Pieces{}), shapes::Error);
  EXPECT_THROW(shapes::polygon_from_pieces(Pieces{square, moved(3, 0)}), shapes::Error) << "apart";
  EXPECT_THROW(shapes::polygon_from_pieces(Pieces{square, moved(1, 1)}), shapes::Error) << "a point in common";
  EXPECT_THROW(shapes::polygon_from_pieces(Pieces{square, square}), shapes::Error) << "twice";
  EXPECT_THROW(shapes::polygon_from_pieces(Pieces{square, moved(0.5, 0.25)}), shapes::Error) << "overlap";
  EXPECT_THROW(shapes::polygon_from_pieces(Pieces{square, moved(0.5, 0)}), shapes::Error) << "overlap along an edge";
  EXPECT_THROW(shapes::polygon_from_pieces(Pieces{moved(0, 0), moved(1, 0), moved(2, 0), moved(0, 1), moved(2, 1),
                                                  moved(0, 2), moved(1, 2), moved(2, 2)}),
               shapes::Error)
      << "a hole";
  EXPECT_THROW(shapes::polygon_from_pieces(Pieces{square, {{0, 0, 0}, {1, 0, 0}}}), shapes::Error) << "no area";
}

}  // namespace
