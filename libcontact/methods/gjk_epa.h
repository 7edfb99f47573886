// Any pair of convex bodies, of space or of the plane, by support functions alone: GJK, and an expanding polytope or
// polygon in the overlap.
//
//   K = A − B;  v = the point nearest to the origin of a simplex of K's points;  w the farthest of K along −v
//   apart:        v·w/|v| <= distance <= |v|                                                                   (1)
//   overlapping:  least distance of the polytope's faces <= depth <= h_K(n),  n the normal of that face          (2)
//
// Both are proven intervals at every step. The search ends when the interval is narrower than `tolerance` times the
// smaller circumradius (1e-10 when none is asked for), or no step gains anything: with more than 1e-6 left it says
// not_converged. Balls are points with a margin, rounded polyhedra their cores with one. Of corners alone the search
// ends by itself, and on their features: the normals of the faces, edges and pairs of edges that the last corners name,
// and the nearest points of these. Of round bodies, when no tolerance is asked for, it ends with Newton's steps, their
// derivative by differences of support points: the gap is then right to rounding (the tests ask it of 95 % of random
// pairs), and apart the interval too. A plane or line has one normal, and its answer is one support point. Where the
// origin lies on a simplex, to rounding, the missing corners are sought across it. method_overlap is minus the gap,
// method_point midway between the points of A and B that are found last. Deep round bodies with one centre, whose depth
// is nearly the same all round, exhaust the polytope of 192 corners.
//
// Source: E. Gilbert, D. Johnson & S. Keerthi, IEEE J. Robot. Autom. 4 (1988) 193; G. van den Bergen, GDC 2001. Cost:
// 0.2 us a pair of spheres, 0.5 us a sphere with 50 vertices, 2 us a pair of cubes, 3–4 us of 50 vertices, 9–19 us of
// ellipsoids, 7–40 us with potential particles; 1.2 us octagons, 2–4 us ellipses (bench_pairs). Tests:
// tests/libcontact/convex_methods.cpp, contract.cpp.
#pragma once

#include "libcontact/export.h"
#include "libcontact/methods/convex_body.h"

namespace contact {

struct CONTACT_API GjkEpa {
  static constexpr const char* name = "gjk_epa";
  template <class A, class B>  // polytopes end in a few steps, round bodies close in on their points
  static constexpr int cost_rank = ends_early<A, B> ? 45 : 80;
  static constexpr const char* remark = "support functions alone: GJK and an expanding polytope";
  static constexpr bool exact = false;
  static constexpr double reach = 1e-9;

  template <class A, class B>
  requires ConvexKinds<A, B>
  static Contact query(const Placed<A>& a, const Placed<B>& b, const Vec3d& offset, const Options& options, Cache*) {
    return answer(convex_body(a), convex_body(b), offset, options);
  }

 private:
  static Contact answer(const ConvexBody& a, const ConvexBody& b, const Vec3d& offset, const Options& options);
};

}  // namespace contact
