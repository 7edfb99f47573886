// Any pair of convex bodies, of space or of the plane, by Minkowski portal refinement: where the ray from a point
// inside K = A − B through the origin leaves K.
//
//   portal: a triangle of K's points that the ray passes through, in the plane a segment; n its normal, outwards
//   apart when the farthest point of K along n is below the origin; overlapping when the portal lies beyond it   (1)
//   refined until K reaches no farther above the portal than 1e-10, or `tolerance`, of the smaller circumradius  (2)
//   method_overlap = h_K(n) = −gap, method_point midway between the points of A and B on the ray                (3)
//   gap <= |p + t (x − p)| − (1 − t) r, of a ball of radius r in K about the inner point p and the portal's point x
//   on the ray: both span a ball about the origin; apart gap <= |x|                                             (4)
//
// (3) is the depth along the normal where the ray leaves K, not the least translation: the direction comes from the
// centres. gap is that separation along n, with (4) and the balls inside as upper bounds, which may be far. Where the
// inner point is the origin, another one in the same ball is taken. 200 steps end as not_converged. A plane or
// line has one normal, and its answer is one support point.
//
// Source: G. Snethen, in Game Programming Gems 7 (2008). Cost: 0.2 us a pair of spheres, 0.9 us of cubes, 1.5 us of 50
// vertices, 3–4 us of ellipsoids, 11–23 us with potential particles; 0.4–0.8 us apart, 2–6 us with potential particles;
// 0.8 us octagons, 1.4 us ellipses (bench_pairs). Tests: tests/libcontact/convex_methods.cpp, contract.cpp.
#pragma once

#include "libcontact/export.h"
#include "libcontact/methods/convex_body.h"

namespace contact {

struct CONTACT_API Mpr {
  static constexpr const char* name = "mpr";
  template <class A, class B>  // a margin makes a polytope round
  static constexpr bool in_few_steps = shapes::is_wall(shapes::kind_of<B>()) ||
                                       (std::is_same_v<A, B> &&
                                        (std::is_same_v<A, shapes::Polyhedron> || std::is_same_v<A, shapes::Polygon>));
  template <class A, class B>
  static constexpr int cost_rank = in_few_steps<A, B> ? 40 : 70;
  static constexpr const char* remark = "support functions alone: depth where the ray of the centres leaves";
  static constexpr bool exact = false;

  template <class A, class B>
  requires ConvexKinds<A, B>
  static Contact query(const Placed<A>& a, const Placed<B>& b, const Vec3d& offset, const Options& options, Cache*) {
    return answer(convex_body(a), convex_body(b), offset, options);
  }

 private:
  static Contact answer(const ConvexBody& a, const ConvexBody& b, const Vec3d& offset, const Options& options);
};

}  // namespace contact
