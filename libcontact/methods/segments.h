// Closest points of points, segments and convex polygons, in closed form, with the normal taken from the features:
// exact for features that nearly touch, where the difference of the points has no direction.
#pragma once

#include <cmath>

#include "shapes/math/vec.h"

namespace contact {

struct ClosestPoints {
  shapes::Vec3d a, b;
  shapes::Vec3d normal;  // from a to b, not unit; zero when the features touch and no direction is known
};

// The part of w perpendicular to e, orthogonal to e to rounding of itself.
inline shapes::Vec3d perpendicular(const shapes::Vec3d& w, const shapes::Vec3d& e) {
  const double square = dot(e, e);
  if (!(square > 0)) return w;
  const shapes::Vec3d once = w - e * (dot(w, e) / square);
  return once - e * (dot(once, e) / square);
}

// Point x and the segment p + t e, 0 <= t <= 1; the answer's a is x.
inline ClosestPoints point_segment(const shapes::Vec3d& x, const shapes::Vec3d& p, const shapes::Vec3d& e) {
  const shapes::Vec3d w = p - x;
  const double along = -dot(w, e), square = dot(e, e);
  if (!(along > 0)) return {x, p, w};
  if (along >= square) return {x, p + e, w + e};
  return {x, p + e * (along / square), perpendicular(w, e)};
}

// Segments p + s e and q + t f. Interior points of both: the common perpendicular; its foot on f follows from the foot
// on e, so for nearly parallel segments an error along them stays along them.
inline ClosestPoints segment_segment(const shapes::Vec3d& p, const shapes::Vec3d& e, const shapes::Vec3d& q,
                                     const shapes::Vec3d& f) {
  const auto reversed = [](const ClosestPoints& c) { return ClosestPoints{c.b, c.a, -c.normal}; };
  ClosestPoints best = point_segment(p, q, f);
  const auto keep = [&](const ClosestPoints& c) {
    if (dot(c.b - c.a, c.b - c.a) < dot(best.b - best.a, best.b - best.a)) best = c;
  };
  keep(point_segment(p + e, q, f));
  keep(reversed(point_segment(q, p, e)));
  keep(reversed(point_segment(q + f, p, e)));
  const shapes::Vec3d n = cross(e, f), w = q - p;
  const double square = dot(n, n);
  const double s = dot(cross(w, f), n), t = dot(cross(w, e), n);
  if (square > 0 && s > 0 && s < square && t > 0 && t < square) {
    const shapes::Vec3d a = p + e * (s / square);
    const ClosestPoints foot = point_segment(a, q, f);
    const shapes::Vec3d m = perpendicular(n, e);
    if (!(dot(foot.b - a, foot.b - a) > dot(best.b - best.a, best.b - best.a)))
      best = {a, foot.b, dot(m, w) < 0 ? -m : m};
  }
  return best;
}

}  // namespace contact
