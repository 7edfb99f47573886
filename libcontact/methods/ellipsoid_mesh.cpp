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

// The facet meets the ellipsoid: it does so in the space where that is the unit ball.
bool meets(const FacetView& view, const EllipsoidAt& body) {
  const auto to_ball = [&](const Vec3d& x) {
    const Vec3d y = transposed_times(body.axes, x - body.centre);
    return Vec3d{y.x / body.semi_axes.x, y.y / body.semi_axes.y, y.z / body.semi_axes.z};
  };
  bool met = false;
  view.for_each_border(view.facet, [&](std::uint32_t e) {
    const Vec3d from = to_ball(view.edge_start(e)), to = to_ball(view.vertex(view.edge(e).vertex[1]));
    const Vec3d w = point_segment({}, from, to - from).normal;
    met |= dot(w, w) < 1;
  });
  if (met) return true;
  // Then the section with the facet's plane lies all inside the borders, or all outside: its centre tells. There the
  // support point along the normal m, S m/h, is drawn back to the plane.
  const EllipsoidAt::Support s = body.support(view.m);
  if (view.height >= s.height) return false;
  return view.over_region(view.facet, body.centre - (view.height / s.height) * s.arm);
}

}  // namespace

Contact Features::query(const Placed<shapes::Ellipsoid>& a, const Placed<shapes::Mesh>& b, const Vec3d& offset,
                        const Options& options, Cache* cache) {
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
  const double enough = options.overlap_only ? proof_margin(size) : infinity;
  const auto proof = [&](double value, const Vec3d& m) {
    const Vec3d n = -(b.rotation * m);
    if (cache) cache->axis = transposed_times(a.rotation, n);
    return separation_proof(value, size, n, unit.up);
  };
  if (face_gap > enough) return proof(face_gap, view.m);
  const auto separation = [&](const Vec3d& m) {
    return dot(m, body.centre) - body.support(m).height - view.highest(m);
  };
  if (Vec3d axis; options.overlap_only && cached_direction(cache, axis)) {
    const Vec3d m = -transposed_times(b.rotation, a.rotation * axis);
    if (const double value = separation(m); value > enough) return proof(value, m);
  }
  if (cache) cache->axis = {};
  // Deeper than ρ a body can lie beside the facet with its deepest point under it.
  if (face_gap <= -body.least_curvature_radius() && !meets(view, body)) return not_met(view, 0, b.rotation, unit.up);
  const auto answer = [&](double gap, const Vec3d& outward, double allowance) {
    const Vec3d n = normalized(-(b.rotation * outward));  // of the rounding of both factors
    const Vec3d touch = -(b.rotation * body.support(outward).arm);
    return smooth_contact(gap, gap - allowance, gap + allowance, n, touch, touch + gap * n, unit.up);
  };
  if (view.over_region(view.facet, body.centre - down.arm)) return answer(face_gap, view.m, rounding(size));

  // Off the region: an edge that the facet owns, when the best direction lies inside the edge's arc and the ellipsoid's
  // point for it beside the edge; or an end of one, when its best direction leads away from every edge there.
  const auto& facet = b.mesh->facets[b.facet];
  const double allowance = polyhedron_rounding * size;
  const double reach = max_abs(body.semi_axes) + (options.overlap_only ? 2 * allowance : infinity);
  double best = options.overlap_only ? 2 * allowance : infinity;
  Vec3d outward{};
  bool found = false;
  for (std::uint32_t k = 0; k < facet.edge_count; ++k) {
    const std::uint32_t e = b.mesh->facet_edges[facet.first_edge + k];
    const ClosestPoints near = point_segment(body.centre, view.edge_start(e), view.edge_vector(e));
    if (norm(near.normal) > reach) continue;
    const EdgeCone cone = edge_cone(view, e);
    Vec3d arc[2];
    const int maxima = maxima_of_edge(body, cone.point, cone.direction, arc);
    EllipsoidAt::Support support[2];
    double gap[2];
    bool apart = false;
    for (int i = 0; i < maxima; ++i) {
      support[i] = body.support(arc[i]);
      gap[i] = dot(arc[i], body.centre - cone.point) - support[i].height;
      apart |= gap[i] > 0;
    }
    for (int i = 0; i < maxima; ++i) {
      if (apart && gap[i] < 0) continue;  // a line that one direction proves to be apart has no depth along the other
      const double along = dot(body.centre - support[i].arm - cone.point, cone.direction);
      const bool beside = along >= 0 && along <= dot(cone.direction, cone.direction);
      if (gap[i] < best && beside && cone.holds(arc[i]) && cone.faces(arc[i], body.centre))
        best = gap[i], outward = arc[i], found = true;
    }
    for (const std::uint32_t v : view.edge(e).vertex) {
      const Vec3d end = view.vertex(v);
      if (norm(end - body.centre) > reach) continue;
      Vec3d m;
      const double gap = body.point_separation(end, m);
      if (gap < best && dot(m, body.centre - end) > 0 && end_is_owned(view, e, v, m, end + body.least_axis() * m))
        best = gap, outward = m, found = true;
    }
  }
  if (found) return answer(best, outward, allowance);
  // A direction from the facet's nearest point, for the next query to begin with.
  if (options.overlap_only) {
    const Vec3d w = body.centre - view.nearest(body.centre);
    if (const double distance = norm(w); distance > 0) {
      const Vec3d m = w * (1 / distance);
      if (const double value = separation(m); value > enough) return proof(value, m);
    }
  }
  // A ball about the centre bounds what the facet may still be met with.
  return not_met(view, std::fmax(face_gap, view.distance(body.centre) - max_abs(body.semi_axes)) - allowance,
                 b.rotation, unit.up);
}

}  // namespace contact
