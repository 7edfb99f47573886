// Any pair of sphere, ellipsoid and polyhedron by Minkowski portal refinement: where the ray from a point inside K = A
// − B through the origin leaves K.
//
//   portal: a triangle of K's points that the ray passes through, n its normal away from the inner point
//   apart when the farthest point of K along n is below the origin; overlapping when the portal lies beyond it   (1)
//   refined until K reaches no farther than 1e-10 of the size above the portal                                 (2)
//   method_overlap = h_K(n) = −gap, method_point midway between the points of A and B on the ray                (3)
//
// (3) is the depth along the normal where the ray leaves K, not the least translation: the direction comes from the
// centres. gap is that separation along n, the upper bound that of the balls inside, which may be far. 200 steps end as
// not_converged. Inner points that coincide with the origin are handed over.
//
// Source: G. Snethen, in Game Programming Gems 7 (2008). Cost: not measured yet. Tests:
// tests/libcontact/convex_methods.cpp, contract.cpp.
#pragma once

#include "libcontact/contact.h"
#include "libcontact/export.h"

namespace contact {

struct CONTACT_API Mpr {
  static constexpr const char* name = "mpr";
  static constexpr int cost_rank = 70;
  static constexpr const char* remark = "support functions alone: depth where the ray of the centres leaves";
  static constexpr bool exact = false, certified = false;  // what it hands over may not be

  static Contact query(const Placed<shapes::Sphere>& a, const Placed<shapes::Ellipsoid>& b, const Vec3d& offset,
                       const Options& options, Cache* cache);
  static Contact query(const Placed<shapes::Sphere>& a, const Placed<shapes::Polyhedron>& b, const Vec3d& offset,
                       const Options& options, Cache* cache);
  static Contact query(const Placed<shapes::Ellipsoid>& a, const Placed<shapes::Ellipsoid>& b, const Vec3d& offset,
                       const Options& options, Cache* cache);
  static Contact query(const Placed<shapes::Ellipsoid>& a, const Placed<shapes::Polyhedron>& b, const Vec3d& offset,
                       const Options& options, Cache* cache);
  static Contact query(const Placed<shapes::Polyhedron>& a, const Placed<shapes::Polyhedron>& b, const Vec3d& offset,
                       const Options& options, Cache* cache);
};

}  // namespace contact
