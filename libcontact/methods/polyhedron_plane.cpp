#include "libcontact/methods/polyhedron_plane.h"

#include <cmath>

#include "libcontact/methods/method.h"
#include "libcontact/methods/patch.h"
#include "libcontact/methods/vertex_support.h"
#include "libcontact/scale.h"

namespace contact {

Contact PolyhedronPlane::query(const Placed<shapes::Polyhedron>& a, const Placed<shapes::Plane>& b, const Vec3d& offset,
                               const Options& options, Cache*) {
  const double radius = a.scale * a.shape->circumradius;
  const double extent = max_abs(offset) + radius;
  if (!(a.scale > 0 && extent_in_range(extent) && all_at_least(offset, -extent))) return refused();
  const Scale unit = scale_of(extent);
  const double scale = unit.down * a.scale, plane_height = dot(b.normal, unit.down * offset);
  const Vec3d up = transposed_times(a.rotation, b.normal);  // the plane's normal in the body frame
  const Extreme low = lowest_vertex(*a.shape, up);
  const double gap = scale * low.value - plane_height;  // (1)
  if (!(std::abs(gap) <= 16)) return refused();  // extent is below 2 here: a normal or rotation that is not finite
  // Half the allowance, for |d| <= √3 max|d_i|: it needs no root.
  const double allowance = rounding(unit.down * extent);
  const Vec3d tip = scale * a.shape->vertices[low.index];
  Contact c = smooth_contact(gap, gap - allowance, gap + allowance, -b.normal, a.rotation * tip,
                             a.rotation * tip - gap * b.normal);
  if (options.patch && gap < 0) {
    PlaneFrame plane;
    plane.normal = up;
    tangent_frame(up, plane.u, plane.v);
    plane.origin = tip - gap * up;
    const DepthMap map{plane.u,     plane.v, up, scale, -dot(plane.u, plane.origin), -dot(plane.v, plane.origin),
                       plane_height};
    DepthMoments moments;
    for_each_submerged(*a.shape, map, [&](const DepthPoint* polygon, std::size_t n) { moments.add(polygon, n); });
    if (Patch patch; make_patch(moments, plane, patch)) c.patch = rotated(patch, a.rotation);  // (2)
  }
  rescale(c, unit.up);
  return c;
}

}  // namespace contact
