// Ellipsoids and ellipses by the geometric potential: the point of each surface that lies deepest in the other body.
//
//   φ(x) = |D⁻¹ Rᵀ (x − centre)|²,   x_B = argmin φ_A on B's surface,   x_A = argmin φ_B on A's surface         (1)
//   method_overlap = ±|x_A − x_B|, positive when φ_A(x_B) < 1; method_normal along x_A − x_B, from A to B; method_point
//   midway                                                                                                     (2)
//   normal ∝ ∇φ_A/|∇φ_A| − ∇φ_B/|∇φ_B| at the method_point; gap = support separation along it                   (3)
//
// (2) does not tend to the true overlap as that vanishes: up to (q + 1/q)/2 times it at aspect ratio q, with x_A −
// x_B far off the normal (bench_overlaps prints both). (3) errs by the square of the overlap. In the space where A is a
// ball, (1) is the nearest point of an ellipsoid to a point: both argmins share one singular value decomposition and
// never fail to converge.
//
// Source: X. Lin & T.-T. Ng, Int. J. Numer. Anal. Meth. Geomech. 19 (1995) 653, for (1) and (2); (3) our own.
// Validity: any pair; coincident centres are handed over. Cost: 0.45–1.1 us. Accuracy: bounds of quadric_pair.h,
// certified. Tests: tests/libcontact/approximate_ellipsoids.cpp, contract.cpp.
#pragma once

#include "libcontact/contact.h"
#include "libcontact/export.h"

namespace contact {

struct CONTACT_API GeometricPotential {
  static constexpr const char* name = "geometric_potential";
  static constexpr int cost_rank = 40;
  static constexpr const char* remark = "deepest point of each surface in the other body (Lin & Ng 1995)";
  static constexpr bool exact = false, certified = false;  // what it hands over may not be

  static Contact query(const Placed<shapes::Ellipsoid>& a, const Placed<shapes::Ellipsoid>& b, const Vec3d& offset,
                       const Options& options, Cache* cache);
  static Contact query(const Placed<shapes::Ellipse>& a, const Placed<shapes::Ellipse>& b, const Vec3d& offset,
                       const Options& options, Cache* cache);
};

}  // namespace contact
