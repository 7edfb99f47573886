// Any pair of sphere, ellipsoid and polyhedron by support functions alone: GJK, and an expanding polytope in the
// overlap.
//
//   K = A − B;  v = the point nearest to the origin of a simplex of K's points;  w the farthest of K along −v
//   apart:        v·w/|v| <= distance <= |v|                                                                   (1)
//   overlapping:  least distance of the polytope's faces <= depth <= h_K(n),  n the normal of that face          (2)
//
// Both are proven intervals at every step, and the stop is their width: 1e-10 of the size, or that a step gains
// nothing. Spheres are points with a margin. A polytope of 96 corners that has not closed the interval, and 200 steps
// of GJK, end as not_converged, with the interval that is left; a start on the boundary of a simplex is handed over to
// the exact method. method_overlap is minus the gap, method_point midway between the points of A and B that the last
// simplex or face gives.
//
// Source: E. Gilbert, D. Johnson & S. Keerthi, IEEE J. Robot. Autom. 4 (1988) 193; G. van den Bergen, GDC 2001. Cost:
// not measured yet. Tests: tests/libcontact/convex_methods.cpp, contract.cpp.
#pragma once

#include "libcontact/contact.h"
#include "libcontact/export.h"

namespace contact {

struct CONTACT_API GjkEpa {
  static constexpr const char* name = "gjk_epa";
  static constexpr int cost_rank = 80;
  static constexpr const char* remark = "support functions alone: GJK and an expanding polytope";
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
