#include "libcontact/methods/geometric_potential.h"

#include <algorithm>
#include <cmath>

#include "libcontact/methods/point_ellipsoid.h"
#include "libcontact/methods/unit_ball_space.h"
#include "libcontact/scale.h"

namespace contact {

namespace {

// u on the unit sphere with |diag(s) u + p| least: the foot of −p on the ellipsoid of semi-axes s is diag(s) u.
Vec3d nearest_parameter(const Vec3d& s, const Vec3d& p, int& iterations) {
  const double down = scale_of(std::max(max_abs(s), max_abs(p))).down;
  const Vec3d axes = s * down;
  const EllipsoidFoot foot = nearest_on_ellipsoid(axes, p * -down);
  iterations += foot.iterations;
  return {foot.foot.x / axes.x, foot.foot.y / axes.y, foot.foot.z / axes.z};
}

QuadricMeasure measure(const QuadricPair& pair) {
  QuadricMeasure m;
  const UnitBallSpace s = unit_ball_space(pair);
  if (!s.valid) return m;
  const Vec3d inverse{1 / s.sigma.x, 1 / s.sigma.y, 1 / s.sigma.z};
  const Vec3d deep_in_a = s.e + scaled(s.sigma, nearest_parameter(s.sigma, s.e, m.iterations));  // (1)
  const Vec3d deep_in_b = nearest_parameter(inverse, -scaled(inverse, s.e), m.iterations);
  const Vec3d xb = s.to_world * deep_in_a, xa = s.to_world * deep_in_b;
  m.own_point = 0.5 * (xa + xb);
  const Vec3d na = quadric_normal(pair.axes_a, pair.rotation_a, m.own_point),
              nb = quadric_normal(pair.axes_b, pair.rotation_b, m.own_point - pair.d);
  if (!(length_and_direction(na - nb, m.normal) > 0x1p-20)) return m;  // (3)
  const bool overlapping = dot(deep_in_a, deep_in_a) < 1;
  const double length = length_and_direction(overlapping ? xa - xb : xb - xa, m.own_normal);
  m.own_overlap = overlapping ? length : -length;                      // (2)
  if (!(length > 8 * epsilon * pair.extent)) m.own_normal = m.normal;  // the two points are one
  m.found = true;
  return m;
}

}  // namespace

Contact GeometricPotential::query(const Placed<shapes::Ellipsoid>& a, const Placed<shapes::Ellipsoid>& b,
                                  const Vec3d& offset, const Options& options, Cache*) {
  return by_quadric_method(a, b, offset, options, measure);
}

Contact GeometricPotential::query(const Placed<shapes::Ellipse>& a, const Placed<shapes::Ellipse>& b,
                                  const Vec3d& offset, const Options& options, Cache*) {
  return by_quadric_method(a, b, offset, options, measure);
}

}  // namespace contact
