// Generated solids.
#include <numbers>

#include "shapes/convex.h"
#include "shapes/polyhedron_build.h"

namespace shapes {
namespace {

void check_length(const char* what, double x) {
  if (!(x > 0) || !std::isfinite(x))
    throw Error(std::string(what) + ": " + std::to_string(x) + "; allowed: finite and > 0 (m)");
}

}  // namespace

Polyhedron make_box(const Vec3d& size) {
  for (int i = 0; i < 3; ++i) check_length("box size", size[i]);
  std::vector<Vec3d> corners;
  for (int i = 0; i < 8; ++i)
    corners.push_back({(i & 1 ? 0.5 : -0.5) * size.x, (i & 2 ? 0.5 : -0.5) * size.y, (i & 4 ? 0.5 : -0.5) * size.z});
  return polyhedron_from_points(corners, Frame::principal);
}

Polyhedron make_prism(int sides, double circumradius, double height) {
  if (sides < 3) throw Error("prism sides: " + std::to_string(sides) + "; allowed: at least 3");
  check_length("prism circumradius", circumradius);
  check_length("prism height", height);
  std::vector<Vec3d> points;
  for (int i = 0; i < sides; ++i) {
    // Angle 2π i/sides = quarter turns plus a rest below π/2: corners on the axes are exact.
    const long long quarters = 4LL * i / sides, rest = 4LL * i % sides;
    const double angle = 0.5 * std::numbers::pi * static_cast<double>(rest) / sides;
    double c = std::cos(angle), s = std::sin(angle);
    for (long long q = 0; q < quarters; ++q) {
      const double turned = -s;
      s = c;
      c = turned;
    }
    for (const double z : {-0.5 * height, 0.5 * height}) points.push_back({circumradius * c, circumradius * s, z});
  }
  return polyhedron_from_points(points, Frame::principal);
}

Polyhedron make_platonic(Platonic solid, double circumradius) {
  check_length("circumradius", circumradius);
  const double golden = std::numbers::phi;
  std::vector<Vec3d> points;
  const auto add_cyclic = [&](double a, double b) {  // (0, ±a, ±b) and its cyclic permutations
    for (const double sa : {-a, a})
      for (const double sb : {-b, b})
        for (const Vec3d& p : {Vec3d{0, sa, sb}, Vec3d{sa, sb, 0}, Vec3d{sb, 0, sa}}) points.push_back(p);
  };
  const auto add_corners = [&](bool alternate) {
    for (int i = 0; i < 8; ++i) {
      const Vec3d corner{i & 1 ? 1.0 : -1.0, i & 2 ? 1.0 : -1.0, i & 4 ? 1.0 : -1.0};
      if (!alternate || corner.x * corner.y * corner.z > 0) points.push_back(corner);
    }
  };
  switch (solid) {
    case Platonic::tetrahedron:
      add_corners(true);
      break;
    case Platonic::cube:
      add_corners(false);
      break;
    case Platonic::octahedron:
      for (const double s : {-1.0, 1.0})
        for (const Vec3d& p : {Vec3d{s, 0, 0}, Vec3d{0, s, 0}, Vec3d{0, 0, s}}) points.push_back(p);
      break;
    case Platonic::dodecahedron:
      add_corners(false);
      add_cyclic(golden - 1, golden);  // 1/φ = φ − 1
      break;
    case Platonic::icosahedron:
      add_cyclic(1, golden);
      break;
  }
  const double unit_size = norm(points[0]);
  for (Vec3d& p : points)
    p = {circumradius * (p.x / unit_size), circumradius * (p.y / unit_size), circumradius * (p.z / unit_size)};
  return polyhedron_from_points(points, Frame::principal);
}

}  // namespace shapes
