#include "libcontact/methods/facet.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "libcontact/methods/segments.h"

namespace contact {

FacetView::FacetView(const Placed<shapes::Mesh>& b, const Vec3d& body_centre, const Scale& unit, double pair_size)
    : mesh(b.mesh), facet(b.facet), scale(unit.down * b.scale), size(pair_size), centre(body_centre) {
  const auto& f = mesh->facets[facet];
  m = f.normal;
  plane = scale * f.offset;
  height = dot(m, centre) - plane;
  if (height < 0) m = -m, plane = -plane, height = -height;
}

bool FacetView::over_region(std::uint32_t index, const Vec3d& x) const {
  // Parity of the borders that a ray from x along an axis of the plane crosses; x on a border counts as inside.
  const shapes::Mesh::Facet& f = mesh->facets[index];
  const Vec3d& n = f.normal;
  // Most points lie far within large facets: no border comes near them.
  const Vec3d from_centre = x - scale * f.inner_centre, in_plane = from_centre - dot(from_centre, n) * n;
  const double far_within = scale * f.inner_radius - 64 * epsilon * size;
  if (far_within > 0 && dot(in_plane, in_plane) < far_within * far_within) return true;
  Vec3d u, v;
  tangent_frame(n, u, v);
  const double border = 8 * epsilon * size;
  bool inside = false, on_border = false;
  for_each_border(index, [&](std::uint32_t i) {
    const Vec3d p = edge_start(i) - x, q = vertex(edge(i).vertex[1]) - x;
    const double pu = dot(p, u), pv = dot(p, v), qu = dot(q, u), qv = dot(q, v);
    const double eu = qu - pu, ev = qv - pv, square = eu * eu + ev * ev, area = pu * qv - pv * qu;
    const double along = -(pu * eu + pv * ev);
    if (area * area <= border * border * square && along >= -border * std::sqrt(square) &&
        along <= square + border * std::sqrt(square))
      on_border = true;
    if ((pv > 0) != (qv > 0)) inside ^= (area > 0) == (qv > pv);
  });
  return inside || on_border;
}

Vec3d FacetView::nearest(const Vec3d& x) const {
  if (over_region(facet, x)) return x - (dot(m, x) - plane) * m;
  Vec3d best{};
  double square = std::numeric_limits<double>::infinity();
  for_each_border(facet, [&](std::uint32_t i) {
    const ClosestPoints c = point_segment(x, edge_start(i), edge_vector(i));
    const double s = dot(c.normal, c.normal);
    if (s < square) square = s, best = c.b;
  });
  return best;
}

double FacetView::highest(const Vec3d& direction) const {
  double best = -std::numeric_limits<double>::infinity();
  for_each_border(facet, [&](std::uint32_t i) {
    for (const std::uint32_t v : edge(i).vertex) best = std::max(best, dot(direction, vertex(v)));
  });
  return best;
}

double facet_extent(const Placed<shapes::Mesh>& b, const Vec3d& offset, double radius) {
  const auto& f = b.mesh->facets[b.facet];
  return max_abs(offset) + radius + b.scale * std::max(max_abs(f.lower), max_abs(f.upper));
}

namespace {

void turn_round(EdgeCone& cone) {
  cone.point += cone.direction;
  cone.direction = -cone.direction;
}

}  // namespace

EdgeCone edge_cone(const FacetView& view, std::uint32_t index) {
  const auto& edge = view.edge(index);
  EdgeCone cone;
  cone.point = view.edge_start(index);
  cone.direction = view.edge_vector(index);
  const Vec3d along = normalized(cone.direction);
  cone.inward[0] = edge.inward[0];
  const Vec3d normal = view.mesh->facets[edge.facet[0]].normal;
  if (edge.facet[1] == shapes::Mesh::none) {
    cone.first = normal;
    cone.last = -normal;
    if (dot(cross(normal, -cone.inward[0]), along) < 0) turn_round(cone);
    return cone;
  }
  // The arc ends on a normal of each facet, on the side that the other facet does not lie on.
  cone.inward[1] = edge.inward[1];
  const Vec3d other = view.mesh->facets[edge.facet[1]].normal;
  cone.first = dot(normal, cone.inward[1]) <= 0 ? normal : -normal;
  cone.last = dot(other, cone.inward[0]) <= 0 ? other : -other;
  if (dot(cross(cone.first, cone.last), along) < 0) turn_round(cone);
  return cone;
}

bool end_is_owned(const FacetView& view, std::uint32_t edge, std::uint32_t vertex, const Vec3d& w, const Vec3d& x) {
  const std::span<const std::uint32_t> around = edges_at(view, vertex);
  if (around.front() != edge) return false;
  for (const std::uint32_t i : around) {
    if (dot(w, away_from(view, i, vertex)) > 0) return false;
    for (const std::uint32_t f : view.edge(i).facet)
      if (f != shapes::Mesh::none && view.over_region(f, x)) return false;
  }
  return true;
}

std::span<const std::uint32_t> edges_at(const FacetView& view, std::uint32_t vertex) {
  const auto& first = view.mesh->first_vertex_edge;
  return {view.mesh->vertex_edges.data() + first[vertex], first[vertex + 1] - first[vertex]};
}

Vec3d away_from(const FacetView& view, std::uint32_t edge, std::uint32_t vertex) {
  const auto& e = view.edge(edge);
  return view.vertex(e.vertex[e.vertex[0] == vertex ? 1 : 0]) - view.vertex(vertex);
}

Contact not_met(const FacetView& view, double lower, const Mat3d& rotation, double up) {
  Contact c;
  c.status = Status::separated;
  c.certified = true;
  c.gap = c.gap_lower = std::max(lower, 0.0) * up;
  c.gap_upper = std::numeric_limits<double>::infinity();
  c.normal = c.method_normal = -(rotation * view.m);
  c.method_overlap = -c.gap;
  return c;
}

}  // namespace contact
