// Polyhedra by the volume of their overlap.
//
//   V, x_c   volume and centroid of the overlap
//   S = Σ n·area over those parts of a's faces that lie in b; over b's faces in a the sum is −S                  (1)
//   method_overlap = V/|S|,   method_normal = S/|S|,   method_point = x_c                                       (2)
//
// S is minus the gradient of V as b moves, so that a force along S that depends on V alone comes from a potential. A
// face of a slab δ thick gives V/|S| = δ, a corner that is h deep in a face h/3. The gap is the support separation
// along the normal, with the bounds of polyhedron_measure.h. Apart, touching, or one inside the other (S = 0), `sat`
// answers.
//
// The overlap is made as a body (convex_overlap.h); cones from one of its corners over its faces add up to the volume.
// Source: Y. T. Feng, K. Han & D. R. J. Owen, Comput. Methods Appl. Mech. Eng. 205
// (2012) 169, for a force along the gradient of a volume. Cost: 0.8 us a pair of cubes, 2 us of 24 vertices, 5 us
// of 72. Accuracy: V to 64 eps L·area. Tests: tests/libcontact/approximate_polyhedra.cpp, contract.cpp.
#pragma once

#include "libcontact/contact.h"
#include "libcontact/export.h"

namespace contact {

struct CONTACT_API ClipVolume {
  static constexpr const char* name = "clip_volume";
  static constexpr int cost_rank = 60;
  static constexpr const char* remark = "volume of the overlap over its section (Feng et al. 2012)";
  static constexpr bool exact = false;

  static Contact query(const Placed<shapes::Polyhedron>& a, const Placed<shapes::Polyhedron>& b, const Vec3d& offset,
                       const Options& options, Cache* cache);
};

struct ClippedVolume {
  double volume = 0;  // V, m³
  Vec3d surface{};    // S, m²
  Vec3d moment{};     // ∫(x − x_c) × n dA over the same faces, m³
  Vec3d centroid{};   // x_c, relative to a's origin, m
};

// World axes. All zero when there is no overlap; S is zero when one lies inside the other.
CONTACT_API ClippedVolume clipped_volume(const Placed<shapes::Polyhedron>& a, const Placed<shapes::Polyhedron>& b,
                                         const Vec3d& offset);

}  // namespace contact
