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
  const auto& f = mesh->facets[index];
  const double border = 8 * epsilon * size;
  for (std::uint32_t k = 0; k < f.triangle_count; ++k) {
    const std::uint32_t* corner = &mesh->triangles[3 * mesh->facet_triangles[f.first_triangle + k]];
    const Vec3d p[3] = {vertex(corner[0]), vertex(corner[1]), vertex(corner[2])};
    bool inside = true;
    for (int i = 0; i < 3 && inside; ++i) {
      const Vec3d e = p[(i + 1) % 3] - p[i];
      const double side = dot(cross(f.normal, e), x - p[i]);
      inside = side >= 0 || side * side <= border * border * dot(e, e);
    }
    if (inside) return true;
  }
  return false;
}

double FacetView::distance(const Vec3d& x) const {
  if (over_region(facet, x)) return std::abs(dot(m, x) - plane);
  const auto& f = mesh->facets[facet];
  double square = std::numeric_limits<double>::infinity();
  for (std::uint32_t k = 0; k < f.triangle_count; ++k) {
    const std::uint32_t* corner = &mesh->triangles[3 * mesh->facet_triangles[f.first_triangle + k]];
    for (int i = 0; i < 3; ++i) {
      const Vec3d p = vertex(corner[i]);
      const Vec3d w = point_segment(x, p, vertex(corner[(i + 1) % 3]) - p).normal;
      square = std::min(square, dot(w, w));
    }
  }
  return std::sqrt(square);
}

double facet_extent(const Placed<shapes::Mesh>& b, const Vec3d& offset, double radius) {
  const auto& f = b.mesh->facets[b.facet];
  return max_abs(offset) + radius + b.scale * std::max(max_abs(f.lower), max_abs(f.upper));
}

namespace {

// Unit in-plane direction into facet f from an edge of its border. Triangles are wound about the facet's normal, so the
// inside lies left of the border; the triangle side at the edge's start that runs along it tells which way the border
// goes.
Vec3d inward_direction(const FacetView& view, const shapes::Mesh::Edge& edge, std::uint32_t f, const Vec3d& along) {
  const auto& facet = view.mesh->facets[f];
  double best = -2, sign = 1;
  const Vec3d start = view.vertex(edge.vertex[0]);
  for (std::uint32_t k = 0; k < facet.triangle_count; ++k) {
    const std::uint32_t* corner = &view.mesh->triangles[3 * view.mesh->facet_triangles[facet.first_triangle + k]];
    for (int i = 0; i < 3; ++i) {
      if (corner[i] != edge.vertex[0]) continue;
      const Vec3d next = normalized(view.vertex(corner[(i + 1) % 3]) - start);
      const Vec3d previous = normalized(view.vertex(corner[(i + 2) % 3]) - start);
      if (dot(next, along) > best) best = dot(next, along), sign = 1;
      if (dot(previous, along) > best) best = dot(previous, along), sign = -1;
    }
  }
  return normalized(cross(facet.normal, along)) * sign;
}

void turn_round(EdgeCone& cone) {
  cone.point += cone.direction;
  cone.direction = -cone.direction;
}

}  // namespace

Vec3d EdgeCone::middle() const {
  // Between the ends, or away from both facets: one of the two is far from cancelling.
  const Vec3d between = first + last, away = -(inward[0] + inward[1]);
  return normalized(dot(between, between) > 1 ? between : away);
}

EdgeCone edge_cone(const FacetView& view, std::uint32_t index) {
  const auto& edge = view.edge(index);
  EdgeCone cone;
  cone.point = view.edge_start(index);
  cone.direction = view.edge_vector(index);
  const Vec3d along = normalized(cone.direction);
  cone.inward[0] = inward_direction(view, edge, edge.facet[0], along);
  const Vec3d normal = view.mesh->facets[edge.facet[0]].normal;
  if (edge.facet[1] == shapes::Mesh::none) {
    cone.first = normal;
    cone.last = -normal;
    if (dot(cross(normal, -cone.inward[0]), along) < 0) turn_round(cone);
    return cone;
  }
  // The arc ends on a normal of each facet, on the side that the other facet does not lie on.
  cone.inward[1] = inward_direction(view, edge, edge.facet[1], along);
  const Vec3d other = view.mesh->facets[edge.facet[1]].normal;
  cone.first = dot(normal, cone.inward[1]) <= 0 ? normal : -normal;
  cone.last = dot(other, cone.inward[0]) <= 0 ? other : -other;
  if (dot(cross(cone.first, cone.last), along) < 0) turn_round(cone);
  return cone;
}

bool end_is_owned(const FacetView& view, std::uint32_t edge, std::uint32_t vertex, const Vec3d& w, const Vec3d& x) {
  const Vec3d at = view.vertex(vertex);
  for (std::uint32_t i = 0; i < view.mesh->edges.size(); ++i) {
    const auto& e = view.edge(i);
    if (e.vertex[0] != vertex && e.vertex[1] != vertex) continue;
    if (i < edge) return false;
    const Vec3d away = view.vertex(e.vertex[e.vertex[0] == vertex ? 1 : 0]) - at;
    if (dot(w, away) > 0) return false;
    for (const std::uint32_t f : e.facet)
      if (f != shapes::Mesh::none && view.over_region(f, x)) return false;
  }
  return true;
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
