// Pairs that are settled on features: closest face, edge or vertex of a polyhedron or of a mesh facet.
//
//   sphere–polyhedron     outside: the closest point of the surface; inside: the nearest face plane                (1)
//   ellipsoid–polyhedron  max over n of the support separation, on face normals, edge arcs and vertex cones        (2)
//   sphere, ellipsoid–mesh facet
//                         the facet's plane where the body's deepest point lies over the facet, else its own edges
//                         and their ends, within their Voronoi regions                                            (3)
//   polyhedron–mesh facet the facet's plane; where the facet's border passes through the solid, the separating axis
//                         among the normals of the facets, edges and corners there: the one it belongs to answers  (4)
//
// No inner edge of a mesh ever gives a normal, and what several facets see is answered by one (facet.h): a polyhedron
// in shallow contact with a convex mesh is answered once, as the solid would. In (2) the maximum is found by a basis of
// at most three vertices while the overlap is below the ellipsoid's smallest radius of curvature, deeper by trying
// every local maximum there can be; certified at any depth. A separated pair leaves a proof axis in the cache.
//
// Accuracy: 16 eps L for (1) and faces in (3), (4); 32 eps L for (2) and edges. Cost, touching: sphere–box 0.13 us,
// sphere–grain of 24 vertices 0.9 us, ellipsoid–box 0.6 us, ellipsoid–grain 0.9 us (15 us deep), box–facet 0.4 us,
// grain–facet 0.8–1.2 us, ellipsoid–facet 0.12 us; apart with a cached axis below 0.1 us.
// Tests: tests/libcontact/poly_features.cpp, mesh_facets.cpp.
#pragma once

#include "libcontact/contact.h"
#include "libcontact/export.h"

namespace contact {

struct CONTACT_API Features {
  static constexpr const char* name = "features";
  static constexpr int cost_rank = 10;
  static constexpr const char* remark =
      "closest face, edge or vertex; for ellipsoids every normal of the features that can win";

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
