// A candidate as the search finds it: inner header of the broad phase.
#pragma once

#include <algorithm>

#include "libdem/contacts.h"

namespace dem {

struct Candidate {
  Key key;
  std::uint32_t a, b;
};

// Whether a sphere about x, of radius reach, may touch a facet of a mesh; in the mesh's frame.
inline bool near_facet(const shapes::Mesh::Facet& f, const Vec3d& x, double reach) {
  double d2 = 0;
  for (int k = 0; k < 3; ++k) {
    const double d = std::max({f.lower[k] - x[k], x[k] - f.upper[k], 0.0});
    d2 += d * d;
  }
  const double height = dot(f.normal, x) - f.offset;
  return d2 < reach * reach && height < reach && height > -reach;
}

// Likewise of a polygon: whether the circle reaches over the line of every side of one of its convex parts.
inline bool near_polygon(const shapes::Polygon& p, const Vec3d& x, double reach) {
  const auto near = [&](const shapes::Polygon::Part& part) {
    for (std::size_t k = 0; k < part.normals.size(); ++k)
      if (dot(part.normals[k], x) - part.offsets[k] >= reach) return false;
    return true;
  };
  return std::any_of(p.parts.begin(), p.parts.end(), near);
}

}  // namespace dem
