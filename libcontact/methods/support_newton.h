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
// rounding even on discs so flat that the points themselves are loose. Two searches, of which the second takes what the
// first leaves: the branch-free one of kernels/ellipsoid_search.h, for pairs up to aspect ratio 512 that overlap by
// less than m, and ellipsoid_climb.h with every safeguard. A chunk of pairs runs through the first in lanes, with the
// bits of `query` whatever the instruction set and whatever stands beside a pair. Starts are cold, n ∝ (S_A + S_B)⁻¹ d
// with S = R D² Rᵀ, unless `warm_start` asks for the normal in the cache.
//
// Source: W. Blaschke, Kreis und Kugel (1916), for the theorem; own derivation for (2)–(5).
// Validity: any aspect ratio to 1e6, containment and coincident centres. Above 1e5, with an overlap within a few
// percent of m, (4) may be wide although the gap is right. Cost (bench_pairs, EPYC of 2022, overlap 1e-3): one by one
// 0.3 us at aspect ratio 2, 0.45 us at 10; in chunks with AVX-512 0.08 and 0.13 us, AVX2 0.11 and 0.17 us, warm 0.08
// and 0.09 us; 0.04 us to a cached proof of separation; about 5 us deeper than m. Accuracy: 16 eps (|d| + circumradii)
// plus the width of (4). Deeper than m a largest maximum was missed in 0 of 1000 random pairs up to aspect ratio 100
// and 1 of 250 at 1e4. Tests: tests/libcontact/smooth_accuracy.cpp, ellipsoid_kernels.cpp.
#pragma once

#include "libcontact/export.h"
#include "libcontact/methods/method.h"

namespace contact {

struct CONTACT_API SupportNewton {
  static constexpr const char* name = "support_newton";
  static constexpr int cost_rank = 10;
  static constexpr const char* remark = "certified while the overlap is below the sum of least radii of curvature";
  static constexpr bool certified = false;

  static Contact query(const Placed<shapes::Ellipsoid>& a, const Placed<shapes::Ellipsoid>& b, const Vec3d& offset,
                       const Options& options, Cache* cache);
  static void query_chunk(KindPair<shapes::Ellipsoid, shapes::Ellipsoid>, std::size_t n, const Body* a, const Body* b,
                          const Vec3d* offset, const Options& options, Cache* cache, Contact* out);
};

}  // namespace contact
