// One facet of a mesh wall as a body from one side meets it, in the mesh's body frame, lengths in a unit near the
// pair's.
//
// A facet answers for its flat region and for the real edges that it owns, with their ends. What lies in the Voronoi
// region of a face is never answered by an edge of it, so a flat floor of any triangulation is one plane, a convex edge
// answers once, and a concave edge never.
#pragma once

#include <span>

#include "libcontact/contact.h"
#include "libcontact/scale.h"

namespace contact {

struct FacetView {
  const shapes::Mesh* mesh;
  std::uint32_t facet;
  double scale;   // geometry -> units
  double size;    // L in units
  Vec3d centre;   // of the body
  Vec3d m;        // the facet's unit normal, towards the body's centre (towards the stored normal when in the plane)
  double plane;   // m·x = plane on the facet
  double height;  // of the centre over the plane, >= 0

  FacetView(const Placed<shapes::Mesh>& b, const Vec3d& body_centre, const Scale& unit, double pair_size);

  Vec3d vertex(std::uint32_t i) const { return scale * mesh->vertices[i]; }
  const shapes::Mesh::Edge& edge(std::uint32_t i) const { return mesh->edges[i]; }
  Vec3d edge_start(std::uint32_t i) const { return vertex(edge(i).vertex[0]); }
  Vec3d edge_vector(std::uint32_t i) const { return vertex(edge(i).vertex[1]) - edge_start(i); }

  // Calls use(edge) for every edge around facet f.
  template <class Use>
  void for_each_border(std::uint32_t f, Use&& use) const {
    const auto& at = mesh->facets[f];
    for (std::uint32_t k = 0; k < at.border_count; ++k) use(mesh->facet_borders[at.first_border + k]);
  }
  // x projects into facet f, borders included to rounding. By the borders alone: the triangulation does not show.
  bool over_region(std::uint32_t f, const Vec3d& x) const;
  // The point of the facet that is nearest to x.
  Vec3d nearest(const Vec3d& x) const;
  double distance(const Vec3d& x) const { return norm(x - nearest(x)); }
  // max over the facet of direction·x.
  double highest(const Vec3d& direction) const;
};

// Extent of the pair: |offset|, the body's radius and the reach of the facet, for the choice of the unit. m.
double facet_extent(const Placed<shapes::Mesh>& b, const Vec3d& offset, double radius);

// Outward directions that belong to a real edge: perpendicular to it and out of both facets, the arc that turns about
// `direction` from `first` to `last`.
struct EdgeCone {
  Vec3d point, direction;  // the edge's start and vector, turned so that first -> last is counter-clockwise about it
  Vec3d first, last;       // unit: each a normal of one of the facets (both of the one facet at an open boundary)
  Vec3d inward[2];         // in-plane directions into the facets, the second zero at an open boundary
  bool holds(const Vec3d& w) const { return dot(w, inward[0]) <= 0 && dot(w, inward[1]) <= 0; }
  // The body is met across the edge along m. False from the inner side of a concave edge, whose arc lies behind it.
  bool faces(const Vec3d& m, const Vec3d& centre) const { return dot(m, centre - point) > 0; }
};
EdgeCone edge_cone(const FacetView& view, std::uint32_t edge);

// The real edges that meet at a vertex, and the vector along one of them away from it.
std::span<const std::uint32_t> edges_at(const FacetView& view, std::uint32_t vertex);
Vec3d away_from(const FacetView& view, std::uint32_t edge, std::uint32_t vertex);

// The end of an edge answers from the lowest-numbered real edge that meets it, for directions w away from every edge
// there and when no facet there holds the projection of `x`.
bool end_is_owned(const FacetView& view, std::uint32_t edge, std::uint32_t vertex, const Vec3d& w, const Vec3d& x);

// Nothing of the facet's own is met: separated, by at least `lower` when that is positive.
Contact not_met(const FacetView& view, double lower, const Mat3d& rotation, double up);

}  // namespace contact
