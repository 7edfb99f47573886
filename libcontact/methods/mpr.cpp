#include "libcontact/methods/mpr.h"

#include <cmath>
#include <limits>
#include <utility>

#include "libcontact/methods/convex_view.h"
#include "libcontact/scale.h"

namespace contact {

namespace {

using Corner = ConvexPair::Corner;

constexpr int step_limit = 200;
constexpr double stop_height = 1e-10;  // of K above the portal, over the size

// Of the bodies with their margins; n unit.
Corner support(const ConvexPair& pair, const Vec3d& n) {
  const Corner c = pair.support(n);
  return {c.at + pair.margins() * n, c.on_a + pair.a.margin * n};
}

// Which way the ray from p through the origin passes the edge from u to v: positive on its left, seen from p.
double side(const Vec3d& p, const Corner& u, const Corner& v) { return -dot(cross(u.at, v.at), p); }

Vec3d direction(const Vec3d& v) {
  Vec3d n;
  length_and_direction(v, n);
  return n;
}

ConvexMeasure answer(const ConvexPair& pair, const Vec3d& n, const Vec3d& point, int steps, bool converged) {
  ConvexMeasure m;
  m.found = true;
  m.converged = converged;
  m.iterations = steps;
  m.normal = n;
  m.upper = std::numeric_limits<double>::infinity();
  m.overlap = dot(n, support(pair, n).at);  // (3)
  m.point = point;
  return m;
}

// The point midway between those of A and B on the ray, from where it passes the portal.
Vec3d on_ray(const Vec3d& p, const Corner& u, const Corner& v, const Corner& w) {
  const double a = side(p, v, w), b = side(p, w, u), c = side(p, u, v), sum = a + b + c;
  if (!(sum > 0)) return 0.5 * (u.on_a + (u.on_a - u.at));
  const Vec3d on_a = (1 / sum) * (a * u.on_a + b * v.on_a + c * w.on_a);
  const Vec3d at = (1 / sum) * (a * u.at + b * v.at + c * w.at);
  return on_a - 0.5 * at;
}

ConvexMeasure measure(const ConvexPair& pair) {
  const Vec3d p = pair.inside();
  Vec3d n;
  if (!(length_and_direction(-p, n) > 0x1p-40 * pair.size)) return {};  // no ray
  int steps = 0;
  Corner v1 = support(pair, n);
  const auto early = [&] { return answer(pair, n, v1.on_a - 0.5 * v1.at, steps, true); };
  if (!(dot(v1.at, n) > 0)) return early();  // (1): apart
  const Vec3d across = cross(v1.at, p);
  if (!(norm(across) > 0x1p-44 * pair.size * norm(p))) return early();  // K's farthest point lies on the ray
  const Vec3d along = n;
  n = direction(across);
  Corner v2 = support(pair, n);
  if (!(dot(v2.at, n) > 0)) return early();
  n = direction(cross(v1.at - p, v2.at - p));
  if (dot(n, p) > 0) {
    std::swap(v1, v2);
    n = -n;
  }
  Corner v3;
  for (;; ++steps) {
    if (steps > step_limit) return answer(pair, along, v1.on_a - 0.5 * v1.at, steps, false);
    v3 = support(pair, n);
    if (!(dot(v3.at, n) > 0)) return early();
    if (side(p, v1, v3) > 0) {
      v2 = v3;
      n = direction(cross(v1.at - p, v3.at - p));
    } else if (side(p, v3, v2) > 0) {
      v1 = v3;
      n = direction(cross(v3.at - p, v2.at - p));
    } else {
      break;
    }
  }
  for (;; ++steps) {
    const Vec3d normal = cross(v2.at - v1.at, v3.at - v1.at);
    n = direction(dot(normal, v1.at - p) < 0 ? -normal : normal);
    if (steps > step_limit) return answer(pair, n, on_ray(p, v1, v2, v3), steps, false);
    const Corner v4 = support(pair, n);
    if (!(dot(v4.at, n) > 0) || dot(v4.at - v1.at, n) <= stop_height * pair.size)  // (1), (2)
      return answer(pair, n, on_ray(p, v1, v2, v3), steps, true);
    // Of the three triangles at v4 the one that the ray passes through.
    const Vec3d c = cross(v4.at, p);
    if (dot(v1.at, c) > 0)
      (dot(v2.at, c) > 0 ? v1 : v3) = v4;
    else
      (dot(v3.at, c) > 0 ? v2 : v1) = v4;
  }
}

}  // namespace

Contact Mpr::query(const Placed<shapes::Sphere>& a, const Placed<shapes::Ellipsoid>& b, const Vec3d& offset,
                   const Options&, Cache*) {
  return by_convex_method(a, b, offset, measure);
}
Contact Mpr::query(const Placed<shapes::Sphere>& a, const Placed<shapes::Polyhedron>& b, const Vec3d& offset,
                   const Options&, Cache*) {
  return by_convex_method(a, b, offset, measure);
}
Contact Mpr::query(const Placed<shapes::Ellipsoid>& a, const Placed<shapes::Ellipsoid>& b, const Vec3d& offset,
                   const Options&, Cache*) {
  return by_convex_method(a, b, offset, measure);
}
Contact Mpr::query(const Placed<shapes::Ellipsoid>& a, const Placed<shapes::Polyhedron>& b, const Vec3d& offset,
                   const Options&, Cache*) {
  return by_convex_method(a, b, offset, measure);
}
Contact Mpr::query(const Placed<shapes::Polyhedron>& a, const Placed<shapes::Polyhedron>& b, const Vec3d& offset,
                   const Options&, Cache*) {
  return by_convex_method(a, b, offset, measure);
}

}  // namespace contact
