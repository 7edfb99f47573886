// A polyhedron placed in the body frame of a mesh, lengths in a unit near the pair's.
#pragma once

#include <algorithm>

#include "libcontact/methods/facet.h"
#include "libcontact/methods/vertex_support.h"

namespace contact {

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

// The part of the segment start + t e, 0 <= t <= 1, that lies in the solid; false when there is none.
inline bool part_inside(const PlacedSolid& solid, const Vec3d& start, const Vec3d& e, double& from, double& to) {
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

// A point of the solid in the facet's plane, between its lowest vertex and its highest.
inline Vec3d section_point(const PlacedSolid& solid, const FacetView& view, const Vec3d& tip) {
  const Vec3d top = solid.vertex(solid.lowest(-view.m).index);
  const double below = view.plane - dot(view.m, tip), above = dot(view.m, top) - view.plane;
  return above > 0 && below > 0 ? tip + (below / (below + above)) * (top - tip) : tip;
}

}  // namespace contact
