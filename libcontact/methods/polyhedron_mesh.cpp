#include <algorithm>
#include <cmath>
#include <limits>

#include "libcontact/methods/facet.h"
#include "libcontact/methods/features.h"
#include "libcontact/methods/method.h"
#include "libcontact/methods/patch.h"
#include "libcontact/methods/polyhedron_pair.h"

namespace contact {
namespace {

// The polyhedron in the mesh's body frame, lengths in units.
struct PlacedSolid {
  const shapes::Polyhedron& shape;
  double scale;
  Mat3d rotation;
  Vec3d centre;

  Extreme lowest(const Vec3d& m) const {
    const Extreme e = lowest_vertex(shape, transposed_times(rotation, m));
    return {scale * e.value + dot(m, centre), e.index};
  }
  Vec3d vertex(std::uint32_t i) const { return rotation * (scale * shape.vertices[i]) + centre; }
};

// Moments of what lies under the facet's region, triangle by triangle: they add, so the triangulation does not show.
void add_over_region(const FacetView& view, const PlaneFrame& plane, const DepthPoint* polygon, std::size_t count,
                     DepthMoments& moments) {
  double low_u = polygon[0].u, high_u = low_u, low_v = polygon[0].v, high_v = low_v;
  for (std::size_t i = 1; i < count; ++i) {
    low_u = std::min(low_u, polygon[i].u), high_u = std::max(high_u, polygon[i].u);
    low_v = std::min(low_v, polygon[i].v), high_v = std::max(high_v, polygon[i].v);
  }
  const auto& facet = view.mesh->facets[view.facet];
  for (std::uint32_t k = 0; k < facet.triangle_count; ++k) {
    const std::uint32_t* corner = &view.mesh->triangles[3 * view.mesh->facet_triangles[facet.first_triangle + k]];
    double u[3], v[3];
    for (int i = 0; i < 3; ++i) {
      const Vec3d x = view.vertex(corner[i]) - plane.origin;
      u[i] = dot(plane.u, x), v[i] = dot(plane.v, x);
    }
    if (std::max({u[0], u[1], u[2]}) < low_u || std::min({u[0], u[1], u[2]}) > high_u ||
        std::max({v[0], v[1], v[2]}) < low_v || std::min({v[0], v[1], v[2]}) > high_v)
      continue;
    const double turn = (u[1] - u[0]) * (v[2] - v[0]) - (v[1] - v[0]) * (u[2] - u[0]) < 0 ? -1 : 1;
    DepthPoint buffer[2][polygon_cap + 5];
    const DepthPoint* current = polygon;
    std::size_t left = count;
    for (int i = 0; i < 3 && left >= 3; ++i) {
      const int j = (i + 1) % 3;
      const double cu = turn * (v[i] - v[j]), cv = turn * (u[j] - u[i]);
      left = clip(current, left, cu, cv, 0, -(cu * u[i] + cv * v[i]), buffer[i & 1]);
      current = buffer[i & 1];
    }
    if (left >= 3) moments.add(current, left);
  }
}

struct EdgeSeparation {
  double value;
  Vec3d m;
  enum { first, last, inside } where;
};

// max over the edge's arc of the separation of the solid from the edge's line: at an end of the arc, or where it is
// perpendicular to one of the solid's edges as well.
EdgeSeparation separate_from_edge(const PlacedSolid& solid, const EdgeCone& cone, double margin) {
  const auto value_at = [&](const Vec3d& m) { return solid.lowest(m).value - dot(m, cone.point); };
  EdgeSeparation best{value_at(cone.first), cone.first, EdgeSeparation::first};
  if (const double last = value_at(cone.last); last > best.value) best = {last, cone.last, EdgeSeparation::last};
  double bar = best.value + margin;
  for (const auto& edge : solid.shape.edges) {
    const Vec3d e = solid.rotation * (solid.shape.vertices[edge.vertex[1]] - solid.shape.vertices[edge.vertex[0]]);
    Vec3d m = cross(e, cone.direction);
    const double length = norm(m);
    if (!(length > 0)) continue;
    m *= 1 / length;
    if (!cone.holds(m)) m = -m;
    if (!cone.holds(m)) continue;
    const double value = value_at(m);
    if (value > bar) bar = value, best = {value, m, EdgeSeparation::inside};
  }
  return best;
}

// The part of the segment start + t e, 0 <= t <= 1, that lies in the solid; false when there is none.
bool part_inside(const PlacedSolid& solid, const Vec3d& start, const Vec3d& e, double& from, double& to) {
  from = 0, to = 1;
  const Vec3d x = transposed_times(solid.rotation, start - solid.centre), along = transposed_times(solid.rotation, e);
  for (const auto& face : solid.shape.faces) {
    const double level = dot(face.normal, x) - solid.scale * face.offset, slope = dot(face.normal, along);
    if (slope > 0)
      to = std::min(to, -level / slope);
    else if (slope < 0)
      from = std::max(from, -level / slope);
    else if (level > 0)
      return false;
  }
  return from < to;
}

// The border edge across which the solid is pushed off with the least translation, of those that it lies across.
struct BorderAnswer {
  std::uint32_t edge = shapes::Mesh::none;
  EdgeSeparation separation{-std::numeric_limits<double>::infinity(), {}, EdgeSeparation::first};
  bool own_face = false;  // that direction is the facet's own normal
  Vec3d middle{};         // of the part of the edge that lies in the solid
};
BorderAnswer across_border(const FacetView& view, const PlacedSolid& solid) {
  BorderAnswer best;
  for (std::uint32_t i = 0; i < view.mesh->edges.size(); ++i) {
    const auto& edge = view.edge(i);
    if (edge.facet[0] != view.facet && edge.facet[1] != view.facet) continue;
    const Vec3d start = view.edge_start(i), e = view.edge_vector(i);
    double from, to;
    if (!part_inside(solid, start, e, from, to)) continue;
    const EdgeCone cone = edge_cone(view, i);
    const EdgeSeparation s = separate_from_edge(solid, cone, proof_margin(view.size));
    if (!(s.value > best.separation.value) || !cone.faces(s.m, solid.centre)) continue;
    best = {i, s, dot(s.m, view.m) > 1 - 16 * epsilon, start + 0.5 * (from + to) * e};
  }
  return best;
}

}  // namespace

Contact Features::query(const Placed<shapes::Polyhedron>& a, const Placed<shapes::Mesh>& b, const Vec3d& offset,
                        const Options& options, Cache*) {
  const double extent = facet_extent(b, offset, a.scale * a.shape->circumradius);
  if (!(a.scale > 0 && b.scale > 0 && extent_in_range(extent) && all_at_least(offset, -extent))) return refused();
  const Scale unit = scale_of(extent);
  const double size = unit.down * extent;
  const PlacedSolid solid{*a.shape, unit.down * a.scale, transposed(b.rotation) * a.rotation,
                          -transposed_times(b.rotation, unit.down * offset)};
  const FacetView view(b, solid.centre, unit, size);
  const Extreme low = solid.lowest(view.m);
  const double face_gap = low.value - view.plane;
  if (!(std::abs(face_gap) <= 16)) return refused();  // a rotation that is not finite
  const auto answer = [&](double gap, const Vec3d& outward, const Vec3d& on_facet, double allowance) {
    const Vec3d n = -(b.rotation * outward), touch = b.rotation * (on_facet - solid.centre);
    return smooth_contact(gap, gap - allowance, gap + allowance, n, touch - gap * n, touch, unit.up);
  };
  const Vec3d tip = solid.vertex(low.index);
  const bool over = view.over_region(view.facet, tip);
  if (face_gap > 0) {
    if (over && !options.overlap_only) return answer(face_gap, view.m, tip - face_gap * view.m, rounding(size));
    if (options.overlap_only && face_gap > proof_margin(size))
      return separation_proof(face_gap, size, -(b.rotation * view.m), unit.up);
    if (!over) return not_met(view, face_gap - rounding(size), b.rotation, unit.up);
  }

  PlaneFrame plane;
  plane.normal = view.m;
  tangent_frame(view.m, plane.u, plane.v);
  plane.origin = tip - face_gap * view.m;
  const DepthMap map{transposed_times(solid.rotation, plane.u),      transposed_times(solid.rotation, plane.v),
                     transposed_times(solid.rotation, plane.normal), solid.scale,
                     dot(plane.u, solid.centre - plane.origin),      dot(plane.v, solid.centre - plane.origin),
                     view.plane - dot(view.m, solid.centre)};
  DepthMoments moments, everywhere;
  for_each_submerged(*a.shape, map, [&](const DepthPoint* polygon, std::size_t count) {
    everywhere.add(polygon, count);
    add_over_region(view, plane, polygon, count, moments);
  });
  Patch patch;
  const bool spread = make_patch(moments, plane, patch);
  const auto face_answer = [&](double gap, const Vec3d& on_facet) {
    Contact c = answer(gap, view.m, on_facet, rounding(size));
    if (spread && options.patch) {
      patch.centre -= solid.centre;
      c.patch = rotated(patch, b.rotation);
      c.patch.centre *= unit.up;
      for (double& moment : c.patch.spread) moment = moment * unit.up * unit.up;
    }
    return c;
  };
  const double depth = over ? -face_gap : moments.deepest.h;
  if (!over && !spread) return not_met(view, face_gap - rounding(size), b.rotation, unit.up);

  // A solid across the border: an edge answers when pushing the solid off it is the least translation, the facet beside
  // the edge when that is.
  constexpr double whole = 1 - 0x1p-40;  // the same integral in pieces differs by rounding
  if (moments.h < whole * everywhere.h) {
    const BorderAnswer border = across_border(view, solid);
    if (border.edge != shapes::Mesh::none && !border.own_face &&
        border.separation.value > -depth + proof_margin(size)) {
      const auto& edge = view.edge(border.edge);
      const bool inside = border.separation.where == EdgeSeparation::inside;
      if (inside && edge.facet[0] == view.facet)
        return answer(border.separation.value, border.separation.m, border.middle, polyhedron_rounding * size);
      if (inside || edge.facet[1] != shapes::Mesh::none) return not_met(view, 0, b.rotation, unit.up);
    }
  }
  return face_answer(-depth, over ? plane.origin : plane(moments.deepest.u, moments.deepest.v, 0));
}

}  // namespace contact
