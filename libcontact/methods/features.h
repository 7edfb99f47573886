// Pairs that are settled on features: closest face, edge or vertex of a polyhedron or of a mesh facet.
//
//   sphere–polyhedron     outside: the closest point of the surface; inside: the nearest face plane                (1)
//   ellipsoid–polyhedron  max over n of the support separation, on face normals, edge arcs and vertex cones        (2)
//   body–mesh facet       the facet's plane where the body's deepest point lies over the facet, else its own edges
//                         and their ends, within their Voronoi regions: no inner edge ever gives a normal and no
//                         contact is reported twice (facet.h)                                                      (3)
//
// Accuracy: 16 eps L for (1) and faces in (3), 32 eps L for (2) and edges. Certified, except an ellipsoid deeper than
// its smallest radius of curvature where no proof is found. Tests: tests/libcontact/poly_features.cpp, mesh_*.cpp.
#pragma once

#include "libcontact/contact.h"

namespace contact {

struct Features {
  static constexpr const char* name = "features";
  static constexpr int cost_rank = 10;
  static constexpr const char* remark = "closest face, edge or vertex; Newton on the feature's normals for ellipsoids";

  static Contact query(const Placed<shapes::Sphere>& a, const Placed<shapes::Polyhedron>& b, const Vec3d& offset,
                       const Options& options, Cache* cache);
  static Contact query(const Placed<shapes::Ellipsoid>& a, const Placed<shapes::Polyhedron>& b, const Vec3d& offset,
                       const Options& options, Cache* cache);
  static Contact query(const Placed<shapes::Sphere>& a, const Placed<shapes::Mesh>& b, const Vec3d& offset,
                       const Options& options, Cache* cache);
  static Contact query(const Placed<shapes::Ellipsoid>& a, const Placed<shapes::Mesh>& b, const Vec3d& offset,
                       const Options& options, Cache* cache);
  static Contact query(const Placed<shapes::Polyhedron>& a, const Placed<shapes::Mesh>& b, const Vec3d& offset,
                       const Options& options, Cache* cache);
};

}  // namespace contact
