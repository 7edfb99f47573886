#include "libcontact/overlap_depth.h"

#include <algorithm>
#include <cmath>

#include "libcontact/methods/facet_depth.h"
#include "libcontact/methods/method.h"
#include "libcontact/methods/overlap_moments.h"
#include "libcontact/methods/patch.h"
#include "libcontact/methods/planar_slope.h"
#include "libcontact/methods/polygon_measure.h"
#include "libcontact/methods/polyhedron_measure.h"
#include "libcontact/scale.h"

namespace contact {

namespace {

using shapes::Kind;

double smaller(const Body& a, const Body& b) { return std::min(circumradius(a), circumradius(b)); }

// The face at a vertex that looks most along a direction, and the edge that falls least along it.
struct Facing {
  double along = -2, rise = -HUGE_VAL;
  std::uint32_t face = 0, edge = 0;
};
Facing most_facing(const shapes::Polyhedron& p, std::uint32_t vertex, const Vec3d& direction) {
  Facing best;
  for (std::uint32_t k = p.first_spoke[vertex]; k < p.first_spoke[vertex + 1]; ++k) {
    const auto& spoke = p.spokes[k];
    if (const double along = dot(p.faces[spoke.face].normal, direction); along > best.along)
      best.along = along, best.face = spoke.face;
    if (const double rise = dot(spoke.to, direction); rise > best.rise) best.rise = rise, best.edge = spoke.edge;
  }
  return best;
}

bool polyhedra(const Body& a, const Body& b, const Vec3d& offset, const Vec3d& towards, OverlapDepth& out) {
  double up = 1;
  const auto [pair, pair_size] =
      placed_polyhedra(contact::placed<shapes::Polyhedron>(a), contact::placed<shapes::Polyhedron>(b), offset, up);
  if (!(pair_size > 0)) return false;
  const Vec3d n = transposed_times(a.rotation, towards), m = transposed_times(pair.other_to_self, n);
  Extreme ends[2];
  kernels::search_kernels().lowest_two(points_of(*pair.self), -n, points_of(*pair.other), m, ends);
  const double depth = -(pair.self_scale * ends[0].value + (pair.other_scale * ends[1].value + dot(n, pair.offset)));
  if (!(depth > 0)) return false;
  const Facing of_a = most_facing(*pair.self, ends[0].index, n), of_b = most_facing(*pair.other, ends[1].index, -m);
  DifferenceFacet facet{DifferenceFacet::edges, of_a.edge, of_b.edge};
  if (std::max(of_a.along, of_b.along) >= 1 - 0x1p-40)
    facet = of_a.along > of_b.along ? DifferenceFacet{DifferenceFacet::face_of_a, of_a.face, ends[1].index}
                                    : DifferenceFacet{DifferenceFacet::face_of_b, ends[0].index, of_b.face};
  FacetAxis axis{n, -depth, 0, {}};
  if (facet.kind == DifferenceFacet::face_of_a)
    axis.reach = foot_reach(pair, facet.a, pair.other_vertex(facet.b));
  else if (facet.kind == DifferenceFacet::face_of_b)
    axis.reach = foot_reach(pair.swapped(), facet.b, pair.swapped().other_vertex(facet.a));
  Patch patch;
  if (!facet_depth(pair, facet, axis, {a.rotation, b.rotation, offset * (1 / up), smaller(a, b) / up}, out, patch))
    return false;
  rescale(out, up);
  return true;
}

// Of a rounded one its core counts, on the wall raised by the radius: as deep there as its surface is here.
bool polyhedron_plane(const Body& a, const Vec3d& wall, double above, OverlapDepth& out) {
  const double size = circumradius(a), height = a.kind == Kind::polyhedron ? above : above - a.size.y;
  if (!extent_in_range(size)) return false;
  const Scale unit = scale_of(size);
  const Vec3d n = transposed_times(a.rotation, wall);
  const auto& shape = *static_cast<const shapes::Polyhedron*>(a.geometry);
  const OverlapBody& body = overlap_body(shape, a.size.x * unit.down, {n, -height * unit.down});
  DepthSlope slope;
  if (!depth_slope(body, size * unit.down, slope)) return false;
  out = rotated(line_of_action(slope), a.rotation);
  rescale(out, unit.up);
  return true;
}

bool polygons(const Body& a, const Body& b, const Vec3d& offset, OverlapDepth& out) {
  double up = 1;
  const PlacedPolygons pair =
      placed_polygons(contact::placed<shapes::Polygon>(a), contact::placed<shapes::Polygon>(b), offset, up);
  if (!(pair.size > 0) || !pair.a.convex || !pair.b.convex) return false;
  if (!outlines_depth(Loop(pair.a, pair.place_a), Loop(pair.b, pair.place_b), smaller(a, b) / up, out)) return false;
  rescale(out, up);
  return true;
}

bool polygon_line(const Body& a, const Vec3d& wall, double height, OverlapDepth& out) {
  const auto& p = *static_cast<const shapes::Polygon*>(a.geometry);
  const double size = circumradius(a);
  if (!extent_in_range(size) || !p.convex) return false;
  const Scale unit = scale_of(size);
  const Placement place = placement(contact::placed<shapes::Polygon>(a), unit.down, {});
  Corners whole, below;
  for (const Vec3d& v : p.vertices) whole.push_back({place.point(v), PlanarOverlap::of_a});
  cut(whole, wall, -height * unit.down, PlanarOverlap::of_b, below);
  if (!outline_depth(below, size * unit.down, out)) return false;
  rescale(out, unit.up);
  return true;
}

}  // namespace

bool has_overlap_depth(Kind a, Kind b) {
  if (a == Kind::rounded_polyhedron) return b == Kind::plane;
  if (a == Kind::polyhedron) return b == Kind::polyhedron || b == Kind::plane;
  return a == Kind::polygon && (b == Kind::polygon || b == Kind::line);
}

bool overlap_depth(const Body& a, const Body& b, const Vec3d& offset, const Vec3d& towards, OverlapDepth& out) {
  if (!has_overlap_depth(a.kind, b.kind)) return false;
  if (a.kind == b.kind && seen_from_b(offset)) {  // the same bits in both orders
    if (!overlap_depth(b, a, -offset, -towards, out)) return false;
    exchange(out, offset);
    return true;
  }
  if (a.kind == b.kind)
    return a.kind == Kind::polyhedron ? polyhedra(a, b, offset, towards, out) : polygons(a, b, offset, out);
  const Vec3d wall = b.rotation.column(b.kind == Kind::plane ? 2 : 1);
  const double height = -dot(wall, offset);  // of a's origin over the wall
  return b.kind == Kind::plane ? polyhedron_plane(a, wall, height, out) : polygon_line(a, wall, height, out);
}

}  // namespace contact
