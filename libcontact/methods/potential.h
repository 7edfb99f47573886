// Potential particles against round bodies, polyhedra and walls: Newton's method on the unit sphere for the direction
// of greatest support separation.
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
// A polyhedron, rounded or not: the search of polyhedron_search.h over its own outward directions, that is
//   f(n) = min over its vertices v of φ_v(n),  φ_v(n) = n·(d − v) − h_B(−n),  less the rounding radius          (6)
//   gap <= signed distance of x from the polyhedron − ρ, for the centre x of any ball of radius ρ in the body   (7)
// with the ball that touches the surface at the deepest point, which closes the interval while the particle is no
// deeper in the core than ρ, and where the deepest point lies under the face that wins; else not certified. Deeper than
// ρ: both bodies' normals and many directions on the arcs of edges and in the cones of vertices, each followed to a
// local maximum; missed once in 1200 random deep pairs.
//
// Validity: any depth. Accuracy: 32 eps L plus the width of (4). Cost with 4 to 8 planes: 4 us with a sphere, 11 us a
// pair, 140 us deeper than m, 0.5 us a plane, 0.6–1.5 us to a cached proof of separation; with a polyhedron of 8 to 24
// vertices 30 us, 3 ms deeper than ρ, 0.4 us to a cached proof.
// Tests: tests/libcontact/contract.cpp, potential.cpp.
#pragma once

#include "libcontact/contact.h"
#include "libcontact/export.h"

namespace contact {

struct CONTACT_API Potential {
  static constexpr const char* name = "potential_newton";
  static constexpr int cost_rank = 20;
  static constexpr const char* remark = "certified while the overlap is below the sum of least radii of curvature";
  template <class A, class B>
  static constexpr bool certified = std::is_same_v<B, shapes::Plane>;

  static Contact query(const Placed<shapes::Sphere>& a, const Placed<shapes::PotentialParticle>& b, const Vec3d& offset,
                       const Options& options, Cache* cache);
  static Contact query(const Placed<shapes::Ellipsoid>& a, const Placed<shapes::PotentialParticle>& b,
                       const Vec3d& offset, const Options& options, Cache* cache);
  static Contact query(const Placed<shapes::Polyhedron>& a, const Placed<shapes::PotentialParticle>& b,
                       const Vec3d& offset, const Options& options, Cache* cache);
  static Contact query(const Placed<shapes::RoundedPolyhedron>& a, const Placed<shapes::PotentialParticle>& b,
                       const Vec3d& offset, const Options& options, Cache* cache);
  static Contact query(const Placed<shapes::PotentialParticle>& a, const Placed<shapes::PotentialParticle>& b,
                       const Vec3d& offset, const Options& options, Cache* cache);
  static Contact query(const Placed<shapes::PotentialParticle>& a, const Placed<shapes::Plane>& b, const Vec3d& offset,
                       const Options& options, Cache* cache);
  static Contact query(const Placed<shapes::PotentialParticle>& a, const Placed<shapes::Mesh>& b, const Vec3d& offset,
                       const Options& options, Cache* cache);
};

}  // namespace contact
