#include "shapes/form.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace shapes {
namespace {

// The farthest two of some points; of those that tie the first.
void farthest(const std::vector<Vec3d>& points, double& best, Vec3d& connection) {
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const Vec3d d = points[i] - points[j];
      if (const double square = dot(d, d); square > best) {
        best = square;
        connection = d;
      }
    }
}

// Points whose connection is perpendicular to e lie in one section across e. Between two heights of vertices corners
// of the section move along straight lines, so their distances are convex there: the longest is at a vertex's height.
void find_width(const Polyhedron& p, Form& f) {
  std::vector<double> height;
  for (const Vec3d& v : p.vertices) height.push_back(dot(f.along, v));
  std::vector<Vec3d> section;
  double best = 0;
  Vec3d connection{};
  for (const double h : height) {
    section.clear();
    for (std::size_t i = 0; i < p.vertices.size(); ++i)
      if (height[i] == h) section.push_back(p.vertices[i]);
    for (const auto& e : p.edges) {
      const double low = height[e.vertex[0]] - h, high = height[e.vertex[1]] - h;
      if (low * high < 0)
        section.push_back(p.vertices[e.vertex[0]] +
                          (p.vertices[e.vertex[1]] - p.vertices[e.vertex[0]]) * (low / (low - high)));
    }
    farthest(section, best, connection);
  }
  f.width = std::sqrt(best);
  connection -= dot(connection, f.along) * f.along;
  f.across = connection * (1 / norm(connection));
}

// Length of the body along the line through x in direction g.
double chord(const Polyhedron& p, const Vec3d& x, const Vec3d& g) {
  double low = -std::numeric_limits<double>::infinity(), high = -low;
  for (const auto& face : p.faces) {
    const double rate = dot(face.normal, g), room = face.offset - dot(face.normal, x);
    if (std::abs(rate) < 1e-14) continue;
    if (rate > 0)
      high = std::min(high, room / rate);
    else
      low = std::max(low, room / rate);
  }
  return high - low;
}

// Length along g is concave over the shadow: largest over a vertex, or where shadows of two edges cross.
void find_thickness(const Polyhedron& p, Form& f) {
  f.through = cross(f.along, f.across);
  for (const Vec3d& v : p.vertices) f.thickness = std::max(f.thickness, chord(p, v, f.through));
  for (std::size_t i = 0; i < p.edges.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const Vec3d& a = p.vertices[p.edges[i].vertex[0]];
      const Vec3d& b = p.vertices[p.edges[j].vertex[0]];
      const Vec3d u = p.vertices[p.edges[i].vertex[1]] - a, v = p.vertices[p.edges[j].vertex[1]] - b, d = b - a;
      const auto turn = [&](const Vec3d& q, const Vec3d& r) { return dot(cross(q, r), f.through); };
      const double area = turn(u, v);
      if (area == 0) continue;
      const double s = turn(d, v) / area, t = turn(d, u) / area;
      if (s < 0 || s > 1 || t < 0 || t > 1) continue;
      f.thickness = std::max(f.thickness, std::abs(dot(d + t * v - s * u, f.through)));
    }
}

}  // namespace

double Form::sphericity_cubed() const { return 36 * std::numbers::pi * (volume / area) * (volume / area) / area; }
double Form::sphericity() const { return std::cbrt(sphericity_cubed()); }

Form form_of(const Polyhedron& p) {
  Form f;
  f.volume = p.mass.volume;
  for (const auto& face : p.faces) {
    const auto corner = [&](std::uint32_t k) { return p.vertices[p.face_vertices[face.first + k]]; };
    for (std::uint32_t k = 1; k + 1 < face.count; ++k)
      f.area += 0.5 * norm(cross(corner(k) - corner(0), corner(k + 1) - corner(0)));
  }
  double best = 0;
  Vec3d connection{};
  farthest(p.vertices, best, connection);
  f.length = std::sqrt(best);
  f.along = connection * (1 / f.length);
  find_width(p, f);
  find_thickness(p, f);
  return f;
}

}  // namespace shapes
