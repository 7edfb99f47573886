// Polygons, convex or not, as collections of triangles: each vertex of one is sought in the triangles of the other.
//
//   vertex v inside a triangle of the other body:   depth = least distance from v to an edge e of that body's outline,
//   met at a point of e itself; normal that of e                                                               (1)
//   face_face       two neighbouring vertices behind one edge, or v behind e and an end of e behind an edge at v that
//                   runs against e to 1e-9                                                                     (2)
//   corner_corner   an end of e lies inside the other body, behind an edge that ends in v
//   face_corner     else
//
// Triangles fan out from the first vertex of each convex part. Their inner sides are not on the outline and give no
// normal. All contacts are returned by vertex_triangle_contacts; the query answers with the deepest: method_overlap is
// its depth, method_point the mean of v and the point on e. Outlines that cross without a vertex inside the other body
// (a cross of two bars), and bodies that are apart, are found by `planar`, which then answers: never "separated"
// unproven.
//
// The gap of convex polygons is the support separation along the normal, with gap <= −(depth of v).
// Of others gap and bounds are those of `planar`.
//
// Source: W. Wu & J. Cocks (2006), as known from the literature on discrete elements of polygons: vertices in
// triangles, and the three kinds of contact; (1) and the rules of (2) our own. Cost: vertices × triangles whose circles
// meet, 0.4 us a pair of octagons. Tests: tests/libcontact/approximate_polygons.cpp, contract.cpp.
#pragma once

#include <cstddef>

#include "libcontact/contact.h"
#include "libcontact/export.h"

namespace contact {

struct CONTACT_API VertexTriangle {
  static constexpr const char* name = "vertex_triangle";
  static constexpr int cost_rank = 50;
  static constexpr const char* remark = "vertices of each in the triangles of the other (Wu & Cocks 2006)";
  static constexpr bool exact = false;

  static Contact query(const Placed<shapes::Polygon>& a, const Placed<shapes::Polygon>& b, const Vec3d& offset,
                       const Options& options, Cache* cache);
};

struct VertexContact {
  enum Kind : std::uint8_t { face_face, face_corner, corner_corner } kind;
  bool vertex_of_a;            // else of b
  std::uint32_t vertex, edge;  // of the outlines
  double depth;                // m
  Vec3d normal;                // from a to b
  Vec3d point;                 // relative to a's origin, m
};

// Into out[0 … most): their number, in the order of a's vertices, then b's. What exceeds `most` is left out.
CONTACT_API std::size_t vertex_triangle_contacts(const Placed<shapes::Polygon>& a, const Placed<shapes::Polygon>& b,
                                                 const Vec3d& offset, VertexContact* out, std::size_t most);

}  // namespace contact
