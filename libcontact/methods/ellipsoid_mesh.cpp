#include <cmath>
#include <limits>

#include "libcontact/methods/ellipsoid_support.h"
#include "libcontact/methods/facet.h"
#include "libcontact/methods/features.h"
#include "libcontact/methods/method.h"
#include "libcontact/methods/polyhedron_pair.h"
#include "libcontact/methods/segments.h"

namespace contact {
namespace {
constexpr double infinity = std::numeric_limits<double>::infinity();
}

Contact Features::query(const Placed<shapes::Ellipsoid>& a, const Placed<shapes::Mesh>& b, const Vec3d& offset,
                        const Options& options, Cache*) {
  const double extent = facet_extent(b, offset, max_abs(a.semi_axes));
  if (!(b.scale > 0 && extent_in_range(extent) && all_at_least(offset, -extent) &&
        all_at_least(a.semi_axes, smallest_ratio * extent)))
    return refused();
  const Scale unit = scale_of(extent);
  const double size = unit.down * extent;
  const EllipsoidAt body{unit.down * a.semi_axes, -transposed_times(b.rotation, unit.down * offset),
                         transposed(b.rotation) * a.rotation};
  const FacetView view(b, body.centre, unit, size);
  const EllipsoidAt::Support down = body.support(view.m);
  const double face_gap = view.height - down.height;
  if (!(std::abs(face_gap) <= 16)) return refused();  // a rotation that is not finite
  if (options.overlap_only && face_gap > proof_margin(size))
    return separation_proof(face_gap, size, -(b.rotation * view.m), unit.up);
  const auto answer = [&](double gap, const Vec3d& outward, double allowance, int iterations) {
    const Vec3d n = -(b.rotation * outward), touch = -(b.rotation * body.support(outward).arm);
    return smooth_contact(gap, gap - allowance, gap + allowance, n, touch, touch + gap * n, unit.up, iterations);
  };
  if (view.over_region(view.facet, body.centre - down.arm)) return answer(face_gap, view.m, rounding(size), 0);

  // Off the region: an edge that the facet owns, when the best direction lies inside the edge's arc and the ellipsoid's
  // point for it beside the edge; or an end of one, when its best direction leads away from every edge there.
  const auto& facet = b.mesh->facets[b.facet];
  const double allowance = polyhedron_rounding * size;
  const double reach = max_abs(body.semi_axes) + (options.overlap_only ? allowance : infinity);
  double best = options.overlap_only ? allowance : infinity;
  Vec3d outward{};
  bool found = false;
  int iterations = 0;
  for (std::uint32_t k = 0; k < facet.edge_count; ++k) {
    const std::uint32_t e = b.mesh->facet_edges[facet.first_edge + k];
    const ClosestPoints near = point_segment(body.centre, view.edge_start(e), view.edge_vector(e));
    if (norm(near.normal) > reach) continue;
    const EdgeCone cone = edge_cone(view, e);
    const ArcMaximum arc = maximise_on_arc(body, cone.point, cone.direction, cone.first, cone.last, cone.middle());
    const double along = dot(body.deepest(arc.m) - cone.point, cone.direction);
    const bool beside = along >= 0 && along <= dot(cone.direction, cone.direction);
    const bool at_facet = arc.m == cone.first || arc.m == cone.last;  // then the facet beside the edge answers
    if (arc.value < best && beside && !at_facet && cone.faces(arc.m, body.centre)) {
      best = arc.value, outward = arc.m, iterations = arc.iterations, found = true;
    }
    for (const std::uint32_t v : view.edge(e).vertex) {
      const Vec3d end = view.vertex(v);
      if (norm(end - body.centre) > reach) continue;
      Vec3d m;
      const double gap = body.point_separation(end, m);
      if (gap < best && dot(m, body.centre - end) > 0 && end_is_owned(view, e, v, m, end + body.least_axis() * m))
        best = gap, outward = m, iterations = 0, found = true;
    }
  }
  if (found) return answer(best, outward, allowance, iterations);
  // A ball about the centre bounds what the facet may still be met with.
  return not_met(view, std::fmax(face_gap, view.distance(body.centre) - max_abs(body.semi_axes)) - allowance,
                 b.rotation, unit.up);
}

}  // namespace contact
