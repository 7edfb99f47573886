// Pieces of a body welded into one outline: edges that two pieces share, run through in opposite senses, cancel.
#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "shapes/convex.h"
#include "shapes/polygon_build.h"
#include "shapes/polyhedron_build.h"

namespace shapes {

namespace {

constexpr double weld = 1e-12;  // of the largest coordinate: data of fifteen digits, and what arithmetic made of them

using Edge = std::pair<std::uint32_t, std::uint32_t>;

// Points that are one by the first of them in order of (x, y).
struct Points {
  std::vector<Vec3d> list;
  double tolerance;

  Points(std::span<const std::vector<Vec3d>> pieces, double size) : tolerance(weld * size) {
    std::vector<Vec3d> all;
    for (const auto& piece : pieces)
      for (const Vec3d& v : piece) all.push_back({v.x, v.y, 0});
    std::sort(all.begin(), all.end(),
              [](const Vec3d& a, const Vec3d& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
    for (const Vec3d& v : all)
      if (index(v) == list.size()) list.push_back(v);
  }
  std::size_t index(const Vec3d& v) const {
    std::size_t i = 0;
    while (i < list.size() && max_abs(Vec3d{v.x, v.y, 0} - list[i]) > tolerance) ++i;
    return i;
  }
  // The points on the way from a to b, both included, in order.
  std::vector<std::uint32_t> between(std::uint32_t a, std::uint32_t b) const {
    const Vec3d along = list[b] - list[a];
    const double square = dot(along, along), length = std::sqrt(square);
    std::vector<std::pair<double, std::uint32_t>> on;
    for (std::uint32_t i = 0; i < list.size(); ++i) {
      const Vec3d x = list[i] - list[a];
      const double share = dot(x, along) / square;
      if (i != a && i != b && share > 0 && share < 1 &&
          std::abs(convex::accurate_cross(along, x).z) <= tolerance * length)
        on.emplace_back(share, i);
    }
    std::sort(on.begin(), on.end());
    std::vector<std::uint32_t> way{a};
    for (const auto& p : on) way.push_back(p.second);
    way.push_back(b);
    return way;
  }
};

double twice_area(const std::vector<Vec3d>& v) {
  double sum = 0;
  for (std::size_t i = 1; i + 1 < v.size(); ++i) sum += convex::accurate_cross(v[i] - v[0], v[i + 1] - v[0]).z;
  return sum;
}

// Edges of all pieces, counter-clockwise, less those that cancel; how often each is there.
std::map<Edge, int> border(std::span<const std::vector<Vec3d>> pieces, const Points& points) {
  std::map<Edge, int> edges;
  for (const auto& piece : pieces) {
    std::vector<std::uint32_t> loop;
    for (const Vec3d& v : piece) loop.push_back(static_cast<std::uint32_t>(points.index(v)));
    if (twice_area(piece) < 0) std::reverse(loop.begin(), loop.end());
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const std::uint32_t from = loop[i], to = loop[(i + 1) % loop.size()];
      if (from == to) continue;
      const auto way = points.between(from, to);
      for (std::size_t k = 0; k + 1 < way.size(); ++k) {
        const auto opposite = edges.find({way[k + 1], way[k]});
        if (opposite == edges.end())
          ++edges[{way[k], way[k + 1]}];
        else if (--opposite->second == 0)
          edges.erase(opposite);
      }
    }
  }
  return edges;
}

}  // namespace

Polygon polygon_from_pieces(std::span<const std::vector<Vec3d>> pieces) {
  if (pieces.empty()) throw Error("polygon: no pieces");
  double size = 0, area = 0;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    try {
      area += polygon_from_outline(pieces[i]).area;
    } catch (const Error& error) {
      throw Error("piece " + std::to_string(i) + ": " + error.what());
    }
    for (const Vec3d& v : pieces[i]) size = std::max({size, std::abs(v.x), std::abs(v.y)});
  }
  const Points points(pieces, size);
  std::map<std::uint32_t, std::uint32_t> next;
  for (const auto& [edge, times] : border(pieces, points)) {
    if (times > 1) throw Error("polygon: the pieces overlap");
    if (!next.insert(edge).second)
      throw Error("polygon: the pieces meet in a point only, or overlap; allowed: pieces that share edges");
  }
  if (next.empty()) throw Error("polygon: the pieces overlap");
  std::vector<Vec3d> outline;
  std::uint32_t at = next.begin()->first;
  do {
    outline.push_back(points.list[at]);
    const auto on = next.find(at);
    if (on == next.end()) throw Error("polygon: the pieces overlap");
    at = on->second;
  } while (at != next.begin()->first && outline.size() <= next.size());
  if (outline.size() != next.size())
    throw Error("polygon: the pieces are apart, overlap or enclose a hole; allowed: one outline");
  Polygon p = polygon_from_outline(outline);
  if (std::abs(p.area - area) > 1e-9 * area) throw Error("polygon: the pieces overlap");
  return p;
}

}  // namespace shapes
