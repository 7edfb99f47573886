#include "libcontact/methods/analytic.h"

#include <algorithm>
#include <cmath>

#include "libcontact/methods/method.h"
#include "libcontact/methods/point_ellipsoid.h"
#include "libcontact/scale.h"

namespace contact {

namespace {

double sum_abs(const Vec3d& v) { return std::abs(v.x) + std::abs(v.y) + std::abs(v.z); }
double largest(const Vec3d& v) { return std::max(v.x, std::max(v.y, v.z)); }

// A body above a plane: its deepest point and the plane's distance from there.
Contact above_plane(const Vec3d& normal, double height, const Vec3d& deepest, double allowance, double up = 1) {
  const Vec3d n = -normal;
  return smooth_contact(height, height - allowance, height + allowance, n, deepest, deepest + height * n, up);
}

}  // namespace

Contact Analytic::query(const Placed<shapes::Sphere>& a, const Placed<shapes::Sphere>& b, const Vec3d& offset,
                        const Options&, Cache*) {
  Vec3d n;
  const double distance = length_and_direction(offset, n), reach = a.radius + b.radius;
  const double extent = distance + reach;
  if (!(a.radius > 0 && b.radius > 0 && extent_in_range(extent))) return refused();
  const double gap = distance - reach, allowance = rounding(extent);  // (1)
  return smooth_contact(gap, gap - allowance, gap + allowance, n, a.radius * n, offset - b.radius * n);
}

Contact Analytic::query(const Placed<shapes::Sphere>& a, const Placed<shapes::Plane>& b, const Vec3d& offset,
                        const Options&, Cache*) {
  // Half the allowance for a length that may exceed the extent by √3: it needs no root.
  const double extent = sum_abs(offset) + a.radius, allowance = 0.5 * rounding(extent);
  const double gap = -dot(b.normal, offset) - a.radius;  // (2)
  if (!(a.radius > 0 && extent_in_range(extent) && std::abs(gap) <= 2 * extent)) return refused();
  return above_plane(b.normal, gap, -a.radius * b.normal, allowance);
}

Contact Analytic::query(const Placed<shapes::Ellipsoid>& a, const Placed<shapes::Plane>& b, const Vec3d& offset,
                        const Options&, Cache*) {
  const double extent = sum_abs(offset) + largest(a.semi_axes);
  if (!(extent_in_range(extent) && all_at_least(a.semi_axes, smallest_ratio * extent))) return refused();
  const Scale scale = scale_of(extent);
  const Vec3d axes = a.semi_axes * scale.down, d = offset * scale.down;
  const Vec3d u = scaled(axes, transposed_times(a.rotation, b.normal));
  const double height = norm(u);
  const double gap = -dot(b.normal, d) - height;  // (3)
  if (!(std::abs(gap) <= 8)) return refused();    // extent is below 2 here: a normal or rotation that is not finite
  const Vec3d deepest = a.rotation * scaled(axes, u * (-1 / height));
  return above_plane(b.normal, gap, deepest, rounding(extent * scale.down), scale.up);
}

Contact Analytic::query(const Placed<shapes::Sphere>& a, const Placed<shapes::Ellipsoid>& b, const Vec3d& offset,
                        const Options& options, Cache* cache) {
  const double size = sum_abs(offset) + a.radius + largest(b.semi_axes);
  if (!(a.radius > 0 && extent_in_range(size) && all_at_least(b.semi_axes, smallest_ratio * size))) return refused();
  const Scale scale = scale_of(size);
  const Vec3d axes = b.semi_axes * scale.down, d = offset * scale.down;
  const double radius = a.radius * scale.down;
  const Vec3d y = -transposed_times(b.rotation, d);  // the sphere's centre in the ellipsoid's frame
  const double distance = norm(y), extent = distance + radius + largest(axes);
  if (!(extent <= 8)) return refused();  // size is below 2 here: a rotation that is not finite

  Vec3d n;
  if (options.overlap_only && cached_direction(cache, n)) {
    const double separation = dot(n, d) - norm(scaled(axes, transposed_times(b.rotation, n))) - radius;
    if (separation > proof_margin(extent)) return separation_proof(separation, extent, n, scale.up);
  }
  const EllipsoidFoot nearest = nearest_on_ellipsoid(axes, y);
  n = -(b.rotation * nearest.normal);
  const double gap = dot(nearest.normal, y) - norm(scaled(axes, nearest.normal)) - radius;  // (4)
  // The foot is exact for a point within residual·|y| of y, and the signed distance changes by no more than the point.
  const double allowance = rounding(extent);
  if (cache != nullptr) cache->axis = gap - allowance > 0 ? n : Vec3d{};
  return smooth_contact(gap, gap - allowance, gap + allowance + nearest.residual * distance, n, radius * n,
                        d + b.rotation * nearest.foot, scale.up, nearest.iterations);
}

}  // namespace contact
