#include "libcontact/methods/intersection_midpoint.h"

#include <algorithm>
#include <cmath>

#include "libcontact/methods/ellipse_crossings.h"
#include "libcontact/scale.h"

namespace contact {

namespace {

// The part of the line x + t n that lies in the ellipse; x is inside, to rounding.
struct Interval {
  double low, high;
};
Interval cut_of_line(const Vec3d& axes, const Mat3d& rotation, const Vec3d& x, const Vec3d& n) {
  const Vec3d inverse{1 / axes.x, 1 / axes.y, 1 / axes.z};
  const Vec3d p = scaled(inverse, transposed_times(rotation, x)), q = scaled(inverse, transposed_times(rotation, n));
  const double square = dot(q, q), along = -dot(p, q) / square;
  const Vec3d foot = p + along * q;
  const double half = std::sqrt(std::max(0.0, 1 - dot(foot, foot)) / square);
  return {along - half, along + half};
}

QuadricMeasure measure(const QuadricPair& pair) {
  QuadricMeasure m;
  const UnitBallSpace s = unit_ball_space(pair);
  if (!s.valid) return m;
  const EllipseCrossings crossings = ellipse_crossings(s);
  if (crossings.everywhere || crossings.count != 2 || crossings.tangencies != 0) return m;
  const Vec3d &p = crossings.point[0], &q = crossings.point[1];
  const double length = length_and_direction(Vec3d{q.y - p.y, p.x - q.x, 0}, m.normal);
  if (!(length > 0)) return m;
  if (dot(m.normal, pair.d) < 0) m.normal = -m.normal;
  m.own_normal = m.normal;
  m.own_point = 0.5 * (p + q);
  const Interval in_a = cut_of_line(pair.axes_a, pair.rotation_a, m.own_point, m.normal),
                 in_b = cut_of_line(pair.axes_b, pair.rotation_b, m.own_point - pair.d, m.normal);
  m.own_overlap = std::min(in_a.high, in_b.high) - std::max(in_a.low, in_b.low);  // (1)
  m.found = true;
  return m;
}

}  // namespace

Contact IntersectionMidpoint::query(const Placed<shapes::Ellipse>& a, const Placed<shapes::Ellipse>& b,
                                    const Vec3d& offset, const Options& options, Cache*) {
  return by_quadric_method(a, b, offset, options, measure);
}

}  // namespace contact
