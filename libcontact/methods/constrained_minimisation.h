// Contact of convex bodies as a constrained minimisation.
//
// Polyhedra, as half-spaces a_i·x <= b_i of both bodies:
//   method_overlap = t, the optimum of   max t  subject to  a_i·x + t <= b_i                                    (1)
//   method_point   the analytic centre of the overlap, argmax Σ log(b_i − a_i·x)                                (2)
//   method_normal  Σ over a of λ_i a_i, from the multipliers of (1)                                             (3)
//
// t is the radius of the largest ball in the overlap, not its depth: half of it between two faces, less in a corner.
// (1) decides overlap, with a certificate either way (half_space_program.h). (2) moves continuously with the bodies,
// and also with faces far from the contact. Apart, (3) separates the bodies, and the point is that of (1). The gap is
// the support separation along the normal, with the bounds of polyhedron_measure.h. One body inside the other, or no
// end of (1): `sat` answers, or the status is not_converged.
//
// A plane is one half-space more, its normal the answer's, and nothing is handed over.
//
// Potential particles and spheres, f < 0 inside:
//   x = argmin f_A + f_B  subject to  f_A = f_B                                                                (4)
//     = argmin s f_A + (1 − s) f_B  for the weight s at which f_A = f_B at x                                    (5)
//   method_point x, normal ∇f_A/|∇f_A| there, method_overlap what both bodies cut from the normal line through x (6)
// (5): f_A − f_B falls as s grows, so that s has a bracket; each minimum is Newton's, of a strictly convex function.
// Apart, method_overlap is minus the support separation. Bounds as in potential.h, (4) and (5).
//
// A plane is the limit of a steep f_B: x = argmin f_A on the plane, where ∇f_A is along its normal, and method_overlap
// what the particle alone reaches beyond x along the normal line                                              (7)
//
// Source: C. Boon, G. Houlsby & S. Utili, Comput. Geotech. 44 (2012) 73, for (1) and (2); Powder Technol. 248 (2013)
// 94, for (4). Cost: 2–3 us a pair of cubes, 6 us of 12 vertices, 17–20 us of 50 (7 us apart);
// 5 us a pair of potential particles. Accuracy: t to 32 eps L. Tests:
// tests/libcontact/approximate_polyhedra.cpp, approximate_potential.cpp, contract.cpp.
#pragma once

#include "libcontact/contact.h"
#include "libcontact/export.h"

namespace contact {

struct CONTACT_API ConstrainedMinimisation {
  static constexpr const char* name = "constrained_minimisation";
  static constexpr int cost_rank = 50;
  static constexpr const char* remark = "largest ball and analytic centre; least equal potential (Boon et al.)";
  static constexpr bool exact = false;

  template <class A, class B>  // what a potential particle hands over may not be
  static constexpr bool certified = std::is_same_v<B, shapes::Polyhedron> || std::is_same_v<B, shapes::Plane>;

  static Contact query(const Placed<shapes::Polyhedron>& a, const Placed<shapes::Polyhedron>& b, const Vec3d& offset,
                       const Options& options, Cache* cache);
  static Contact query(const Placed<shapes::Polyhedron>& a, const Placed<shapes::Plane>& b, const Vec3d& offset,
                       const Options& options, Cache* cache);
  static Contact query(const Placed<shapes::Sphere>& a, const Placed<shapes::PotentialParticle>& b, const Vec3d& offset,
                       const Options& options, Cache* cache);
  static Contact query(const Placed<shapes::PotentialParticle>& a, const Placed<shapes::PotentialParticle>& b,
                       const Vec3d& offset, const Options& options, Cache* cache);
  static Contact query(const Placed<shapes::PotentialParticle>& a, const Placed<shapes::Plane>& b, const Vec3d& offset,
                       const Options& options, Cache* cache);
};

}  // namespace contact
