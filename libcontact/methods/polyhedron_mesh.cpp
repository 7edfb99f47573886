#include <algorithm>
#include <cmath>
#include <limits>

#include "libcontact/methods/facet.h"
#include "libcontact/methods/features.h"
#include "libcontact/methods/method.h"
#include "libcontact/methods/overlap_moments.h"
#include "libcontact/methods/placed_solid.h"
#include "libcontact/methods/plane_slope.h"
#include "libcontact/methods/polyhedron_pair.h"
#include "libcontact/methods/segments.h"

namespace contact {
namespace {

// The box, in the facet's plane, of what lies under that plane.
struct Box {
  double low_u = std::numeric_limits<double>::infinity(), high_u = -low_u, low_v = low_u, high_v = -low_u;
  void add(double u, double v) {
    low_u = std::min(low_u, u), high_u = std::max(high_u, u);
    low_v = std::min(low_v, v), high_v = std::max(high_v, v);
  }
  // An edge around the facet may pass through the box, widened by rounding; only its own sides and box are looked at.
  bool crossed_by_border(const FacetView& view, const PlaneFrame& plane) const {
    const double border = 16 * epsilon * view.size;
    bool crossed = false;
    view.for_each_border(view.facet, [&](std::uint32_t i) {
      const Vec3d p = view.edge_start(i) - plane.origin, q = view.vertex(view.edge(i).vertex[1]) - plane.origin;
      const double pu = dot(p, plane.u), pv = dot(p, plane.v), qu = dot(q, plane.u), qv = dot(q, plane.v);
      if (std::max(pu, qu) < low_u - border || std::min(pu, qu) > high_u + border ||
          std::max(pv, qv) < low_v - border || std::min(pv, qv) > high_v + border)
        return;
      const double eu = qu - pu, ev = qv - pv;
      const double middle = eu * (0.5 * (low_v + high_v) - pv) - ev * (0.5 * (low_u + high_u) - pu);
      const double reach =
          std::abs(eu) * (0.5 * (high_v - low_v) + border) + std::abs(ev) * (0.5 * (high_u - low_u) + border);
      crossed |= std::abs(middle) <= reach;
    });
    return crossed;
  }
};

// Moments of what lies under the facet's region, triangle by triangle: they add, so the triangulation does not show.
void add_over_region(const FacetView& view, const PlaneFrame& plane, const DepthPoint* polygon, std::size_t count,
                     DepthMoments& moments, PlaneOverlap& overlap) {
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
    if (left < 3) continue;
    moments.add(current, left);
    overlap.add(current, left);
  }
}

// What lies under the whole plane of the facet, about the solid's origin, along the mesh's axes.
bool measure_under(const PlacedSolid& solid, const FacetView& view, double size, OverlapDepth& out) {
  const Vec3d n = transposed_times(solid.rotation, view.m);
  const OverlapBody& body = overlap_body(solid.shape, solid.scale, {n, view.plane - dot(view.m, solid.centre)});
  DepthSlope slope;
  if (!depth_slope(body, size, slope)) return false;
  out = rotated(line_of_action(slope), solid.rotation);
  return true;
}

struct EdgeSeparation {
  double value;
  Vec3d m;
  enum { first, last, inside } where;
};

// max over the edge's arc of the separation of the solid from the edge's line: at an end of the arc, or where it is
// perpendicular to one of the solid's edges as well. Ties within `margin` go to the ends.
EdgeSeparation separate_from_edge(const PlacedSolid& solid, const EdgeCone& cone, double margin) {
  const auto value_at = [&](const Vec3d& m) { return solid.lowest(m).value - dot(m, cone.point); };
  EdgeSeparation best{value_at(cone.first), cone.first, EdgeSeparation::first};
  if (const double last = value_at(cone.last); last > best.value) best = {last, cone.last, EdgeSeparation::last};
  double bar = best.value + margin;
  // In the solid's own frame.
  const Vec3d direction = transposed_times(solid.rotation, cone.direction);
  const Vec3d inward[2] = {transposed_times(solid.rotation, cone.inward[0]),
                           transposed_times(solid.rotation, cone.inward[1])};
  const Vec3d point = transposed_times(solid.rotation, cone.point - solid.centre);
  for (const auto& edge : solid.shape.edges) {
    const Vec3d& start = solid.shape.vertices[edge.vertex[0]];
    Vec3d m = cross(solid.shape.vertices[edge.vertex[1]] - start, direction);
    const double x = dot(m, inward[0]), y = dot(m, inward[1]);
    if ((x < 0 && y > 0) || (x > 0 && y < 0)) continue;
    if (x > 0 || y > 0) m = -m;
    const double square = dot(m, m), height = dot(m, solid.scale * start - point);
    // The separation is at most that of the solid's edge.
    if (!(square > 0) || (bar <= 0 ? height <= 0 && height * height >= bar * bar * square
                                   : height <= 0 || height * height <= bar * bar * square))
      continue;
    const Vec3d in_mesh = solid.rotation * (m * (1 / std::sqrt(square)));
    if (const double value = value_at(in_mesh); value > bar)
      bar = value, best = {value, in_mesh, EdgeSeparation::inside};
  }
  return best;
}

// The least translation off the mesh's edges and corners that lie in the solid, on and about the facet's border, and
// off the facets beside them: a search for a separating axis among the directions of their normal cones. Facets that
// meet the solid side by side make the same search where they join, so one of them answers.
class BorderSearch {
 public:
  enum class Answer : std::uint8_t { none, facet, neighbour, edge, corner };
  Answer answer = Answer::none;
  double value = -std::numeric_limits<double>::infinity();
  Vec3d m{};             // outward
  Vec3d on_mesh{};       // where the edge or corner is met
  bool owned = false;    // by this facet
  bool open = false;     // no facet lies across: the facet's own depth competes
  bool crossed = false;  // a border passes through the solid

  BorderSearch(const FacetView& view, const PlacedSolid& solid)
      : view_(view), solid_(solid), margin_(proof_margin(solid.scale * solid.shape.circumradius)) {
    view.for_each_border(view.facet, [&](std::uint32_t i) {
      if (try_border(i)) crossed = true;
    });
  }

 private:
  // Concave towards the solid, which lies before both facets: their planes answer, the edge never does.
  bool is_concave(const EdgeCone& cone) const {
    return !cone.faces(cone.first, solid_.centre) && !cone.faces(cone.last, solid_.centre);
  }
  // An edge and its ends, where they lie in the solid; false when they do not.
  bool try_border(std::uint32_t i) {
    const Vec3d start = view_.edge_start(i), e = view_.edge_vector(i);
    const Vec3d w = point_segment(solid_.centre, start, e).normal;
    const double radius = solid_.scale * solid_.shape.circumradius;
    double from, to;
    if (dot(w, w) > radius * radius || !part_inside(solid_, start, e, from, to)) return false;
    if (from == 0) try_corner(view_.edge(i).vertex[0]);
    if (to == 1) try_corner(view_.edge(i).vertex[1]);
    if (from > 0 && to < 1) try_edge(i, from, to);  // else its corner has tried it
    return true;
  }
  void try_edge(std::uint32_t i, double from, double to) {
    const EdgeCone cone = edge_cone(view_, i);
    if (is_concave(cone)) return;
    const EdgeSeparation s = separate_from_edge(solid_, cone, margin_);
    if (!(s.value > value + (answer == Answer::facet ? margin_ : 0)) || !cone.faces(s.m, solid_.centre)) return;
    const auto& edge = view_.edge(i);
    const bool inside = s.where == EdgeSeparation::inside;
    if (!inside && edge.facet[1] == shapes::Mesh::none) return;  // the facet's own normal, which answers anyway
    value = s.value;
    m = s.m;
    on_mesh = view_.edge_start(i) + 0.5 * (from + to) * view_.edge_vector(i);
    open = edge.facet[1] == shapes::Mesh::none;
    owned = inside && edge.facet[0] == view_.facet;
    answer = inside ? Answer::edge : (dot(m, view_.m) > 1 - 16 * epsilon ? Answer::facet : Answer::neighbour);
  }
  // A corner's edges, and the solid's face normals that lead away from all of them.
  void try_corner(std::uint32_t v) {
    const std::span<const std::uint32_t> around = edges_at(view_, v);
    for (const std::uint32_t i : around) {
      double from, to;
      if (part_inside(solid_, view_.edge_start(i), view_.edge_vector(i), from, to)) try_edge(i, from, to);
    }
    const Vec3d at = view_.vertex(v), x = transposed_times(solid_.rotation, at - solid_.centre);
    for (const auto& face : solid_.shape.faces) {
      const double height = dot(face.normal, x) - solid_.scale * face.offset;
      if (!(height > value + margin_)) continue;
      const Vec3d n = -(solid_.rotation * face.normal);
      bool away = dot(n, solid_.centre - at) > 0;
      for (const std::uint32_t i : around) away = away && dot(n, away_from(view_, i, v)) < 0;
      if (!away) continue;
      value = height;
      m = n;
      on_mesh = at;
      open = std::any_of(around.begin(), around.end(),
                         [&](std::uint32_t i) { return view_.edge(i).facet[1] == shapes::Mesh::none; });
      owned = view_.edge(around.front()).facet[0] == view_.facet;
      answer = Answer::corner;
    }
  }

  const FacetView& view_;
  const PlacedSolid& solid_;
  double margin_;
};

// A direction that proves the solid apart from the facet: normal to the facet, from its nearest point, or away from one
// of its borders. False when none of them does.
bool find_separation(const FacetView& view, const PlacedSolid& solid, double enough, double& value, Vec3d& m) {
  const auto proves = [&](const Vec3d& direction) {
    m = direction;
    value = solid.lowest(m).value - view.highest(m);
    return value > enough;
  };
  const Vec3d w = solid.centre - view.nearest(solid.centre);
  if (const double distance = norm(w); distance > 0 && proves(w * (1 / distance))) return true;
  bool found = false;
  view.for_each_border(view.facet, [&](std::uint32_t i) {
    const auto& edge = view.edge(i);
    if (!found) found = proves(-edge.inward[edge.facet[0] == view.facet ? 0 : 1]);
  });
  return found;
}

}  // namespace

Contact Features::query(const Placed<shapes::Polyhedron>& a, const Placed<shapes::Mesh>& b, const Vec3d& offset,
                        const Options& options, Cache* cache) {
  const double radius = a.scale * a.shape->circumradius, extent = facet_extent(b, offset, radius);
  if (!(a.scale > 0 && b.scale > 0 && extent_in_range(extent) && all_at_least(offset, -extent))) return refused();
  const Scale unit = scale_of(extent);
  const double size = unit.down * extent;
  const PlacedSolid solid{*a.shape, unit.down * a.scale, transposed(b.rotation) * a.rotation,
                          -transposed_times(b.rotation, unit.down * offset)};
  const FacetView view(b, solid.centre, unit, size);
  if (!(view.height <= 16)) return refused();  // a rotation that is not finite
  const double enough = options.overlap_only ? proof_margin(size) : std::numeric_limits<double>::infinity();
  const auto proof = [&](double value, const Vec3d& m) {
    const Vec3d n = -(b.rotation * m);
    if (cache) cache->axis = transposed_times(a.rotation, n);
    return separation_proof(value, size, n, unit.up);
  };
  const Extreme low = solid.lowest(view.m);
  const double face_gap = low.value - view.plane;
  if (!(std::abs(face_gap) <= 16)) return refused();
  if (face_gap > enough) return proof(face_gap, view.m);
  if (Vec3d axis; options.overlap_only && cached_direction(cache, axis)) {
    const Vec3d m = -transposed_times(b.rotation, a.rotation * axis);
    if (const double value = solid.lowest(m).value - view.highest(m); value > enough) return proof(value, m);
  }
  if (cache) cache->axis = {};
  const auto apart = [&] {
    double value;
    Vec3d m;
    if (options.overlap_only && find_separation(view, solid, enough, value, m)) return proof(value, m);
    return not_met(view, face_gap - rounding(size), b.rotation, unit.up);
  };
  const auto answer = [&](double gap, const Vec3d& outward, const Vec3d& on_mesh, double allowance) {
    const Vec3d n = -(b.rotation * outward), touch = b.rotation * (on_mesh - solid.centre);
    return smooth_contact(gap, gap - allowance, gap + allowance, n, touch - gap * n, touch, unit.up);
  };
  const Vec3d tip = solid.vertex(low.index);
  const bool over = view.over_region(view.facet, tip);
  if (face_gap > 0) return over ? answer(face_gap, view.m, tip - face_gap * view.m, rounding(size)) : apart();

  PlaneFrame plane;
  plane.normal = view.m;
  tangent_frame(view.m, plane.u, plane.v);
  plane.origin = tip - face_gap * view.m;
  const DepthMap map{transposed_times(solid.rotation, plane.u),      transposed_times(solid.rotation, plane.v),
                     transposed_times(solid.rotation, plane.normal), solid.scale,
                     dot(plane.u, solid.centre - plane.origin),      dot(plane.v, solid.centre - plane.origin),
                     view.plane - dot(view.m, solid.centre)};
  DepthMoments moments;
  PlaneOverlap overlap;
  Box under;
  for_each_submerged(*a.shape, map, [&](const DepthPoint* polygon, std::size_t count) {
    moments.add(polygon, count);
    for (std::size_t i = 0; i < count; ++i) under.add(polygon[i].u, polygon[i].v);
  });
  double gap = face_gap;
  Vec3d on_facet = plane.origin;
  const bool whole = !under.crossed_by_border(view, plane);
  if (!whole) {
    const BorderSearch border(view, solid);
    if (!border.crossed && !view.over_region(view.facet, section_point(solid, view, tip))) return apart();
    using Answer = BorderSearch::Answer;
    const double margin = proof_margin(size);
    moments = {};
    for_each_submerged(*a.shape, map, [&](const DepthPoint* polygon, std::size_t count) {
      add_over_region(view, plane, polygon, count, moments, overlap);
    });
    if (!over) {
      gap = -std::max(moments.deepest.h, 0.0);
      on_facet = plane(moments.deepest.u, moments.deepest.v, 0);
    }
    if (border.answer == Answer::neighbour) return not_met(view, 0, b.rotation, unit.up);
    if (border.answer == Answer::facet) gap = std::min(border.value, 0.0);
    if ((border.answer == Answer::edge || border.answer == Answer::corner) &&
        (!border.open || border.value > gap + margin))
      return border.owned ? answer(border.value, border.m, border.on_mesh, polyhedron_rounding * size)
                          : not_met(view, 0, b.rotation, unit.up);
    if (!over && !(moments.deepest.h > 0)) return not_met(view, 0, b.rotation, unit.up);
  } else if (!over) {
    return apart();
  }
  Contact c = answer(gap, view.m, on_facet, rounding(size));
  if (Patch patch; options.patch && make_patch(moments, plane, patch)) {
    patch.centre -= solid.centre;
    c.patch = rotated(patch, b.rotation);
    c.patch.centre *= unit.up;
    for (double& moment : c.patch.spread) moment = moment * unit.up * unit.up;
  }
  if (options.measure) {
    OverlapDepth depth;
    if (whole ? measure_under(solid, view, radius * unit.down, depth)
              : overlap.slope(plane, radius * unit.down, depth)) {
      if (!whole) depth.point -= solid.centre;
      c.measure = rotated(depth, b.rotation);
      rescale(c.measure, unit.up);
    }
  }
  return c;
}

}  // namespace contact
