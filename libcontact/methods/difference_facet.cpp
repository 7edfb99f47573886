#include "libcontact/methods/difference_facet.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "libcontact/methods/edge_arcs.h"
#include "libcontact/methods/facet_alone.h"

namespace contact {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// The vertices of p next to v along m: the lowest of them, other than `except`.
struct Next {
  double value = infinity;
  std::uint32_t vertex = 0;
};
Next lowest_neighbour(const shapes::Polyhedron& p, const Vec3d& m, std::uint32_t v, std::uint32_t except) {
  Next next;
  for (std::uint32_t k = p.first_spoke[v]; k < p.first_spoke[v + 1]; ++k) {
    const auto& spoke = p.spokes[k];
    if (const double value = dot(m, spoke.to); spoke.vertex != except && value < next.value)
      next = {value, spoke.vertex};
  }
  return next;
}

// The separation along n, with the height of the lowest of other's vertices and of self's highest in their own units.
double between(const PolyhedronPair& pair, const Vec3d& n, double low, double high) {
  return (pair.other_scale * low + dot(n, pair.offset)) - pair.self_scale * high;
}

double face_value(const PolyhedronPair& pair, std::uint32_t face, std::uint32_t vertex) {
  const auto& f = pair.self->faces[face];
  const double low = dot(transposed_times(pair.other_to_self, f.normal), pair.other->vertices[vertex]);
  return between(pair, f.normal, low, f.offset);
}

// A face of pair.self over a vertex of pair.other.
Nearest prove_face(const PolyhedronPair& pair, const Vec3d& core, double core_radius, double size, std::uint32_t face,
                   std::uint32_t& vertex, FacetAxis& axis, bool enclosed) {
  const shapes::Polyhedron &self = *pair.self, &other = *pair.other;
  const auto& f = self.faces[face];
  const Vec3d m = transposed_times(pair.other_to_self, f.normal);
  double low = dot(m, other.vertices[vertex]);
  Next next = lowest_neighbour(other, m, vertex, vertex);
  while (next.value < low) {
    low = next.value;
    vertex = next.vertex;
    next = lowest_neighbour(other, m, vertex, vertex);
  }
  axis.value = between(pair, f.normal, low, f.offset);
  axis.reach = foot_reach(pair, face, pair.other_vertex(vertex));
  if (!(axis.reach > 0)) return Nearest::elsewhere;
  const double rise = std::min(pair.other_scale * (next.value - low), pair.self_scale * self.face_rise[face]);
  return facet_is_alone(-axis.value, axis.reach, rise, f.normal, core, core_radius, size, enclosed) ? Nearest::proven
                                                                                                    : Nearest::open;
}

// s / square along A's edge, the foot of the common perpendicular of the lines of two edges.
Vec3d foot_on_edge(const Arc& a, double s, double square) {
  return a.point + (square > 0 ? std::clamp(s / square, 0.0, 1.0) : 0.5) * a.direction;
}

Nearest prove_edges(const DifferencePair& pair, std::uint32_t edge_a, std::uint32_t edge_b, FacetAxis& axis,
                    bool enclosed) {
  const shapes::Polyhedron &self = *pair.self, &other = *pair.other;
  const Arc a = arc_of_self(pair, edge_a), b = arc_of_other(pair, edge_b);
  Vec3d along, n;
  double weight = 0;
  if (!arcs_cross(a, b, along, weight) || !arc_axis(a, b, along, weight, n)) return Nearest::open;
  const Vec3d m = transposed_times(pair.other_to_self, n);
  const auto& va = self.edges[edge_a].vertex;
  const auto& vb = other.edges[edge_b].vertex;
  const double high = std::max(dot(n, self.vertices[va[0]]), dot(n, self.vertices[va[1]]));
  const double low = std::min(dot(m, other.vertices[vb[0]]), dot(m, other.vertices[vb[1]]));
  axis.normal = n;
  axis.value = between(pair, n, low, high);
  // The foot of the origin on p + s e − (q + t f), and the widths of that parallelogram.
  const Vec3d w = b.point - a.point, c = cross(a.direction, b.direction);
  const double square = dot(c, c);
  const double s = dot(cross(w, b.direction), c), t = dot(cross(w, a.direction), c);
  if (!(square > 0)) return Nearest::open;
  if (!(s > 0 && s < square && t > 0 && t < square)) return Nearest::elsewhere;
  axis.on_a = foot_on_edge(a, s, square);
  const double s_least = std::min(s, square - s), t_least = std::min(t, square - t);
  const double reach = std::sqrt(
      std::min(s_least * s_least / dot(b.direction, b.direction), t_least * t_least / dot(a.direction, a.direction)) /
      square);
  const double below_a =
      std::min(lowest_neighbour(self, -n, va[0], va[1]).value, lowest_neighbour(self, -n, va[1], va[0]).value) + high;
  const double above_b =
      std::min(lowest_neighbour(other, m, vb[0], vb[1]).value, lowest_neighbour(other, m, vb[1], vb[0]).value) - low;
  const double rise = std::min(pair.self_scale * below_a, pair.other_scale * above_b);
  return facet_is_alone(-axis.value, reach, rise, n, pair.core, pair.core_radius, pair.size, enclosed) ? Nearest::proven
                                                                                                       : Nearest::open;
}

}  // namespace

double foot_reach(const PolyhedronPair& pair, std::uint32_t face, const Vec3d& point) {
  const auto& f = pair.self->faces[face];
  double square = infinity, length = 1;  // of the nearest side: square of the cross product, of the side
  const std::uint32_t* loop = pair.self->face_vertices.data() + f.first;
  Vec3d p = pair.self_vertex(loop[f.count - 1]);
  for (std::uint32_t k = 0; k < f.count; ++k) {
    const Vec3d q = pair.self_vertex(loop[k]), e = q - p;
    const double within = dot(cross(f.normal, e), point - p);
    if (!(within > 0)) return 0;
    if (const double s = within * within, l = dot(e, e); s * length < square * l) square = s, length = l;
    p = q;
  }
  return std::sqrt(square / length);
}

FacetAxis axis_of(const DifferencePair& pair, const DifferenceFacet& facet) {
  if (facet.kind == DifferenceFacet::face_of_a)
    return {pair.self->faces[facet.a].normal,
            face_value(pair, facet.a, facet.b),
            foot_reach(pair, facet.a, pair.other_vertex(facet.b)),
            {}};
  if (facet.kind == DifferenceFacet::face_of_b) {
    const PolyhedronPair swapped = pair.swapped();
    return {-(pair.other_to_self * pair.other->faces[facet.b].normal),
            face_value(swapped, facet.b, facet.a),
            foot_reach(swapped, facet.b, swapped.other_vertex(facet.a)),
            {}};
  }
  const Arc a = arc_of_self(pair, facet.a), b = arc_of_other(pair, facet.b);
  Vec3d along, n{};
  double weight = 0;
  arcs_cross(a, b, along, weight);
  arc_axis(a, b, along, weight, n);
  const Vec3d c = cross(a.direction, b.direction);
  return {n, pair.separation(n).value, 0, foot_on_edge(a, dot(cross(b.point - a.point, b.direction), c), dot(c, c))};
}

Nearest prove_nearest(const DifferencePair& pair, DifferenceFacet& facet, FacetAxis& axis, bool enclosed) {
  switch (facet.kind) {
    case DifferenceFacet::face_of_a:
      if (!(facet.a < pair.self->faces.size() && facet.b < pair.other->vertices.size())) break;
      axis.normal = pair.self->faces[facet.a].normal;
      return prove_face(pair, pair.core, pair.core_radius, pair.size, facet.a, facet.b, axis, enclosed);
    case DifferenceFacet::face_of_b:
      if (!(facet.b < pair.other->faces.size() && facet.a < pair.self->vertices.size())) break;
      axis.normal = -(pair.other_to_self * pair.other->faces[facet.b].normal);
      return prove_face(pair.swapped(), -transposed_times(pair.other_to_self, pair.core), pair.core_radius, pair.size,
                        facet.b, facet.a, axis, enclosed);
    case DifferenceFacet::edges:
      if (!(facet.a < pair.self->edges.size() && facet.b < pair.other->edges.size())) break;
      return prove_edges(pair, facet.a, facet.b, axis, enclosed);
    default:
      break;
  }
  return Nearest::open;
}

}  // namespace contact
