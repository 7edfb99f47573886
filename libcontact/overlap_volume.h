// Overlap of two bodies as a volume, with all that a force needs that comes from a potential of it.
//
//   V   volume of the overlap; of bodies of the plane its area                                              [m³, m²]
//   S = ∫n dA   over what lies of a's surface in b, n out of a; over b's surface in a it is −S              [m², m] (1)
//   G = ∫x × n dA   over the same; any point x of a line of action and h with                               [m³, m²]
//       G = x × S + h S                                                                                             (2)
//   as b moves by u and turns by θ about a's origin   dV = −(S·u + G·θ)                                             (3)
//
// A force F(V) S on b along (2), with the couple F h S, is the slope of a potential of V, in translation and rotation.
// h is zero where the rim of the overlap lies in a plane, and for bodies of the plane. x is the point of the line next
// to the overlap's centroid. Where no body holds the other, S points from a to b.
//
//   spheres   caps of height h_a = δ(2 R_b − δ)/(2d), h_b = δ(2 R_a − δ)/(2d):  V = Σ π/3 h²(3R − h), |S| = π h(2R − h)
//   discs     segments of these heights:  V = Σ R²(α − sin α cos α), cos α = 1 − h/R;  |S| = 2 sqrt(h(2R − h))
//   ellipsoid, ellipse on a flat wall   the unit ball or disc on it, in the space where it is that
//   polyhedra, polygons                 clipped (methods/clip_volume.h, clip.h); on a flat wall by it
//
// Source: Y. T. Feng, Comput. Methods Appl. Mech. Eng. 373 (2021) 113493. Cost: 20 ns of spheres, of polyhedra 0.5
// to 0.8 us a pair of cubes, 2 us of 24 vertices, 5 us of 72.
// Accuracy: 1e-14 of L³ (L²), L the smaller body. Test: tests/libcontact/overlap_volume.cpp
#pragma once

#include "libcontact/dispatch.h"

namespace contact {

struct OverlapVolume {
  double volume = 0;   // V
  double section = 0;  // |S|
  Vec3d normal{};      // S/|S|
  Vec3d point{};       // x, relative to a's origin, m
  double screw = 0;    // h, m
};

// Whether overlap_volume answers two such kinds, in kind order.
CONTACT_API bool has_overlap_volume(shapes::Kind a, shapes::Kind b);

// Two bodies in kind order that overlap. False: no answer for such a pair, no overlap, or one lies inside the other.
// A polygon that is not convex gives the sum over all regions of the overlap.
CONTACT_API bool overlap_volume(const Body& a, const Body& b, const Vec3d& offset, OverlapVolume& out);

struct VolumeSection {
  double volume = 0, section = 0;  // m³, m²; of discs m², m
};
// Of the overlap δ > 0 of round bodies, the second one infinite when it is flat.
CONTACT_API VolumeSection sphere_overlap(double overlap, double radius_a, double radius_b);
CONTACT_API VolumeSection disc_overlap(double overlap, double radius_a, double radius_b);

}  // namespace contact
