#include <cmath>

#include "libcontact/methods/features.h"
#include "libcontact/methods/method.h"
#include "libcontact/methods/point_polyhedron.h"
#include "libcontact/scale.h"

namespace contact {

Contact Features::query(const Placed<shapes::Sphere>& a, const Placed<shapes::Polyhedron>& b, const Vec3d& offset,
                        const Options&, Cache*) {
  const double extent = max_abs(offset) + a.radius + b.scale * b.shape->circumradius;
  if (!(a.radius > 0 && b.scale > 0 && extent_in_range(extent) && all_at_least(offset, -extent))) return refused();
  const Scale unit = scale_of(extent);
  const double size = unit.down * extent, radius = unit.down * a.radius;
  const Vec3d centre = -transposed_times(b.rotation, unit.down * offset);  // in the polyhedron's frame
  const SurfacePoint nearest = surface_point(*b.shape, unit.down * b.scale, centre, size);
  if (!(std::abs(nearest.distance) <= 16)) return refused();                 // a rotation that is not finite
  const double gap = nearest.distance - radius, allowance = rounding(size);  // |d| <= √3 max|d_i| is in the allowance
  const Vec3d n = -(b.rotation * nearest.outward);
  return smooth_contact(gap, gap - allowance, gap + allowance, n, radius * n, nearest.distance * n, unit.up);
}

}  // namespace contact
