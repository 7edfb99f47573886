// Polyhedron–polyhedron by the separating-axis theorem: exact least translation, exact distance.
//
//   overlapping: gap = max over n of [min over B of n·b − max over A of n·a], n over the face normals of A, of −B, and
//   the edge–edge directions whose Gauss-map arcs cross                                                         (1)
//   separated: distance by GJK, finished in closed form on the features that lie against the supporting planes (gjk.h)
//
// On request (`measure`) the depth of overlap_depth.h comes along, made from the facet that answers.
//
// (1) is the distance from the origin to the boundary of the difference A − B, minus. Three stages, each exact: a facet
// of the difference that is proven from itself alone (difference_facet.h), be it the one that a cache names or the one
// that a ray from inside meets (portal.h); an expanding polytope, for deep overlaps and feet near a border
// (expansion.h); where facets tie to rounding, the search over all axes (sat_search.h), in which an axis is dropped
// only by an upper bound of its separation, never by a heuristic. A face wins over an edge pair that is better by
// rounding only. A proof holds only for a facet that all searches agree on: any cache gives the same bits.
//
// Cost with patch, overlap 1e-3 of the size (bench_pairs), cold and with a cache: bodies met a moment ago (--sample
// 1e-2) cube pair 0.45 and 0.17 us, 12 vertices 0.56 and 0.25, 50: 0.9 and 0.29, 200: 1.9 and 0.48, 1000: 2.0 and 0.58;
// not met a moment ago, when most of it is a wait for memory, 0.5 and 0.19, 1.1 and 0.3, 2.0 and 0.5, 4.4 and 1.4, 14
// and 1.1. Overlap 0.2 of the size: 0.8 to 9 us; distance 1.0 to 4.4 us. A cached axis proves separation in 0.05–0.08
// us. `tolerance` changes nothing: these searches end on a feature after a few steps, not by getting near. Accuracy:
// |error| <= 32 eps L, certified. Tests: tests/libcontact/poly_sat.cpp, poly_proof.cpp.
#pragma once

#include "libcontact/contact.h"
#include "libcontact/export.h"
#include "libcontact/methods/method.h"

namespace contact {

struct CONTACT_API Sat {
  static constexpr const char* name = "sat";
  static constexpr int cost_rank = 20;
  static constexpr const char* remark = "exact least translation over all face and edge axes; exact distance";
  static Contact query(const Placed<shapes::Polyhedron>& a, const Placed<shapes::Polyhedron>& b, const Vec3d& offset,
                       const Options& options, Cache* cache);
  static void query_chunk(KindPair<shapes::Polyhedron, shapes::Polyhedron>, std::size_t n, const Body* a, const Body* b,
                          const Vec3d* offset, const Options& options, Cache* cache, Contact* out);
};

}  // namespace contact
