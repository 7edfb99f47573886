// Ellipsoid–ellipsoid: Newton's method on the unit sphere for the direction of greatest support separation.
//
//   f(n) = n·d − |D_A R_Aᵀ n| − |D_B R_Bᵀ n|,   gap = max f                                                     (1)
//   w = d − x_A − x_B (support points from their own centres),   r = w − f n   (tangential)                    (2)
//   (K_A + K_B + f) s = r,   K = tangent-plane matrix of radii of curvature,   n <- (n + s)/|n + s|             (3)
//   f(n) <= gap <= f + |r|² / max(|w| + f, 2 (m + f)),   m = c_A²/a_A + c_B²/a_B                                (4)
//   gap <= |d| − c_A − c_B                              (balls inside the bodies; c, a: smallest, largest axis)  (5)
//
// (4): with m + f > 0 both bodies are convex bodies plus balls of radius c²/a (Blaschke's rolling theorem), whose
// shrunk remainders are still apart: a convex problem with one maximum. Its second denominator holds there, the first
// where f > 0. Deeper than m there may be several maxima: the search starts again from the principal axes of both
// bodies and keeps the best; then gap_lower is proven and gap_upper is the best known value, `certified` only when (5)
// closes the interval.
//
// The last step is applied to first order to n, gap and witness points, which then satisfy point_b − point_a = gap·n to
// rounding even on discs so flat that the points themselves are loose. A step that loses separation is cut; a matrix
// (3) that is not positive definite is shifted until it is. Starts are always cold: n ∝ (S_A + S_B)⁻¹ d with S = R D²
// Rᵀ.
//
// Source: W. Blaschke, Kreis und Kugel (1916), for the theorem; own derivation for (2)–(5).
// Validity: any aspect ratio to 1e6, containment and coincident centres. Above 1e5, with an overlap within a few
// percent of m, (4) may be wide although the gap is right. Cost: 0.3–0.6 us, 3–6 steps; 0.1 us to a proof of
// separation; about 5 us deeper than m. Accuracy: 16 eps (|d| + circumradii) plus the width of (4). Deeper than m a
// largest maximum was missed in 0 of 1000 random pairs up to aspect ratio 100 and 1 of 250 at 1e4. Tests:
// tests/libcontact/smooth_accuracy.cpp.
#pragma once

#include "libcontact/contact.h"
#include "libcontact/export.h"

namespace contact {

struct CONTACT_API SupportNewton {
  static constexpr const char* name = "support_newton";
  static constexpr int cost_rank = 10;
  static constexpr const char* remark = "certified while the overlap is below the sum of least radii of curvature";
  static constexpr bool certified = false;

  static Contact query(const Placed<shapes::Ellipsoid>& a, const Placed<shapes::Ellipsoid>& b, const Vec3d& offset,
                       const Options& options, Cache* cache);
};

}  // namespace contact
