// The constrained minimisations of Boon, Houlsby & Utili, solved by NLopt: what constrained_minimisation solves by
// itself, independent of it, to compare with.
//
// Polyhedra, by COBYLA:   max t  subject to  a_i·x + t <= b_i  for the planes of both                            (1)
//   method_overlap = t, method_point x, method_normal Σ over a of λ_i a_i, where λ >= 0 combines the normals of the
//   planes that are active at (x, t) to zero
// Ellipsoids and spheres, by SLSQP:   x = argmin f_A + f_B  subject to  f_A = f_B,  f = |D⁻¹Rᵀ(x − c)|² − 1       (2)
//   method_normal ∇f_A/|∇f_A| at x, method_point x, method_overlap what both bodies cut from the normal line through x;
//   apart minus the support separation
//
// (1) is the radius of the largest ball in the overlap, at most half of its depth. gap is the support separation along
// the normal; its upper bound that of the balls inside the bodies. A ball that touches planes of one body alone is
// handed over to `sat`. 2000 evaluations, active normals that do not combine to zero, and a separation that contradicts
// t or f by more than 1e-6 of the extent end as not_converged.
//
// Source: S. G. Johnson, https://github.com/stevengj/nlopt (COBYLA after M. Powell, 1994; SLSQP after D. Kraft, 1988),
// version 2.7. Validity: above. Allocates; these two algorithms hold no global state, any thread may ask. Absent when
// the library was built without NLopt. Cost: 0.2 ms a pair of cubes, 1.8 ms of 50 vertices, 7–14 us of ellipsoids.
// Accuracy: t to 1e-10 of the extent. Tests: tests/libcontact/independent_methods.cpp, contract.cpp.
#pragma once

#include "libcontact/export.h"
#include "libcontact/methods/other_libraries.h"

namespace contact {

struct CONTACT_API Nlopt {
  static constexpr const char* name = "nlopt";
  static constexpr int cost_rank = 120;
  static constexpr const char* remark = "constrained minimisation by NLopt's COBYLA and SLSQP, independent; allocates";
  static constexpr bool exact = false;

  static Contact query(const Placed<shapes::Polyhedron>& a, const Placed<shapes::Polyhedron>& b, const Vec3d& offset,
                       const Options& options, Cache* cache);
  static Contact query(const Placed<shapes::Sphere>& a, const Placed<shapes::Ellipsoid>& b, const Vec3d& offset,
                       const Options& options, Cache*) {
    return of_ellipsoids(convex_body(a), convex_body(b), offset, options);
  }
  static Contact query(const Placed<shapes::Ellipsoid>& a, const Placed<shapes::Ellipsoid>& b, const Vec3d& offset,
                       const Options& options, Cache*) {
    return of_ellipsoids(convex_body(a), convex_body(b), offset, options);
  }

 private:
  static Contact of_ellipsoids(const ConvexBody& a, const ConvexBody& b, const Vec3d& offset, const Options& options);
};

}  // namespace contact
