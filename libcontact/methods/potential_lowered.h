// Potential particles over the edges and vertices of meshes and polyhedra: separations, and where they are greatest.
// Inner header.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "libcontact/methods/round_search.h"

namespace contact {

// The body in the frame of a mesh or polyhedron, seen along that one's outward directions m: its lowest point against
// m.
struct Lowered {
  PotentialAt body;
  Vec3d origin;

  struct At {
    double separation;  // of the body over the plane m·x = 0
    Vec3d lowest;
    double excess;
    PotentialAt::At own;
  };
  At at(const Vec3d& m, const At* near = nullptr) const {
    const auto s = body.at(-m, near != nullptr ? &near->own : nullptr);
    return {dot(m, origin) - s.height, origin + s.x, s.excess, s};
  }
  // g < 1 at x.
  bool holds(const Vec3d& x) const { return level(x).g < 1; }
  shapes::PotentialLevel<double> level(const Vec3d& x) const {
    return level_at(*body.shape, (1 / body.scale) * transposed_times(body.rotation, x - origin) - body.shape->centre);
  }
  // A point of the segment start + t e lies inside: the least g on it, by bisection of its slope.
  bool meets_segment(const Vec3d& start, const Vec3d& e) const {
    const Vec3d along = transposed_times(body.rotation, e);
    double low = 0, high = 1;
    for (int i = 0; i < 50; ++i) {
      const double t = i == 0 ? 0.0 : (i == 1 ? 1.0 : 0.5 * (low + high));
      const auto here = level(start + t * e);
      if (here.g < 1) return true;
      (dot(here.half_gradient, along) < 0 ? low : high) = t;
    }
    return false;
  }
};

struct Maximum {
  double gap = std::numeric_limits<double>::infinity();
  Vec3d m{};
  Lowered::At at{};
  bool found = false;
};

// max of φ(m) = m·(c − p) − h(−m) over unit m perpendicular to e: Newton's method on one angle, as in (3).
inline Maximum best_across_edge(const Lowered& body, const Vec3d& p, const Vec3d& e, const Vec3d& start, double size) {
  const Vec3d along = normalized(e);
  const double unit = epsilon * size;
  Maximum a;
  a.m = start;
  a.at = body.at(a.m);
  a.gap = a.at.separation - dot(a.m, p);
  double last = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 60; ++i) {
    const Vec3d t = cross(along, a.m);
    const double r = dot(t, a.at.lowest - p);
    const double k = body.body.radii(a.at.own, -a.m, t, along).k11 + a.gap;
    const double slope = k > 0 ? k : std::abs(k) + 0x1p-10 * std::abs(r);
    double turn = std::clamp(r / slope, -1.0, 1.0);
    if ((std::abs(r) <= 8 * unit || std::abs(r) >= 0.5 * last) && r * turn <= 64 * unit) {
      a.found = k > 0;
      return a;
    }
    last = std::abs(r);
    for (int cut = 0; cut < 24; ++cut, turn *= 0.25) {
      const Vec3d m = normalized(a.m + turn * t);
      const Lowered::At at = body.at(m, &a.at);
      const double gap = at.separation - dot(m, p);
      if (gap >= a.gap - 2 * unit || cut == 23) {
        a.m = m;
        a.at = at;
        a.gap = gap;
        break;
      }
    }
  }
  return a;
}

// max over all unit m for a point p: minus the pair of the point and the body.
inline Maximum best_at_point(const Lowered& body, const Vec3d& p, double size) {
  RoundPair<BallAt, PotentialAt> pair{{0}, body.body, body.origin - p, 4 * size};
  const auto root = pair.climb(pair.cold_start(), false);
  const Vec3d& m = root.point.n;
  return {root.point.f,
          m,
          {dot(m, body.origin) - root.point.b.height, body.origin + root.point.b.x, root.point.b.excess, root.point.b},
          root.converged};
}

}  // namespace contact
