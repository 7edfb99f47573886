// Triangle mesh wall. Coplanar neighbours are merged into facets: a facet is what one contact record belongs to, so no
// inner edge of a flat region ever gives a normal. Edges that two facets share are real; one of the two owns each.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "shapes/math/quat.h"

namespace shapes {

struct Mesh {
  static constexpr const char* name = "mesh";

  struct Facet {
    Vec3d normal;                                  // unit; both sides are solid to a body that comes from them
    double offset;                                 // m, normal·x = offset on the facet
    std::uint32_t first_triangle, triangle_count;  // facet_triangles[first .. first + count)
    std::uint32_t first_edge, edge_count;          // facet_edges[first .. first + count): real edges owned by the facet
    std::uint32_t first_border, border_count;      // facet_borders[first .. first + count): all real edges around it
    Vec3d lower, upper;                            // its bounding box, body frame
    Vec3d inner_centre;                            // a circle in its plane that its borders do not come into, m
    double inner_radius;                           // 0: there is none about its centroid
  };
  struct Edge {  // a real edge: between two facets that are not coplanar, or an open boundary
    std::uint32_t vertex[2];
    std::uint32_t facet[2];  // facet[1] = none at an open boundary; the owner is facet[0]
    Vec3d inward[2];  // unit, in the plane of each facet, perpendicular to the edge, into the facet; zero for none
  };
  static constexpr std::uint32_t none = 0xffffffffu;

  std::vector<Vec3d> vertices;
  std::vector<std::uint32_t> triangles;  // three vertex indices each
  std::vector<Facet> facets;
  std::vector<std::uint32_t> facet_triangles;  // triangle indices, grouped by facet
  std::vector<std::uint32_t> facet_edges;      // edge indices, grouped by owner
  std::vector<std::uint32_t> facet_borders;    // edge indices, grouped by facet, ascending
  std::vector<Edge> edges;
  std::vector<std::uint32_t> vertex_edges;       // edge indices, grouped by vertex, ascending; none at an inner vertex
  std::vector<std::uint32_t> first_vertex_edge;  // vertex v: vertex_edges[first[v] .. first[v + 1])
};

}  // namespace shapes
