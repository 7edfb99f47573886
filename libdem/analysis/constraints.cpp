#include "libdem/analysis/constraints.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace dem::analysis {

namespace {

constexpr double wide = 0.05;   // s of (1)
constexpr double slab = 0.001;  // t of (1)
constexpr double thin = 0.01;   // half width of edges and points where they are laid over each other, of R

using shapes::Kind;

struct Flat {  // across the normal, m
  double u = 0, v = 0;
};
using Outline = std::vector<Flat>;  // convex, counter-clockwise
double turn(const Flat& a, const Flat& b, const Flat& c) {
  return (b.u - a.u) * (c.v - a.v) - (b.v - a.v) * (c.u - a.u);
}

// Convex hull, grown to a box of half width `grow` where it is a point or (nearly) a segment.
Outline hull_of(Outline points, double grow) {
  std::sort(points.begin(), points.end(),
            [](const Flat& a, const Flat& b) { return a.u < b.u || (a.u == b.u && a.v < b.v); });
  Outline hull;
  for (int pass = 0; pass < 2; ++pass) {
    const std::size_t base = hull.size();
    for (const Flat& p : points) {
      while (hull.size() >= base + 2 && turn(hull[hull.size() - 2], hull.back(), p) <= 0) hull.pop_back();
      hull.push_back(p);
    }
    hull.pop_back();
    std::reverse(points.begin(), points.end());
  }
  if (hull.empty()) hull.push_back(points.front());
  std::size_t a = 0, b = 0;  // the ends of its longest line from the first point, and how far it leaves that line
  double length = 0, off = 0;
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const double d = std::hypot(hull[i].u - hull[a].u, hull[i].v - hull[a].v);
    if (d > length) {
      length = d;
      b = i;
    }
  }
  for (const Flat& p : hull)
    if (length > 0) off = std::max(off, std::abs(turn(hull[a], hull[b], p)) / length);
  if (off > grow) return hull;
  const Flat along = length > 0 ? Flat{(hull[b].u - hull[a].u) / length, (hull[b].v - hull[a].v) / length} : Flat{1, 0};
  const Flat p = hull[a], q = hull[b];
  const auto corner = [grow, along](const Flat& x, double i, double j) {
    return Flat{x.u + grow * (i * along.u - j * along.v), x.v + grow * (i * along.v + j * along.u)};
  };
  return {corner(p, -1, -1), corner(q, 1, -1), corner(q, 1, 1), corner(p, -1, 1)};
}

Outline clipped(Outline subject, const Outline& by) {  // Sutherland and Hodgman
  for (std::size_t e = 0; e < by.size() && !subject.empty(); ++e) {
    const Flat &a = by[e], &b = by[(e + 1) % by.size()];
    Outline kept;
    for (std::size_t i = 0; i < subject.size(); ++i) {
      const Flat &p = subject[i], &q = subject[(i + 1) % subject.size()];
      const double dp = turn(a, b, p), dq = turn(a, b, q);
      if (dp >= 0) kept.push_back(p);
      if ((dp > 0 && dq < 0) || (dp < 0 && dq > 0)) {
        const double t = dp / (dp - dq);
        kept.push_back({p.u + t * (q.u - p.u), p.v + t * (q.v - p.v)});
      }
    }
    subject = std::move(kept);
  }
  return subject;
}

enum class Surface { smooth, cornered, pieces };
Surface surface_of(const Snapshot& s, std::size_t i) {
  const ShapeEntry& e = s.shape_of(i);
  if (e.kind == Kind::compound) return Surface::pieces;
  if (e.kind == Kind::polygon) return e.polygon && e.polygon->convex ? Surface::cornered : Surface::pieces;
  const bool flat = e.kind == Kind::polyhedron || e.kind == Kind::rounded_polyhedron;
  return flat && e.polyhedron ? Surface::cornered : Surface::smooth;
}

// What of a body lies outermost along `along`, relative to `origin`, across the frame (t1, t2).
Outline feature(const Snapshot& s, std::size_t i, const Vec3d& centre, const Vec3d& along, double depth,
                const Vec3d& origin, const Vec3d& t1, const Vec3d& t2) {
  const ShapeEntry& e = s.shape_of(i);
  const std::vector<Vec3d>& vertices = e.polygon ? e.polygon->vertices : e.polyhedron->vertices;
  const Vec3d n = transposed_times(rotation_matrix(s.orientation[i]), along);
  const double scale = s.size[i].x;
  double top = -1e300;
  for (const Vec3d& v : vertices) top = std::max(top, scale * dot(n, v));
  Outline list;
  for (const Vec3d& v : vertices)
    if (scale * dot(n, v) >= top - depth) {
      const Vec3d x = centre + rotate(s.orientation[i], v * scale) - origin;
      list.push_back({dot(x, t1), dot(x, t2)});
    }
  return list;
}

struct Counter {
  const Snapshot& s;
  bool from_points = false;

  // The points of one record's patch, relative to its own point.
  std::vector<Vec3d> patch(const SnapshotContact& c, double radius) {
    const Surface a = surface_of(s, c.a), b = c.wall ? Surface::cornered : surface_of(s, c.b);
    if (a == Surface::pieces || b == Surface::pieces) from_points = true;
    if (a != Surface::cornered || b != Surface::cornered) return {Vec3d{}};
    Vec3d t1, t2;
    tangent_frame(c.normal, t1, t2);
    const double depth = std::max(c.overlap, slab * radius), grow = thin * radius;
    Outline over = hull_of(feature(s, c.a, s.position[c.a], c.normal, depth, c.point, t1, t2), grow);
    if (!c.wall) {
      const Vec3d centre = s.position[c.a] + c.branch;
      over = clipped(std::move(over), hull_of(feature(s, c.b, centre, -c.normal, depth, c.point, t1, t2), grow));
    }
    std::vector<Vec3d> points;
    for (const Flat& p : over) points.push_back(t1 * p.u + t2 * p.v);
    if (points.empty()) points.push_back({});
    return points;
  }

  std::uint8_t count(const Pairs& pairs, const Pair& p) {
    using Matrix = Eigen::Matrix<double, 6, 6>;
    const double radius = p.wall ? s.radius[p.a] : std::min(s.radius[p.a], s.radius[p.b]);
    if (p.count == 1 && (surface_of(s, p.a) == Surface::smooth || (!p.wall && surface_of(s, p.b) == Surface::smooth)))
      return 1;
    Matrix m = Matrix::Zero();
    for (std::uint32_t k = p.first; k < p.first + p.count; ++k) {
      const SnapshotContact& c = s.contacts[pairs.records[k]];
      const std::vector<Vec3d> points = patch(c, radius);
      Vec3d middle{};
      if (p.count == 1)
        for (const Vec3d& x : points) middle += x * (1 / static_cast<double>(points.size()));
      const double weight = 1 / (static_cast<double>(points.size()) * p.count);
      for (const Vec3d& x : points) {
        const Vec3d arm = p.count == 1 ? x - middle : x + c.point - p.point;
        const Vec3d moment = cross(arm, c.normal) * (1 / radius);
        Eigen::Matrix<double, 6, 1> w;
        w << c.normal.x, c.normal.y, c.normal.z, moment.x, moment.y, moment.z;
        m += weight * w * w.transpose();
      }
    }
    const Eigen::SelfAdjointEigenSolver<Matrix> solver(m, Eigen::EigenvaluesOnly);
    const auto found = (solver.eigenvalues().array() > wide * wide).count();
    return static_cast<std::uint8_t>(std::max<Eigen::Index>(found, 1));
  }
};

}  // namespace

Constraints constraints_of(const Snapshot& s, const Pairs& pairs) {
  Constraints result;
  Counter counter{s};
  for (const Pair& p : pairs.bodies) result.of_pair.push_back(counter.count(pairs, p));
  for (const Pair& p : pairs.walls) result.of_wall.push_back(counter.count(pairs, p));
  result.from_points = counter.from_points;
  return result;
}

double degrees_of_freedom(const Snapshot& s, std::size_t i) {
  const Kind kind = s.shape_of(i).kind;
  const Vec3d& a = s.size[i];
  if (s.dimension == 2)
    return kind == Kind::disc || kind == Kind::sphere || (kind == Kind::ellipse && a.x == a.y) ? 2 : 3;
  if (kind == Kind::sphere) return 3;
  if (kind != Kind::ellipsoid) return 6;
  const int equal = (a.x == a.y ? 1 : 0) + (a.y == a.z ? 1 : 0) + (a.x == a.z ? 1 : 0);
  return equal == 3 ? 3 : (equal == 1 ? 5 : 6);
}

}  // namespace dem::analysis
