// Any pair of convex bodies by FCL, the Flexible Collision Library: what fcl::distance and fcl::collide do with
// ellipsoids and polyhedra, independent of the methods written here, to compare with.
//
//   apart:        GJK to points p of A and q of B; n along q − p, method_overlap = −|q − p|                      (1)
//   overlapping:  depth, direction n and place of the contact; method_overlap = depth                           (2)
//   gap = support separation along n;  gap <= |x| of every point x of A − B that its questions span             (3)
//
// (2) comes from libccd's portal refinement, as ccd_mpr says: not the least translation. FCL's signed distance, which
// has a polytope of its own, is left aside: it ends the process on failed assertions, and goes through its faces in the
// order of their addresses, so that one question has several answers. The search is asked by support functions, so that
// rounded and potential particles are answered too; the closed forms of FCL for spheres and boxes are left aside. It
// stops at 1e-6 of the extent, its default, or at `tolerance`. What it throws is caught, and it is cut short after 1000
// support questions: both end as not_converged, and so does a distance that differs from that along n by more than 1e-3
// of the extent. The proven interval holds all the same.
//
// Source: https://github.com/flexible-collision-library/fcl (BSD), version 0.7. Validity: bodies of space, no walls.
// Allocates; holds no global state, any thread may ask. Absent when the library was built without FCL. Cost: 3–7 us a
// pair of polyhedra of 8 to 50 vertices, 5–12 us of ellipsoids. Accuracy over the size: apart 1e-14 of polyhedra,
// median 1e-6 and seldom 1e-4 of smooth bodies; overlaps as ccd_mpr. Tests: tests/libcontact/independent_methods.cpp,
// contract.cpp.
#pragma once

#include "libcontact/export.h"
#include "libcontact/methods/other_libraries.h"

namespace contact {

struct CONTACT_API Fcl {
  static constexpr const char* name = "fcl";
  static constexpr int cost_rank = 115;
  static constexpr const char* remark = "FCL's distance and contact, independent; allocates";
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
