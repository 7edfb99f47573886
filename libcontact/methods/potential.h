// Potential particles against round bodies and walls: Newton's method on the unit sphere for the direction of greatest
// support separation.
//
//   f(n) = n·d − h_A(n) − h_B(−n),   gap = max f                                                                (1)
//   w = d − x_A + x_B (support points from their own origins),   r = w − f n   (tangential)                    (2)
//   (K_A + K_B + f) s = r,   K = tangent-plane matrix of radii of curvature,   n <- (n + s)/|n + s|             (3)
//   f(n) <= gap <= f + |r|² / max(|w| + f, 2 (m + f)),   m = ρ_A + ρ_B                                          (4)
//   gap <= |distance of the inner balls' centres| − their radii                                                 (5)
//
// as for ellipsoids (support_newton.h), with ρ the radius of a ball that rolls inside the body. h, x and K of a
// potential particle come from its pieces of ellipsoids (shapes/potential_support.h) with a bound on h that holds for
// any of its answers; K jumps from piece to piece, which a step that is cut until f does not fall gets over. Deeper
// than m there may be several maxima: the search starts again from the planes' normals of both bodies and keeps the
// best; gap_upper is then the best known value, `certified` only when (5) closes the interval.
//
// A plane: one support point. A facet of a mesh: its plane where the deepest point lies over it, else the edges and
// ends that it owns (facet.h); there deeper than ρ: not certified.
//
// Validity: any depth. Accuracy: 32 eps L plus the width of (4). Cost with 4 to 8 planes: 4 us with a sphere, 11 us a
// pair, 140 us deeper than m, 0.5 us a plane, 0.6–1.5 us to a cached proof of separation.
// Tests: tests/libcontact/contract.cpp, potential.cpp.
#pragma once

#include "libcontact/contact.h"

namespace contact {

struct Potential {
  static constexpr const char* name = "potential_newton";
  static constexpr int cost_rank = 20;
  static constexpr const char* remark = "certified while the overlap is below the sum of least radii of curvature";
  template <class A, class B>
  static constexpr bool certified = std::is_same_v<B, shapes::Plane>;

  static Contact query(const Placed<shapes::Sphere>& a, const Placed<shapes::PotentialParticle>& b, const Vec3d& offset,
                       const Options& options, Cache* cache);
  static Contact query(const Placed<shapes::Ellipsoid>& a, const Placed<shapes::PotentialParticle>& b,
                       const Vec3d& offset, const Options& options, Cache* cache);
  static Contact query(const Placed<shapes::PotentialParticle>& a, const Placed<shapes::PotentialParticle>& b,
                       const Vec3d& offset, const Options& options, Cache* cache);
  static Contact query(const Placed<shapes::PotentialParticle>& a, const Placed<shapes::Plane>& b, const Vec3d& offset,
                       const Options& options, Cache* cache);
  static Contact query(const Placed<shapes::PotentialParticle>& a, const Placed<shapes::Mesh>& b, const Vec3d& offset,
                       const Options& options, Cache* cache);
};

}  // namespace contact
