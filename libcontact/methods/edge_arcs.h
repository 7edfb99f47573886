// Edges of two polyhedra as arcs of the Gauss map, and the axis where an arc of one crosses an arc of the other.
//
// The axis is interpolated along A's arc between the two face normals of A's edge, so it is perpendicular to that edge
// by construction and needs no threshold for near-parallel edges: an error along the arc costs eps times the edge's
// length, while the cross product of near-parallel edges would tilt off both arcs by eps/sine.
#pragma once

#include <cmath>

#include "libcontact/methods/polyhedron_pair.h"
#include "libcontact/methods/segments.h"

namespace contact {

struct Arc {
  Vec3d point, direction;  // first vertex, and second minus first
  Vec3d n0, n1;            // outward normals of its faces
  std::uint32_t edge;
};

// Both in the frame of pair.self.
inline Arc arc_of_self(const PolyhedronPair& pair, std::uint32_t i) {
  const auto& edge = pair.self->edges[i];
  const Vec3d p = pair.self_vertex(edge.vertex[0]);
  return {p, pair.self_vertex(edge.vertex[1]) - p, pair.self->faces[edge.face[0]].normal,
          pair.self->faces[edge.face[1]].normal, i};
}
inline Arc arc_of_other(const PolyhedronPair& pair, std::uint32_t i) {
  const auto& edge = pair.other->edges[i];
  const Vec3d p = pair.other_scale * pair.other->vertices[edge.vertex[0]];
  const Vec3d e = pair.other_scale * pair.other->vertices[edge.vertex[1]] - p;
  const Mat3d& r = pair.other_to_self;
  return {r * p + pair.offset, r * e, r * pair.other->faces[edge.face[0]].normal,
          r * pair.other->faces[edge.face[1]].normal, i};
}

// The arcs n0 n1 of A and −m0 −m1 of B cross when each one's ends lie on both sides of the other's great circle, on the
// same half of the sphere. Ends on the circle count as crossing. `along`, at most `weight` long, points to the
// crossing; false for parallel edges too, beside which the faces are as good.
inline bool arcs_cross(const Arc& a, const Arc& b, Vec3d& along, double& weight) {
  const double s0 = dot(a.n0, b.direction), s1 = dot(a.n1, b.direction);
  if ((s0 > 0 && s1 > 0) || (s0 < 0 && s1 < 0)) return false;
  const double t0 = dot(b.n0, a.direction), t1 = dot(b.n1, a.direction);
  if ((t0 > 0 && t1 > 0) || (t0 < 0 && t1 < 0)) return false;
  if ((t0 > 0 && s1 > 0) || (t0 < 0 && s1 < 0)) return false;
  const double w0 = std::abs(s1), w1 = std::abs(s0);
  weight = w0 + w1;
  along = w0 * a.n0 + w1 * a.n1;
  return weight > 0;
}

// The unit axis of arcs that cross; false when there is none.
inline bool arc_axis(const Arc& a, const Arc& b, Vec3d along, double weight, Vec3d& axis) {
  if (dot(along, along) < weight * weight / 64) {
    // The rim of a plate: the two normals cancel and the arc is too long to interpolate. The cross product errs by
    // rounding / sine, but only about A's edge: off the crossing by that much, B's edge leaves the plane by rounding.
    const Vec3d m = perpendicular(cross(a.direction, b.direction), a.direction);
    along = dot(m, along) < 0 ? -m : m;
  }
  const double length = norm(along);
  axis = along * (1 / length);
  return length > 0;
}

}  // namespace contact
