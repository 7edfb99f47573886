#include "libdem/analysis/surface_points.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <stdexcept>

#include "libcontact/methods/point_polyhedron.h"
#include "shapes/polyhedron_build.h"

namespace dem::analysis {

namespace {

using shapes::Compound;
using shapes::Kind;
using shapes::Polyhedron;

std::vector<Vec3d> on_unit_sphere(std::size_t count) {
  const double golden = std::numbers::pi * (3 - std::sqrt(5.0));
  std::vector<Vec3d> points;
  for (std::size_t k = 0; k < count; ++k) {
    const double z = 1 - (2 * static_cast<double>(k) + 1) / static_cast<double>(count);
    const double rho = std::sqrt(1 - z * z), angle = golden * static_cast<double>(k);
    points.push_back({rho * std::cos(angle), rho * std::sin(angle), z});
  }
  return points;
}

using Triangle = std::array<Vec3d, 3>;
double area(const Triangle& t) { return 0.5 * norm(cross(t[1] - t[0], t[2] - t[0])); }

std::vector<Triangle> triangles_of(const Polyhedron& p) {
  std::vector<Triangle> list;
  for (const auto& f : p.faces) {
    const auto corner = [&](std::uint32_t k) { return p.vertices[p.face_vertices[f.first + k]]; };
    for (std::uint32_t k = 1; k + 1 < f.count; ++k) list.push_back({corner(0), corner(k), corner(k + 1)});
  }
  return list;
}

double area_of(const std::vector<Triangle>& triangles) {
  double sum = 0;
  for (const Triangle& t : triangles) sum += area(t);
  return sum;
}

// `count` points, to each triangle its share.
std::vector<Vec3d> spread(const std::vector<Triangle>& triangles, std::size_t count) {
  constexpr double plastic = 1.32471795724474602596, step_u = 1 / plastic, step_v = 1 / (plastic * plastic);
  const double whole = area_of(triangles);
  std::vector<Vec3d> points;
  double before = 0;
  for (const Triangle& t : triangles) {
    before += area(t);
    const auto upto = static_cast<std::size_t>(std::lround(before / whole * static_cast<double>(count)));
    while (points.size() < upto) {
      const double k = static_cast<double>(points.size()) + 0.5;
      double u = k * step_u, v = k * step_v;
      u -= std::floor(u);
      v -= std::floor(v);
      if (u + v > 1) u = 1 - u, v = 1 - v;
      points.push_back(t[0] + u * (t[1] - t[0]) + v * (t[2] - t[0]));
    }
  }
  return points;
}

// `count` of many points, evenly: each the farthest from those before, then three times the one in the middle of what
// is nearest to it.
std::vector<Vec3d> evenly(const std::vector<Vec3d>& many, std::size_t count) {
  if (many.size() <= count) return many;
  std::vector<std::size_t> chosen{0};
  std::vector<double> square(many.size(), std::numeric_limits<double>::infinity());
  std::vector<std::size_t> nearest(many.size());
  const auto add = [&](std::size_t k, const Vec3d& x) {
    for (std::size_t i = 0; i < many.size(); ++i) {
      const Vec3d d = many[i] - x;
      if (dot(d, d) < square[i]) square[i] = dot(d, d), nearest[i] = k;
    }
  };
  add(0, many[0]);
  while (chosen.size() < count) {
    const auto farthest = static_cast<std::size_t>(std::max_element(square.begin(), square.end()) - square.begin());
    add(chosen.size(), many[farthest]);
    chosen.push_back(farthest);
  }
  for (int round = 0; round < 3; ++round) {
    std::vector<Vec3d> sum(count);
    std::vector<double> number(count), best(count, std::numeric_limits<double>::infinity());
    for (std::size_t i = 0; i < many.size(); ++i) sum[nearest[i]] += many[i], ++number[nearest[i]];
    for (std::size_t i = 0; i < many.size(); ++i) {
      const std::size_t k = nearest[i];
      const Vec3d d = many[i] - sum[k] * (1 / number[k]);
      if (dot(d, d) < best[k]) best[k] = dot(d, d), chosen[k] = i;
    }
    square.assign(many.size(), std::numeric_limits<double>::infinity());
    for (std::size_t k = 0; k < count; ++k) add(k, many[chosen[k]]);
  }
  std::vector<Vec3d> points;
  for (const std::size_t i : chosen) points.push_back(many[i]);
  return points;
}

// Triangles of an ellipsoid: an icosahedron's, halved five times, neighbours one after the other.
void halve(const Triangle& t, int times, std::vector<Triangle>& out) {
  if (times == 0) return out.push_back(t);
  const Vec3d a = normalized(t[0] + t[1]), b = normalized(t[1] + t[2]), c = normalized(t[2] + t[0]);
  for (const Triangle& part : {Triangle{t[0], a, c}, {c, a, b}, {a, t[1], b}, {b, t[2], c}})
    halve(part, times - 1, out);
}
std::vector<Vec3d> on_ellipsoid(const Vec3d& axes, std::size_t count) {
  static const std::vector<Triangle> ball = [] {
    std::vector<Triangle> list;
    for (const Triangle& t : triangles_of(shapes::make_platonic(shapes::Platonic::icosahedron, 1)))
      halve({normalized(t[0]), normalized(t[1]), normalized(t[2])}, 4, list);
    return list;
  }();
  std::vector<Triangle> triangles = ball;
  for (Triangle& t : triangles)
    for (Vec3d& v : t) v = scaled(v, axes);
  std::vector<Vec3d> points = spread(triangles, count);
  for (Vec3d& x : points) x = scaled(normalized(Vec3d{x.x / axes.x, x.y / axes.y, x.z / axes.z}), axes);
  return points;
}

std::vector<Vec3d> on_rounded(const ShapeEntry& shape, std::size_t count) {
  std::vector<Vec3d> points = spread(triangles_of(*shape.drawing), count);
  for (Vec3d& x : points) {
    const contact::SurfacePoint at = contact::surface_point(*shape.polyhedron, 1, x, shape.circumradius);
    x += (shape.size.y - at.distance) * at.outward;
  }
  return points;
}

std::vector<Vec3d> on_potential(const ShapeEntry& shape, std::size_t count) {
  const shapes::PotentialParticle& p = *shape.potential;
  std::vector<Vec3d> points = spread(triangles_of(*shape.drawing), count);
  for (Vec3d& x : points) {
    // g grows along the radius and is convex there: Newton's method from outside falls to the surface.
    const Vec3d direction = normalized(x - p.centre);
    double r = std::sqrt(1 / p.sphere_weight);
    for (int k = 0; k < 100; ++k) {
      const auto at = level_at(p, r * direction);
      const double step = (at.g - 1) / (2 * dot(at.half_gradient, direction));
      r -= step;
      if (!(std::fabs(step) > 1e-15 * r)) break;
    }
    x = p.centre + r * direction;
  }
  return points;
}

bool inside(const Compound::Part& part, const Vec3d& x) {
  if (part.kind == Compound::PartKind::polyhedron) return distance(part, x) < 0;
  const Vec3d y = transposed_times(part.rotation, x - part.centre);
  const Vec3d u{y.x / part.size.x, y.y / part.size.y, y.z / part.size.z};
  return dot(u, u) < 1;
}

std::vector<Vec3d> on_part(const Compound::Part& part, std::size_t count) {
  std::vector<Vec3d> points = part.kind == Compound::PartKind::polyhedron ? spread(triangles_of(*part.solid), count)
                                                                          : on_ellipsoid(part.size, count);
  for (Vec3d& x : points) x = part.centre + part.rotation * x;
  return points;
}

std::vector<Vec3d> on_compound(const Compound& body, std::size_t count) {
  std::vector<double> areas;
  double whole = 0;
  for (const Compound::Part& part : body.parts) {
    const double r = std::cbrt(part.size.x * part.size.y * part.size.z);
    areas.push_back(part.solid ? area_of(triangles_of(*part.solid)) : 4 * std::numbers::pi * r * r);
    whole += areas.back();
  }
  std::vector<Vec3d> points;
  for (std::size_t p = 0; p < body.parts.size(); ++p)
    for (const Vec3d& x :
         on_part(body.parts[p], static_cast<std::size_t>(std::lround(areas[p] / whole * static_cast<double>(count))))) {
      bool hidden = false;
      for (std::size_t q = 0; q < body.parts.size() && !hidden; ++q) hidden = q != p && inside(body.parts[q], x);
      if (!hidden) points.push_back(x);
    }
  return points;
}

// In the middles of equal steps along a closed line of corners.
std::vector<Vec3d> along(const std::vector<Vec3d>& corners, std::size_t count) {
  std::vector<double> length{0};
  for (std::size_t k = 0; k < corners.size(); ++k)
    length.push_back(length.back() + norm(corners[(k + 1) % corners.size()] - corners[k]));
  std::vector<Vec3d> points;
  std::size_t side = 0;
  for (std::size_t k = 0; k < count; ++k) {
    const double at = (static_cast<double>(k) + 0.5) / static_cast<double>(count) * length.back();
    while (length[side + 1] < at) ++side;
    const Vec3d &a = corners[side], &b = corners[(side + 1) % corners.size()];
    points.push_back(a + (b - a) * ((at - length[side]) / (length[side + 1] - length[side])));
  }
  return points;
}

std::vector<Vec3d> on_ellipse(double a, double b, std::size_t count) {
  constexpr std::size_t sides = 4096;
  std::vector<Vec3d> corners;
  for (std::size_t k = 0; k < sides; ++k) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(k) / sides;
    corners.push_back({a * std::cos(angle), b * std::sin(angle), 0});
  }
  std::vector<Vec3d> points = along(corners, count);
  for (Vec3d& x : points) x = x * (1 / std::hypot(x.x / a, x.y / b));
  return points;
}

// In the body frame at scale 1.
std::vector<Vec3d> points_on(const ShapeEntry& shape, std::size_t count) {
  const Vec3d& a = shape.size;
  const std::size_t many = 20 * count;
  switch (shape.kind) {
    case Kind::sphere:
      return on_unit_sphere(count);
    case Kind::ellipsoid:
      return evenly(on_ellipsoid(a, many), count);
    case Kind::polyhedron:
      return evenly(spread(triangles_of(*shape.polyhedron), many), count);
    case Kind::rounded_polyhedron:
      return evenly(on_rounded(shape, many), count);
    case Kind::potential_particle:
      return evenly(on_potential(shape, many), count);
    case Kind::compound:
      return evenly(on_compound(*shape.compound, 2 * many), count);
    case Kind::disc:
      return on_ellipse(1, 1, count);
    case Kind::ellipse:
      return on_ellipse(a.x, a.y, count);
    case Kind::polygon:
      return along(shape.polygon->vertices, count);
    default:
      throw std::logic_error("SurfacePoints: a body of the kind of a wall");
  }
}

}  // namespace

SurfacePoints::SurfacePoints(const Snapshot& snapshot, std::size_t count) : s_(snapshot) {
  const double power = s_.dimension - 1;
  double mean = 0;
  for (const double r : s_.radius) mean += std::pow(r, power) / static_cast<double>(s_.count());
  std::map<std::pair<std::uint32_t, int>, std::uint32_t> known;
  for (std::size_t i = 0; i < s_.count(); ++i) {
    const int step = static_cast<int>(std::lround(2 * std::log2(std::pow(s_.radius[i], power) / mean)));
    const auto [at, fresh] = known.try_emplace({s_.shape[i], step}, static_cast<std::uint32_t>(sets_.size()));
    set_.push_back(at->second);
    if (!fresh) continue;
    const double own = static_cast<double>(count) * std::exp2(0.5 * step);
    const ShapeEntry& shape = s_.shape_of(i);
    sets_.push_back(points_on(shape, static_cast<std::size_t>(std::clamp(std::round(own), 8.0, 20000.0))));
    if (!shape.compound && !(shape.polygon && !shape.polygon->convex)) sets_.back().push_back({});
  }
}

std::vector<Vec3d> SurfacePoints::of(std::size_t i) const {
  const ShapeEntry& shape = s_.shape_of(i);
  double scale = s_.size[i].x;
  if (shape.kind == Kind::ellipsoid || shape.kind == Kind::ellipse) scale /= shape.size.x;
  const Mat3d turn = rotation_matrix(s_.orientation[i]);
  std::vector<Vec3d> points = sets_[set_[i]];
  for (Vec3d& x : points) x = s_.position[i] + turn * (scale * x);
  return points;
}

}  // namespace dem::analysis
