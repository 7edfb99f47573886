#include "shapes/polygon_build.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "shapes/convex.h"
#include "shapes/math/trig.h"
#include "shapes/polygon_parts.h"
#include "shapes/polyhedron_build.h"

namespace shapes {

namespace {

double area_of(const Vec3d& a, const Vec3d& b, const Vec3d& c) {  // twice, signed
  return convex::accurate_cross(b - a, c - a).z;
}

// Closed segments share a point.
bool segments_meet(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& d) {
  const auto apart = [](double p, double q, double r, double s) {
    return std::max(p, q) < std::min(r, s) || std::max(r, s) < std::min(p, q);
  };
  if (apart(a.x, b.x, c.x, d.x) || apart(a.y, b.y, c.y, d.y)) return false;
  const double c1 = area_of(a, b, c), d1 = area_of(a, b, d), a2 = area_of(c, d, a), b2 = area_of(c, d, b);
  return !((c1 > 0 && d1 > 0) || (c1 < 0 && d1 < 0) || (a2 > 0 && b2 > 0) || (a2 < 0 && b2 < 0));
}

// Points of unit size, in the plane; returns the exponent taken out.
int unit_points(std::span<const Vec3d> given, std::vector<Vec3d>& points) {
  if (given.size() < 3) throw Error("polygon: " + std::to_string(given.size()) + " vertices: allowed at least 3");
  for (const Vec3d& p : given) {
    if (!std::isfinite(p.x) || !std::isfinite(p.y)) throw Error("polygon: a vertex is not finite");
    points.push_back({p.x, p.y, 0});
  }
  const double size = convex::largest_coordinate(points);
  if (!(size > 0)) throw Error("polygon: all vertices at the origin: it needs an area");
  const int exponent = convex::exponent_above(size);
  for (Vec3d& p : points) p = convex::times_two_to(p, -exponent);
  return exponent;
}

void drop_idle_vertices(std::vector<Vec3d>& v) {
  for (bool again = true; again && v.size() >= 3;) {
    again = false;
    for (std::size_t i = 0; i < v.size() && v.size() >= 3; ++i) {
      const std::size_t n = v.size();
      const Vec3d &before = v[(i + n - 1) % n], &after = v[(i + 1) % n];
      const Vec3d chord = after - before, step = v[i] - before;
      const double length = norm(chord);
      const bool same = max_abs(step) <= convex::rounding;
      const bool between = dot(step, chord) >= 0 && dot(after - v[i], chord) >= 0;
      if (same || (between && std::abs(convex::accurate_cross(chord, step).z) <= convex::rounding * length)) {
        v.erase(v.begin() + static_cast<std::ptrdiff_t>(i));
        again = true;
        break;
      }
    }
  }
}

Polygon finish(std::vector<Vec3d> v, int exponent) {
  drop_idle_vertices(v);
  const std::size_t n = v.size();
  if (n < 3) throw Error("polygon: the vertices enclose no area");
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 1; j < n; ++j) {
      const bool neighbours = j == i + 1 || (i == 0 && j == n - 1);
      if (!neighbours && segments_meet(v[i], v[i + 1], v[j], v[(j + 1) % n]))
        throw Error("polygon: edges " + std::to_string(i) + " and " + std::to_string(j) +
                    " meet: the outline must not cross or touch itself");
    }
  Polygon p;
  double twice = 0;
  for (std::size_t i = 1; i + 1 < n; ++i) twice += area_of(v[0], v[i], v[i + 1]);
  if (twice < 0) std::reverse(v.begin(), v.end());
  const auto lower = [](const Vec3d& a, const Vec3d& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; };
  std::rotate(v.begin(), std::min_element(v.begin(), v.end(), lower), v.end());
  // Triangles about the first vertex, signed: exact for any simple outline.
  double area = 0, moment = 0;
  Vec3d first{};
  for (std::size_t i = 1; i + 1 < n; ++i) {
    const double w = 0.5 * area_of(v[0], v[i], v[i + 1]);
    area += w;
    first += (w / 3) * ((v[i] - v[0]) + (v[i + 1] - v[0]));
  }
  if (!(area > 0)) throw Error("polygon: the vertices enclose no area");
  const Vec3d centre = v[0] + (1 / area) * first;
  p.convex = true;
  for (std::size_t i = 0; i < n; ++i) {
    const Vec3d &a = v[i], &b = v[(i + 1) % n], &c = v[(i + 2) % n];
    const Vec3d x = a - centre, y = b - centre, along = b - a;
    moment += convex::accurate_cross(x, y).z * (dot(x, x) + dot(x, y) + dot(y, y)) / 12;
    const Vec3d normal = convex::unit({along.y, -along.x, 0});
    p.normals.push_back(normal);
    p.offsets.push_back(0.5 * (dot(normal, a) + dot(normal, b)));
    p.convex = p.convex && area_of(a, b, c) > 0;
    p.circumradius = std::max(p.circumradius, norm(a));
  }
  p.area = area;
  p.centroid = centre;
  p.second_moment = moment;
  if (p.convex) p.inscribed_radius = *std::min_element(p.offsets.begin(), p.offsets.end());
  p.vertices = std::move(v);
  p.second_border = static_cast<std::uint32_t>(n);
  cut_into_parts(p);
  to_units(p, exponent);
  make_rows(p);
  return p;
}

}  // namespace

Polygon polygon_from_outline(std::span<const Vec3d> outline) {
  std::vector<Vec3d> v;
  const int exponent = unit_points(outline, v);
  return finish(std::move(v), exponent);
}

Polygon polygon_hull(std::span<const Vec3d> points) {
  std::vector<Vec3d> p, hull;
  const int exponent = unit_points(points, p);
  std::sort(p.begin(), p.end(), [](const Vec3d& a, const Vec3d& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
  for (int pass = 0; pass < 2; ++pass) {  // lower chain, then upper
    const std::size_t start = hull.size();
    for (const Vec3d& x : p) {
      while (hull.size() >= start + 2 && area_of(hull[hull.size() - 2], hull.back(), x) <= 0) hull.pop_back();
      hull.push_back(x);
    }
    hull.pop_back();
    std::reverse(p.begin(), p.end());
  }
  if (hull.size() < 3) throw Error("polygon: the vertices enclose no area");
  return finish(std::move(hull), exponent);
}

Polygon make_regular_polygon(int sides, double circumradius) {
  if (sides < 3) throw Error("polygon: sides = " + std::to_string(sides) + ": allowed >= 3");
  if (!(circumradius > 0) || !std::isfinite(circumradius)) throw Error("polygon: circumradius: allowed > 0");
  std::vector<Vec3d> v;
  for (int i = 0; i < sides; ++i) {
    const auto t = sine_cosine(2 * 3.14159265358979323846 * i / sides);
    v.push_back({circumradius * t.cosine, circumradius * t.sine, 0});
  }
  return polygon_from_outline(v);
}

Polygon centred(const Polygon& p) {
  if (max_abs(p.centroid) <= convex::rounding * convex::largest_coordinate(p.vertices)) return p;
  std::vector<Vec3d> v;
  for (const Vec3d& x : p.vertices) v.push_back(x - p.centroid);
  return polygon_from_outline(v);
}

double perimeter(const Polygon& p) {
  double sum = 0;
  for (std::size_t i = 0; i < p.vertices.size(); ++i)
    sum += convex::safe_norm(p.vertices[(i + 1) % p.vertices.size()] - p.vertices[i]);
  return sum;
}

}  // namespace shapes
