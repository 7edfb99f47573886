// Any pair of convex bodies by libccd, another library's GJK with an expanding polytope and its Minkowski portal
// refinement: independent of the methods written here, to compare with.
//
//   overlapping:  depth, direction n and place as libccd returns them; method_overlap = depth                   (1)
//   apart:        libccd gives no distance: n is the direction of its support questions that separates most     (2)
//   gap = support separation along n;  gap <= |x| of every point x of A − B that libccd has seen                (3)
//
// (1) of ccd_mpr is the distance along the ray from a point inside A − B through the origin to where it leaves, or to
// the last portal there: not the least translation. The polytope stops at 1e-8 of the extent, the portal at 1e-6, or at
// `tolerance`: they get no better beyond. The polytope often ends on a wrong face, of two spheres in 2 of 5: where the
// depth differs from that along n by more than 1e-3 of the extent, or no question bears out its verdict, it is asked
// again from another first direction, up to eight times, and then the answer is not_converged; the proven interval
// holds all the same. It has no cap of its own either: after 1000 support questions both bodies are shown to it as one
// point, at which each of its loops ends.
//
// Source: https://github.com/danfis/libccd (BSD), version 2.1. Validity: bodies of space, no walls. Allocates; libccd
// holds no global state, any thread may ask. Absent when the library was built without libccd. Cost: 2.5–6 us a pair of
// polyhedra of 8 to 50 vertices, 5–8 us of ellipsoids by ccd_mpr, 10–45 us by ccd_gjk_epa. Accuracy of an overlap, over
// the size: ccd_gjk_epa 1e-12 of polyhedra, median 3e-5 and seldom 1e-3 of smooth bodies; ccd_mpr where the ray leaves,
// a tenth and more of deep smooth bodies. Tests: tests/libcontact/independent_methods.cpp, contract.cpp.
#pragma once

#include "libcontact/export.h"
#include "libcontact/methods/other_libraries.h"

namespace contact {

struct CONTACT_API CcdGjkEpa {
  static constexpr const char* name = "ccd_gjk_epa";
  static constexpr int cost_rank = 110;
  static constexpr const char* remark = "libccd's GJK and expanding polytope, independent; allocates";
  static constexpr bool exact = false;

  template <class A, class B>
  requires ConvexSolids<A, B>
  static Contact query(const Placed<A>& a, const Placed<B>& b, const Vec3d& offset, const Options& options, Cache*) {
    return answer(convex_body(a), convex_body(b), offset, options);
  }

 private:
  static Contact answer(const ConvexBody& a, const ConvexBody& b, const Vec3d& offset, const Options& options);
};

struct CONTACT_API CcdMpr {
  static constexpr const char* name = "ccd_mpr";
  static constexpr int cost_rank = 105;
  static constexpr const char* remark = "libccd's portal refinement, independent; allocates";
  static constexpr bool exact = false;

  template <class A, class B>
  requires ConvexSolids<A, B>
  static Contact query(const Placed<A>& a, const Placed<B>& b, const Vec3d& offset, const Options& options, Cache*) {
    return answer(convex_body(a), convex_body(b), offset, options);
  }

 private:
  static Contact answer(const ConvexBody& a, const ConvexBody& b, const Vec3d& offset, const Options& options);
};

}  // namespace contact
