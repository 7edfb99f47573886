#include <cmath>
#include <limits>

#include "libcontact/methods/features.h"
#include "libcontact/methods/method.h"
#include "libcontact/methods/point_polyhedron.h"
#include "libcontact/methods/vertex_support.h"
#include "libcontact/scale.h"

namespace contact {

Contact Features::query(const Placed<shapes::Sphere>& a, const Placed<shapes::Polyhedron>& b, const Vec3d& offset,
                        const Options& options, Cache* cache) {
  const double extent = max_abs(offset) + a.radius + b.scale * b.shape->circumradius;
  if (!(a.radius > 0 && b.scale > 0 && extent_in_range(extent) && all_at_least(offset, -extent))) return refused();
  const Scale unit = scale_of(extent);
  const double size = unit.down * extent, radius = unit.down * a.radius;
  const Vec3d centre = -transposed_times(b.rotation, unit.down * offset);  // in the polyhedron's frame
  const double scale = unit.down * b.scale;
  const auto proof = [&](double value, const Vec3d& m) {
    const Vec3d n = -(b.rotation * m);
    if (cache) cache->axis = n;
    return separation_proof(value, size, n, unit.up);
  };
  const double enough = options.overlap_only ? proof_margin(size) : std::numeric_limits<double>::infinity();
  if (options.overlap_only) {
    const FaceHeight top = highest_face(*b.shape, scale, centre);
    if (top.height - radius > enough) return proof(top.height - radius, b.shape->faces[top.index].normal);
    if (Vec3d axis; cached_direction(cache, axis)) {
      const Vec3d m = -transposed_times(b.rotation, axis);
      const double value = dot(m, centre) - radius - scale * highest_vertex(*b.shape, m).value;
      if (value > enough) return proof(value, m);
    }
  }
  const SurfacePoint nearest = surface_point(*b.shape, scale, centre, size);
  if (!(std::abs(nearest.distance) <= 16)) return refused();                 // a rotation that is not finite
  const double gap = nearest.distance - radius, allowance = rounding(size);  // |d| <= √3 max|d_i| is in the allowance
  const Vec3d n = -(b.rotation * nearest.outward);
  const Contact c = smooth_contact(gap, gap - allowance, gap + allowance, n, radius * n, nearest.distance * n, unit.up);
  if (cache) cache->axis = c.status == Status::separated ? n : Vec3d{};
  return c;
}

}  // namespace contact
