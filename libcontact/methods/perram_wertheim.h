// Ellipsoids and ellipses by the Perram–Wertheim contact function: one variable decides overlap at any aspect ratio.
//
//   F(s) = s(1 − s) dᵀ [(1 − s) S_A + s S_B]⁻¹ d,   S = R D² Rᵀ,   μ² = max of F over 0 < s < 1                  (1)
//   F′(t) = Σ e_i² (1 − σ_i² t²)/(1 + σ_i² t)²,   t = s/(1 − s); decreasing, zero between 1/max σ and 1/min σ   (2)
//   normal ∝ [(1 − s) S_A + s S_B]⁻¹ d,   point (1 − s) S_A [(1 − s) S_A + s S_B]⁻¹ d                            (3)
//   method_overlap = |d| (1/μ − 1)                                                                             (4)
//
// μ is the factor by which both bodies grow about their centres until they touch: below 1 they overlap. (4) is how far
// B must go along the line of centres until they touch: with parallel bodies up to (q + 1/q)/2 times the least
// translation at aspect ratio q, even as that vanishes. f(n) = n·d (1 − 1/μ) along (3) is what `gap` reports, right to
// the square of the overlap.
//
// Source: J. W. Perram & M. S. Wertheim, J. Comput. Phys. 58 (1985) 409, for (1); (2) in the axes of unit_ball_space.h,
// our own. Solved by Newton's method within a bracket. Validity: any pair; coincident centres are handed over. Cost:
// 0.35–0.85 us. Accuracy: bounds of quadric_pair.h, certified. Tests: tests/libcontact/approximate_ellipsoids.cpp,
// contract.cpp.
#pragma once

#include "libcontact/contact.h"
#include "libcontact/export.h"

namespace contact {

struct CONTACT_API PerramWertheim {
  static constexpr const char* name = "perram_wertheim";
  static constexpr int cost_rank = 30;
  static constexpr const char* remark = "common growth factor of both bodies, one variable";
  static constexpr bool exact = false, certified = false;  // what it hands over may not be

  static Contact query(const Placed<shapes::Ellipsoid>& a, const Placed<shapes::Ellipsoid>& b, const Vec3d& offset,
                       const Options& options, Cache* cache);
  static Contact query(const Placed<shapes::Ellipse>& a, const Placed<shapes::Ellipse>& b, const Vec3d& offset,
                       const Options& options, Cache* cache);
};

}  // namespace contact
