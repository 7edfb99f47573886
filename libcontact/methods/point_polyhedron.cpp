#include "libcontact/methods/point_polyhedron.h"

#include <cmath>
#include <limits>

#include "libcontact/contact.h"
#include "libcontact/methods/segments.h"

namespace contact {
namespace {

using Feature = SurfacePoint::Feature;

double height(const shapes::Polyhedron& p, std::size_t i, double scale, const Vec3d& x) {
  return p.nx[i] * x.x + p.ny[i] * x.y + p.nz[i] * x.z - scale * p.nd[i];
}

// x over the face: on the inner side of every edge's plane.
bool over_face(const shapes::Polyhedron& p, const shapes::Polyhedron::Face& face, double scale, const Vec3d& x) {
  const std::uint32_t* loop = p.face_vertices.data() + face.first;
  Vec3d from = scale * p.vertices[loop[face.count - 1]];
  for (std::uint32_t k = 0; k < face.count; ++k) {
    const Vec3d to = scale * p.vertices[loop[k]];
    if (dot(cross(face.normal, to - from), x - from) < 0) return false;
    from = to;
  }
  return true;
}

}  // namespace

SurfacePoint surface_point(const shapes::Polyhedron& p, double scale, const Vec3d& x, double size) {
  double level = -std::numeric_limits<double>::infinity();
  std::size_t top = 0;
  for (std::size_t i = 0; i < p.faces.size(); ++i) {
    const double h = height(p, i, scale, x);
    if (h > level) level = h, top = i;
  }
  const SurfacePoint on_top{level, p.faces[top].normal, Feature::face, static_cast<std::uint32_t>(top), level};
  if (!(level > 0) || over_face(p, p.faces[top], scale, x)) return on_top;
  // Not over its highest face: the closest point lies in a face that x is over, or on an edge of one that it is above.
  for (std::size_t i = 0; i < p.faces.size(); ++i)
    if (const double h = height(p, i, scale, x); h > 0 && over_face(p, p.faces[i], scale, x))
      return {h, p.faces[i].normal, Feature::face, static_cast<std::uint32_t>(i), level};
  SurfacePoint best = on_top;
  double square = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < p.edges.size(); ++i) {
    const auto& edge = p.edges[i];
    if (height(p, edge.face[0], scale, x) <= 0 && height(p, edge.face[1], scale, x) <= 0) continue;
    const Vec3d from = scale * p.vertices[edge.vertex[0]], to = scale * p.vertices[edge.vertex[1]];
    const ClosestPoints c = point_segment(x, from, to - from);
    if (dot(c.normal, c.normal) >= square) continue;
    square = dot(c.normal, c.normal);
    best.outward = -c.normal;
    const bool at_from = c.b == from, at_to = c.b == to;
    best.feature = at_from || at_to ? Feature::vertex : Feature::edge;
    best.index = at_from ? edge.vertex[0] : (at_to ? edge.vertex[1] : static_cast<std::uint32_t>(i));
  }
  best.distance = std::sqrt(square);
  if (!(best.distance > 4 * epsilon * size)) return {best.distance, on_top.outward, Feature::face, on_top.index, level};
  best.outward *= 1 / best.distance;
  return best;
}

}  // namespace contact
