#include "tests/extremes/bodies.h"

#include <algorithm>
#include <cmath>
#include <deque>

#include "tests/reference/core.h"

namespace extremes {
namespace {

using reference::Source;

// Built once for each level, and kept.
template <class Shape, class Build>
const Shape* known(std::deque<std::pair<double, Shape>>& list, double level, Build build) {
  for (const auto& [key, shape] : list)
    if (key == level) return &shape;
  list.emplace_back(level, build());
  return &list.back().second;
}

bool has_faces(Kind kind) { return kind == Kind::polyhedron || kind == Kind::rounded_polyhedron; }

}  // namespace

double least_size(const Body& b) {
  switch (b.kind) {
    case Kind::ellipsoid:
      return std::min({b.size.x, b.size.y, b.size.z});
    case Kind::ellipse:
      return std::min(b.size.x, b.size.y);
    case Kind::plane:
    case Kind::line:
      return HUGE_VAL;
    default:
      return b.circumradius();
  }
}

Vec3d farthest(const Body& b, const Vec3d& n) {
  const reference::Core<double> core(b, 1);
  return core.support(n) + core.ball * n;
}

bool make_thin(Body& b, double aspect, Source& draw) {
  static std::deque<std::pair<double, shapes::Polyhedron>> plates;
  static std::deque<std::pair<double, shapes::Polygon>> strips;
  switch (b.kind) {
    case Kind::ellipsoid:
      b.size = {1, draw.uniform(0, 1) < 0.5 ? 1 : 1 / aspect, 1 / aspect};
      return true;
    case Kind::ellipse:
      b.size = {1, 1 / aspect, 0};
      return true;
    case Kind::polyhedron:
    case Kind::rounded_polyhedron:
      b.geometry = known(plates, aspect, [&] { return shapes::make_box({1, 0.75, 1 / aspect}); });
      b.size = {1, b.kind == Kind::polyhedron ? 0 : 0.25 / aspect, 0};
      return true;
    case Kind::polygon:
      b.geometry = known(strips, aspect, [&] {
        const double h = 0.5 / aspect;
        return shapes::polygon_hull(std::vector<Vec3d>{{-1, -h, 0}, {1, -h, 0}, {1, h, 0}, {-1, h, 0}});
      });
      b.size = {1, 0, 0};
      return true;
    default:
      return false;
  }
}

bool make_sliver(Body& b, double height, Source& draw) {
  static std::deque<shapes::Polyhedron> solids;
  static std::deque<shapes::Polygon> outlines;
  std::vector<Vec3d> points;
  for (int k = 0; k < 7; ++k)
    points.push_back({draw.uniform(-1, 1), draw.uniform(-1, 1), height * draw.uniform(-1, 1)});
  if (has_faces(b.kind)) {
    solids.push_back(shapes::polyhedron_from_points(points, shapes::Frame::principal));
    b.geometry = &solids.back();
    if (b.kind == Kind::rounded_polyhedron) b.size.y = 0.1 * height;
    return true;
  }
  if (b.kind != Kind::polygon) return false;
  for (Vec3d& p : points) p = {p.x, p.z, 0};
  outlines.push_back(shapes::polygon_hull(points));
  b.geometry = &outlines.back();
  return true;
}

// Triangles over a spiral on the unit sphere: corners and edges nearly tie everywhere.
bool give_faces(Body& b, int count) {
  static std::deque<std::pair<double, shapes::Polyhedron>> balls;
  static std::deque<std::pair<double, shapes::Polygon>> wheels;
  if (b.kind == Kind::polygon) {
    b.geometry = known(wheels, count, [&] { return shapes::make_regular_polygon(count, 1); });
    return true;
  }
  if (!has_faces(b.kind)) return false;
  b.geometry = known(balls, count, [&] {
    std::vector<Vec3d> points;
    const int n = count / 2 + 2;
    for (int i = 0; i < n; ++i) {
      const double z = 1 - (2 * i + 1.0) / n, r = std::sqrt(1 - z * z), angle = 2.399963229728653 * i;
      points.push_back({r * std::cos(angle), r * std::sin(angle), z});
    }
    return shapes::polyhedron_from_points(points, shapes::Frame::principal);
  });
  return true;
}

Ridge ridge(const Body& b, Source& draw) {
  const auto world = [&](const Vec3d& v) { return normalized(b.placed().rotation * v); };
  if (has_faces(b.kind)) {
    const auto& p = *static_cast<const shapes::Polyhedron*>(b.geometry);
    const auto& e = draw.one_of(p.edges);
    return {world(p.vertices[e.vertex[1]] - p.vertices[e.vertex[0]]),
            world(p.faces[e.face[0]].normal + p.faces[e.face[1]].normal)};
  }
  if (b.kind == Kind::potential_particle) {
    const auto& p = *static_cast<const shapes::PotentialParticle*>(b.geometry);
    for (;;) {
      const Vec3d m = draw.one_of(p.planes).normal, n = draw.one_of(p.planes).normal;
      if (std::abs(dot(m, n)) < 0.95) return {world(cross(m, n)), world(m + n)};
    }
  }
  if (b.kind == Kind::plane) return {world({1, 0, 0}), world({0, 0, 1})};
  Vec3d along{1, 0, 0}, out{0, 0, 1};
  if (b.kind == Kind::ellipsoid && b.size.z > b.size.x) std::swap(along, out);
  return {world(along), world(out)};
}

shapes::Quatd aligning(const Vec3d& u, const Vec3d& v) {
  const Vec3d axis = cross(u, v);
  if (1 + dot(u, v) > 1e-6) return normalized(shapes::Quatd{1 + dot(u, v), axis.x, axis.y, axis.z});
  const Vec3d across = normalized(cross(u, std::abs(u.x) < 0.5 ? Vec3d{1, 0, 0} : Vec3d{0, 1, 0}));
  return {0, across.x, across.y, across.z};
}

shapes::Quatd turn_about(const Vec3d& axis, double angle) {
  const double s = std::sin(angle / 2);
  return {std::cos(angle / 2), s * axis.x, s * axis.y, s * axis.z};
}

}  // namespace extremes
