// Polyhedra from files: the surface must be closed, oriented alike throughout, and convex. The solid is the exact hull
// of its vertices, so polygons whose printed coordinates do not lie in one plane come out as several faces.
#include <algorithm>
#include <cstdio>
#include <map>

#include "shapes/convex.h"
#include "shapes/polyhedron_build.h"
#include "shapes/surface_file.h"

namespace shapes {
namespace {

std::string text(double x) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.3g", x);
  return buffer;
}

void check_closed(const Surface& s, const std::string& path) {
  struct Use {
    int forward = 0, backward = 0;
  };
  std::map<std::pair<std::uint32_t, std::uint32_t>, Use> uses;
  for (const auto& face : s.faces)
    for (std::size_t i = 0; i < face.size(); ++i) {
      const std::uint32_t a = face[i], b = face[(i + 1) % face.size()];
      Use& use = uses[{std::min(a, b), std::max(a, b)}];
      ++(a < b ? use.forward : use.backward);
    }
  const auto point = [&](std::uint32_t i) {
    const Vec3d& v = s.vertices[i];
    return "(" + text(v.x) + ", " + text(v.y) + ", " + text(v.z) + ")";
  };
  for (const auto& [edge, use] : uses) {
    if (use.forward == 1 && use.backward == 1) continue;
    const std::string name = path + ": edge " + point(edge.first) + " - " + point(edge.second);
    if (use.forward + use.backward == 2)
      throw Error(name + " is run through twice in one direction; allowed: faces all oriented alike");
    throw Error(name + " has " + std::to_string(use.forward + use.backward) +
                " face(s); allowed: 2 (a closed surface)");
  }
}

// Refused when a face lies inside the hull by more than the tolerance: measured at the corners, edge midpoints and
// centres of its triangles, which, unlike the tilt of a face, does not grow when the face is a sliver.
void check_convex(const Surface& s, const Polyhedron& hull, double tolerance, const std::string& path) {
  const double size = convex::largest_coordinate(s.vertices);
  for (std::size_t f = 0; f < s.faces.size(); ++f) {
    const auto& face = s.faces[f];
    for (std::size_t i = 1; i + 1 < face.size(); ++i) {
      const Vec3d &a = s.vertices[face[0]], &b = s.vertices[face[i]], &c = s.vertices[face[i + 1]];
      for (const Vec3d& x : {a, b, c, 0.5 * (a + b), 0.5 * (b + c), 0.5 * (c + a), (1.0 / 3.0) * (a + b + c)}) {
        double depth = size * 4;
        for (const Polyhedron::Face& h : hull.faces) depth = std::fmin(depth, h.offset - dot(h.normal, x));
        if (depth > tolerance)
          throw Error(path + ": not convex: face " + std::to_string(f) + " lies " + text(depth) +
                      " m inside the convex hull; allowed: " + text(tolerance) + " m");
      }
    }
  }
}

}  // namespace

Polyhedron polyhedron_from_file(const std::string& path, Frame frame) {
  const Surface s = read_surface(path);
  check_closed(s, path);
  std::vector<char> used(s.vertices.size(), 0);
  for (const auto& face : s.faces)
    for (const std::uint32_t v : face) used[v] = 1;
  std::vector<Vec3d> points;
  for (std::size_t i = 0; i < used.size(); ++i)
    if (used[i]) points.push_back(s.vertices[i]);
  Vec3d lower = points[0], upper = points[0];
  for (const Vec3d& p : points)
    for (int i = 0; i < 3; ++i) {
      lower[i] = std::fmin(lower[i], p[i]);
      upper[i] = std::fmax(upper[i], p[i]);
    }
  try {
    const double size = max_abs(upper - lower);
    const double tolerance = std::fmax(1e-9 * size, std::fmin(s.resolution, 1e-5 * size));
    const Polyhedron hull = polyhedron_from_points(points, Frame::as_given);
    check_convex(s, hull, tolerance, path);
    return frame == Frame::as_given ? hull : polyhedron_from_points(points, frame);
  } catch (const Error& e) {
    const std::string what = e.what();
    throw Error(what.starts_with(path) ? what : path + ": " + what);
  }
}

}  // namespace shapes
