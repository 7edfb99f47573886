// Rounded polyhedron against a facet of a mesh.
//
// The cores apart: the nearest points of core and facet settle it. Where the core's lowest vertex stands over the
// facet, or a face or an edge of it as low hangs over the border, the facet's plane answers; else an edge that the
// facet owns, where the direction between the nearest points is in the edge's cone, or an end of it (facet.h). The core
// through the facet: its own answer, less the radius; there the gap bounds the way out along that normal, of which the
// last radius may lie with a neighbour. Cost: 0.1 us to a proof of separation; over a face the core's support; else all
// edges of the core against those around the facet that are in reach.
#include <algorithm>
#include <cmath>
#include <limits>

#include "libcontact/methods/facet.h"
#include "libcontact/methods/features.h"
#include "libcontact/methods/method.h"
#include "libcontact/methods/placed_solid.h"
#include "libcontact/methods/point_polyhedron.h"
#include "libcontact/methods/polyhedron_pair.h"
#include "libcontact/methods/rounded.h"
#include "libcontact/methods/rounded_parts.h"
#include "libcontact/methods/segments.h"

namespace contact {
namespace {

// The core's point that is nearest to an edge of the mesh.
struct Nearest {
  double distance = std::numeric_limits<double>::infinity();
  Vec3d on_core{}, on_mesh{};
  Vec3d outward{};  // from the mesh to the core, not unit
};

// Distances of a core to edges of a mesh that do not pass through it. A pair of edges, or an end of the mesh's edge
// over a face of the core: vertices of the core are ends of its edges.
class CoreDistance {
 public:
  CoreDistance(const PlacedSolid& solid, double size) : solid_(solid), size_(size) {}

  // An edge farther than `reach` may be left out: its distance is then infinite.
  Nearest to(const FacetView& view, std::uint32_t edge, double reach) const {
    const Vec3d start = view.edge_start(edge), along = view.edge_vector(edge);
    Nearest best;
    const double circumradius = solid_.scale * solid_.shape.circumradius;
    const Vec3d from_centre = point_segment(solid_.centre, start, along).normal;
    const double limit = reach + circumradius;
    if (limit < 4 * size_ && dot(from_centre, from_centre) > limit * limit) return best;
    double square = std::numeric_limits<double>::infinity();
    for (const auto& e : solid_.shape.edges) {
      const Vec3d p = solid_.vertex(e.vertex[0]);
      const ClosestPoints c = segment_segment(p, solid_.vertex(e.vertex[1]) - p, start, along);
      const double s = dot(c.b - c.a, c.b - c.a);
      if (!(s < square)) continue;
      square = s;
      best = {std::sqrt(s), c.a, c.b, -c.normal};
    }
    for (const Vec3d& end : {start, start + along}) {
      const Vec3d x = transposed_times(solid_.rotation, end - solid_.centre);
      const SurfacePoint s = surface_point(solid_.shape, solid_.scale, x, size_);
      if (s.feature != SurfacePoint::Feature::face || !(s.distance < best.distance)) continue;
      const Vec3d outward = -(solid_.rotation * s.outward);
      best = {std::max(s.distance, 0.0), end + outward * s.distance, end, outward};
    }
    return best;
  }

 private:
  const PlacedSolid& solid_;
  double size_;
};

bool passes_through(const PlacedSolid& solid, const FacetView& view, const Vec3d& tip) {
  bool crossed = false;
  view.for_each_border(view.facet, [&](std::uint32_t i) {
    double from, to;
    crossed = crossed || part_inside(solid, view.edge_start(i), view.edge_vector(i), from, to);
  });
  return crossed || view.over_region(view.facet, section_point(solid, view, tip));
}

// The normal of a facet beside the edge, or beside its end at `vertex`, separates the core as far as the nearest points
// are apart: that facet answers, for a face of the core that is parallel to it.
bool left_to_a_facet(const PlacedSolid& solid, const FacetView& view, std::uint32_t edge, const std::uint32_t* vertex,
                     double distance, double margin) {
  const auto faces = [&](std::uint32_t e) {
    bool found = false;
    for (const std::uint32_t f : view.edge(e).facet) {
      if (f == shapes::Mesh::none) continue;
      const auto& facet = view.mesh->facets[f];
      const double plane = view.scale * facet.offset;
      found = found || solid.lowest(facet.normal).value - plane >= distance - margin ||
              solid.lowest(-facet.normal).value + plane >= distance - margin;
    }
    return found;
  };
  if (vertex == nullptr) return faces(edge);
  const std::span<const std::uint32_t> around = edges_at(view, *vertex);
  return std::any_of(around.begin(), around.end(), faces);
}

}  // namespace

Contact Rounded::query(const Placed<shapes::RoundedPolyhedron>& a, const Placed<shapes::Mesh>& b, const Vec3d& offset,
                       const Options& options, Cache* cache) {
  const double circumradius = a.core.scale * a.core.shape->circumradius;
  const double extent = facet_extent(b, offset, circumradius + a.radius);
  if (!(a.core.scale > 0 && a.radius > 0 && a.radius >= smallest_ratio * extent && b.scale > 0 &&
        extent_in_range(extent) && all_at_least(offset, -extent)))
    return refused();
  const Scale unit = scale_of(extent);
  const double size = unit.down * extent, radius = unit.down * a.radius, allowance = polyhedron_rounding * size;
  const PlacedSolid solid{*a.core.shape, unit.down * a.core.scale, transposed(b.rotation) * a.core.rotation,
                          -transposed_times(b.rotation, unit.down * offset)};
  const FacetView view(b, solid.centre, unit, size);
  if (!(view.height <= 16)) return refused();  // a rotation that is not finite
  const Extreme low = solid.lowest(view.m);
  const double height = low.value - view.plane, margin = proof_margin(size);
  if (!(std::abs(height) <= 16)) return refused();
  const auto proof = [&](double value, const Vec3d& m) {
    const Vec3d n = -(b.rotation * m);
    if (cache) cache->axis = transposed_times(a.core.rotation, n);
    return separation_proof(value, size, n, unit.up);
  };
  if (options.overlap_only) {
    if (height - radius > margin) return proof(height - radius, view.m);
    if (Vec3d axis; cached_direction(cache, axis)) {
      const Vec3d m = -transposed_times(b.rotation, a.core.rotation * axis);
      if (const double value = solid.lowest(m).value - view.highest(m) - radius; value > margin) return proof(value, m);
    }
  }
  if (cache) cache->axis = {};

  Contact c;
  const auto answer = [&](double distance, const Vec3d& outward, const Vec3d& on_mesh) {
    const double gap = distance - radius;
    const Vec3d n = -(b.rotation * outward), touch = b.rotation * (on_mesh - solid.centre);
    c = smooth_contact(gap, gap - allowance, gap + allowance, n, touch - gap * n, touch, unit.up);
  };
  const Vec3d tip = solid.vertex(low.index);
  if (height <= 0 && passes_through(solid, view, tip)) {
    c = Features::query(a.core, b, offset, {.overlap_only = false, .patch = false}, nullptr);
    if (c.status == Status::refused || std::isinf(c.gap_upper)) return c;  // another facet's
    take_off(c, a.radius, 4 * epsilon * extent);
    c.point_a += a.radius * c.normal;
    c.patch = {0.5 * (c.point_a + c.point_b), {}};
    c.method_point = c.patch.centre;
  } else if (height > 0 && view.over_region(view.facet, tip)) {
    answer(height, view.m, tip - height * view.m);
  } else {
    const CoreDistance core(solid, size);
    double nearest = std::numeric_limits<double>::infinity();
    double reach = options.overlap_only ? radius + margin : nearest;
    Nearest border;
    view.for_each_border(view.facet, [&](std::uint32_t e) {
      if (const Nearest n = core.to(view, e, std::min(reach, border.distance)); n.distance < border.distance)
        border = n;
    });
    if (height > 0 && border.distance <= height + margin) {  // a face or an edge that hangs over the border
      answer(height, view.m, border.on_mesh);
    } else {
      Vec3d outward{}, on_mesh{};
      const auto& facet = b.mesh->facets[b.facet];
      for (std::uint32_t k = 0; k < facet.edge_count; ++k) {
        const std::uint32_t e = b.mesh->facet_edges[facet.first_edge + k];
        const Nearest n = core.to(view, e, reach);
        if (!(n.distance < nearest) || n.distance > reach) continue;
        const Vec3d from = view.edge_start(e);
        const bool at_start = n.on_mesh == from, at_end = n.on_mesh == from + view.edge_vector(e);
        const std::uint32_t vertex = view.edge(e).vertex[at_start ? 0 : 1];
        const bool own = at_start || at_end ? end_is_owned(view, e, vertex, n.outward, n.on_core)
                                            : edge_cone(view, e).holds(n.outward);
        if (!own || left_to_a_facet(solid, view, e, at_start || at_end ? &vertex : nullptr, n.distance, margin))
          continue;
        nearest = n.distance;
        outward = dot(n.outward, n.outward) > 0 ? normalized(n.outward) : view.m;
        on_mesh = n.on_mesh;
      }
      if (!(nearest <= reach) || std::isinf(nearest))
        return not_met(view, std::max(height, std::min(border.distance, reach)) - radius - allowance, b.rotation,
                       unit.up);
      answer(nearest, outward, on_mesh);
    }
  }
  if (c.status == Status::separated && cache) cache->axis = transposed_times(a.core.rotation, c.normal);
  // Sunk so deep that the core's centre would pass the plane, the point midway has to do.
  if (options.patch && c.gap < 0) {
    const Contact pushed =
        Features::query(a.core, b, offset - a.radius * c.normal, {.overlap_only = false, .patch = true}, nullptr);
    if (pushed.status == Status::overlapping && dot(pushed.normal, c.normal) > same_direction) {
      c.patch = pushed.patch;
      c.patch.centre += a.radius * c.normal;
    }
  }
  return c;
}

}  // namespace contact
