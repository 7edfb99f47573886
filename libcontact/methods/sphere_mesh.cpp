#include <cmath>
#include <limits>

#include "libcontact/methods/facet.h"
#include "libcontact/methods/features.h"
#include "libcontact/methods/method.h"
#include "libcontact/methods/segments.h"

namespace contact {

Contact Features::query(const Placed<shapes::Sphere>& a, const Placed<shapes::Mesh>& b, const Vec3d& offset,
                        const Options& options, Cache*) {
  const double extent = facet_extent(b, offset, a.radius);
  if (!(a.radius > 0 && b.scale > 0 && extent_in_range(extent) && all_at_least(offset, -extent))) return refused();
  const Scale unit = scale_of(extent);
  const double size = unit.down * extent, radius = unit.down * a.radius, allowance = rounding(size);
  const FacetView view(b, -transposed_times(b.rotation, unit.down * offset), unit, size);
  if (!(view.height <= 16)) return refused();  // a rotation that is not finite
  const double face_gap = view.height - radius;
  if (options.overlap_only && face_gap > proof_margin(size))
    return separation_proof(face_gap, size, -(b.rotation * view.m), unit.up);
  const auto answer = [&](double distance, const Vec3d& outward) {
    const double gap = distance - radius;
    const Vec3d n = -(b.rotation * outward);
    return smooth_contact(gap, gap - allowance, gap + allowance, n, radius * n, distance * n, unit.up);
  };
  if (view.over_region(view.facet, view.centre)) return answer(view.height, view.m);

  const auto& facet = b.mesh->facets[b.facet];
  // What is farther than that is apart by more than its interval.
  double nearest = options.overlap_only ? radius + 2 * allowance : std::numeric_limits<double>::infinity();
  Vec3d outward{};
  bool found = false;
  for (std::uint32_t k = 0; k < facet.edge_count; ++k) {
    const std::uint32_t e = b.mesh->facet_edges[facet.first_edge + k];
    const Vec3d from = view.edge_start(e), along = view.edge_vector(e);
    const ClosestPoints c = point_segment(view.centre, from, along);
    const Vec3d w = -c.normal;
    const double distance = norm(w);
    if (!(distance < nearest)) continue;
    const bool at_start = c.b == from, at_end = c.b == from + along;
    const bool own = at_start || at_end ? end_is_owned(view, e, view.edge(e).vertex[at_start ? 0 : 1], w, view.centre)
                                        : edge_cone(view, e).holds(w);
    if (!own) continue;
    nearest = distance;
    outward = distance > 0 ? w * (1 / distance) : view.m;
    found = true;
  }
  if (found) return answer(nearest, outward);
  return not_met(view, view.distance(view.centre) - radius - allowance, b.rotation, unit.up);
}

}  // namespace contact
