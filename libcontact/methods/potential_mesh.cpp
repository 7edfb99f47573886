// Potential particle against a facet of a mesh, as an ellipsoid is (ellipsoid_mesh.cpp): the facet's plane where the
// deepest point lies over the facet, else an edge that the facet owns, where the best direction lies inside the edge's
// arc and the body's point for it beside the edge, or an end of one.
#include <algorithm>
#include <cmath>
#include <limits>

#include "libcontact/methods/facet.h"
#include "libcontact/methods/polyhedron_pair.h"
#include "libcontact/methods/potential.h"
#include "libcontact/methods/potential_lowered.h"
#include "libcontact/methods/round_search.h"
#include "libcontact/methods/segments.h"
#include "libcontact/scale.h"

namespace contact {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

bool meets(const FacetView& view, const Lowered& body, const Vec3d& lowest) {
  bool met = false;
  view.for_each_border(
      view.facet, [&](std::uint32_t e) { met = met || body.meets_segment(view.edge_start(e), view.edge_vector(e)); });
  if (met) return true;
  // Then the section with the facet's plane lies all inside the borders, or all outside: one point of it tells.
  const Vec3d inner = body.origin + body.body.inner_centre();
  const double below = view.plane - dot(view.m, lowest), above = dot(view.m, inner) - view.plane;
  if (!(below > 0)) return false;
  return view.over_region(view.facet, above > 0 ? lowest + (below / (below + above)) * (inner - lowest) : inner);
}

}  // namespace

Contact Potential::query(const Placed<shapes::PotentialParticle>& a, const Placed<shapes::Mesh>& b, const Vec3d& offset,
                         const Options& options, Cache* cache) {
  const double radius = a.scale * a.shape->circumradius;
  const double extent = facet_extent(b, offset, radius);
  if (!(a.scale > 0 && b.scale > 0 && extent_in_range(extent) && all_at_least(offset, -extent) &&
        a.scale * a.shape->inner_radius >= smallest_ratio * extent))
    return refused();
  const Scale unit = scale_of(extent);
  const double size = unit.down * extent;
  const Lowered body{{a.shape, unit.down * a.scale, transposed(b.rotation) * a.rotation},
                     -transposed_times(b.rotation, unit.down * offset)};
  const FacetView view(b, body.origin, unit, size);
  const auto down = body.at(view.m);
  const double face_gap = down.separation - view.plane, rho = body.body.least_curvature_radius();
  if (!(std::abs(face_gap) <= 16)) return refused();  // a rotation that is not finite
  const double margin = proof_margin(size), enough = options.overlap_only ? margin : infinity;
  const auto proof = [&](double value, const Vec3d& m) {
    const Vec3d n = -(b.rotation * m);
    if (cache != nullptr) cache->axis = transposed_times(a.rotation, n);
    return separation_proof(value, 2 * size, n, unit.up);
  };
  if (face_gap - down.excess > enough) return proof(face_gap - down.excess, view.m);
  const auto separation = [&](const Vec3d& m) {
    const auto at = body.at(m);
    return at.separation - at.excess - view.highest(m);
  };
  if (Vec3d axis; options.overlap_only && cached_direction(cache, axis)) {
    const Vec3d m = -transposed_times(b.rotation, a.rotation * axis);
    if (const double value = separation(m); value > enough && value <= 16) return proof(value, m);
  }
  if (cache != nullptr) cache->axis = {};
  // Deeper than ρ a body can lie beside the facet with its deepest point under it.
  if (face_gap <= -rho && !meets(view, body, down.lowest)) return not_met(view, 0, b.rotation, unit.up);
  const double allowance = polyhedron_rounding * size;
  const auto answer = [&](double gap, const Vec3d& outward, const Lowered::At& at) {
    const Vec3d n = -(b.rotation * outward), touch = b.rotation * (at.lowest - body.origin);
    return smooth_contact(gap, gap - at.excess - allowance, gap + allowance, n, touch, touch + gap * n, unit.up);
  };
  if (view.over_region(view.facet, down.lowest)) return answer(face_gap, view.m, down);

  const auto& facet = b.mesh->facets[b.facet];
  const double reach = body.body.circumradius() + (options.overlap_only ? 2 * allowance : infinity);
  Maximum best;
  best.gap = options.overlap_only ? 2 * allowance : infinity;
  const auto offer = [&](const Maximum& found) {
    best = found;
    best.found = true;
  };
  for (std::uint32_t k = 0; k < facet.edge_count; ++k) {
    const std::uint32_t e = b.mesh->facet_edges[facet.first_edge + k];
    const ClosestPoints near = point_segment(body.origin, view.edge_start(e), view.edge_vector(e));
    if (norm(near.normal) > reach) continue;
    const EdgeCone cone = edge_cone(view, e);
    const Vec3d along = normalized(cone.direction), centre = body.origin + body.body.inner_centre();
    Vec3d start = centre - cone.point;
    start -= dot(start, along) * along;
    start = dot(start, start) > 0 ? normalized(start) : view.m;
    const Maximum across = best_across_edge(body, cone.point, cone.direction, start, size);
    const double position = dot(across.at.lowest - cone.point, cone.direction);
    const bool beside = position >= 0 && position <= dot(cone.direction, cone.direction);
    if (across.found && across.gap < best.gap && beside && cone.holds(across.m) && cone.faces(across.m, centre))
      offer(across);
    for (const std::uint32_t v : view.edge(e).vertex) {
      const Vec3d end = view.vertex(v);
      if (norm(end - body.origin) > reach) continue;
      const Maximum at_end = best_at_point(body, end, size);
      if (at_end.found && at_end.gap < best.gap && dot(at_end.m, centre - end) > 0 &&
          end_is_owned(view, e, v, at_end.m, end + body.body.inner_radius() * at_end.m))
        offer(at_end);
    }
  }
  if (best.found) {
    // The nearest points, or the least separating translation, differ along the outward direction alone.
    const double gap = best.gap;
    Contact c = answer(gap, best.m, best.at);
    if (gap + rho <= 0) c.certified = false;
    return c;
  }
  // A direction from the facet's nearest point, for the next query to begin with.
  if (options.overlap_only) {
    const Vec3d w = body.origin - view.nearest(body.origin);
    if (const double distance = norm(w); distance > 0) {
      const Vec3d m = w * (1 / distance);
      if (const double value = separation(m); value > enough) return proof(value, m);
    }
  }
  return not_met(view,
                 std::fmax(face_gap - down.excess, view.distance(body.origin) - body.body.circumradius()) - allowance,
                 b.rotation, unit.up);
}

}  // namespace contact
