// How deep two bodies with flat faces lie in each other, as one number that a potential may be made of.
//
//   K   the overlap, of volume V, centroid c and second moment C = ∫_K (x − c)(x − c)ᵀ dV / V
//   n   the direction of the vector area S = ∫n dA over what lies of a's surface in b, from a to b
//   d = sqrt(12) σ,  σ² = 1/(nᵀ C⁻¹ n)  the variance of K along n that its tilt leaves                             (1)
//   σ² = C_nn − C_nt C_tt⁻¹ C_tn, with t across n                                                                  (2)
//   as b moves by u and turns by θ about x   dd = −J n_f·(u + θ × (p − x)) − J h n_f·θ                              (3)
//
// A slab δ thick has d = δ wherever its rim lies. As flat faces tilt by θ about an axis across their length L, d² = δ²
// + θ² L²/4: for a linear law two springs at the ends. A wedge pressed in by δ has d of 0.71 to 0.82 δ, a corner 0.67
// δ: J <= 1 tells how much less a point gives than a face. d is a continuous function of the pose, for no number or
// choice of points enters, and grows in proportion to the overlap: stiffness stays bounded at the first touch, unlike
// that of a law of V. A force J F(d) on b along n_f through p, with the couple J F h n_f, is the slope of a potential
// of d.
//
//   dd = d/(2 σ² V) ∫_B (r² − σ²) n·v dA + d/|S| ∮ (β·n_a)/|n_a × n_b| n_b·v dl,  v = u + θ × x                     (4)
//   with r(x) = n·(x − c) − β·(x − c), β = C_tt⁻¹ C_tn, over b's faces in a and over the rim between faces of a and b
//
// In the plane the same of areas, over sides and corners.
//
// Of a rounded polyhedron on a plane K is what its core has under the plane raised by the radius.
//
// Source: own; the potential's form follows Y. T. Feng, Comput. Methods Appl. Mech. Eng. 373 (2021) 113493, with d in
// the place of V. Validity: convex bodies, overlaps shallow against the bodies. Cost: 0.13 us
// a cube on a wall; of pairs 0.15 us where one corner or two edges make all of the overlap, six of ten contacts in
// beds, and 0.4 to 1 us elsewhere, the more faces the dearer. Accuracy: d to 64 eps L, L the pair's size. Test:
// tests/libcontact/overlap_depth.cpp
#pragma once

#include "libcontact/dispatch.h"

namespace contact {

// Whether overlap_depth answers two such kinds, in kind order.
CONTACT_API bool has_overlap_depth(shapes::Kind a, shapes::Kind b);

// Two bodies in kind order that overlap, `towards` the normal of their contact from a to b, unit. False: no answer for
// such a pair, an overlap of the size of rounding, or one lies inside the other.
CONTACT_API bool overlap_depth(const Body& a, const Body& b, const Vec3d& offset, const Vec3d& towards,
                               OverlapDepth& out);

}  // namespace contact
