// Polyhedron–polyhedron by the separating-axis theorem: exact least translation, exact distance.
//
//   overlapping: gap = max over n of [min over B of n·b − max over A of n·a], n over the face normals of A, of −B, and
//   the edge–edge directions whose Gauss-map arcs cross                                                         (1)
//   separated: distance by GJK, finished in closed form on the features that lie against the supporting planes (gjk.h)
//
// (1) is the distance from the origin to the boundary of the difference A − B, minus. Three stages, each exact: a facet
// of the difference that is proven from itself alone (difference_facet.h), be it the one that a cache names or the one
// that a ray from inside meets (portal.h); an expanding polytope, for deep overlaps and feet near a border
// (expansion.h); where facets tie to rounding, the search over all axes (sat_search.h), in which an axis is dropped
// only by an upper bound of its separation, never by a heuristic. A face wins over an edge pair that is better by
// rounding only. A proof holds only for a facet that all searches agree on: any cache gives the same bits.
//
// Cost with patch, overlap 1e-3 of the size, bodies not met a moment ago (bench_pairs): cube pair 0.57 us, with a cache
// 0.21 us; 12 vertices 1.1 and 0.32, 50: 2.3 and 0.45, 200: 4.4 and 0.80, 1000: 14 and 1.0; a cached axis proves
// separation in 0.06–0.10 us.
// Accuracy: |error| <= 32 eps L, certified. Tests: tests/libcontact/poly_sat.cpp, poly_proof.cpp.
#pragma once

#include "libcontact/contact.h"
#include "libcontact/export.h"

namespace contact {

struct CONTACT_API Sat {
  static constexpr const char* name = "sat";
  static constexpr int cost_rank = 20;
  static constexpr const char* remark = "exact least translation over all face and edge axes; exact distance";
  static Contact query(const Placed<shapes::Polyhedron>& a, const Placed<shapes::Polyhedron>& b, const Vec3d& offset,
                       const Options& options, Cache* cache);
};

}  // namespace contact
