// One facet of the difference K = A − B of two convex bodies, space or plane, is nearer to the origin than all others.
//
// Let the foot d n of the origin lie in a facet F, at least ρ from its border, and let K hold a ball of radius r about
// k (the balls inside A and B). Then, for a direction at an angle θ to n,
//
//   h_K(θ) >= d cos θ + ρ sin θ >= d        while tan(θ/2) <= ρ/d                                              (1)
//   h_K(θ) >= k_n cos θ − k_t sin θ + r     k_n along n, k_t across it                                         (2)
//
// F is the nearest facet when (2) is above d wherever (1) is not: a proof from F alone, without a look at any other
// facet. Where the next vertices of A and B below F are farther than rounding can bridge, no other facet comes as near,
// and any complete search finds F: the proof may come from wherever it likes and the answer is the same, bit for bit.
// Tests: tests/libcontact/poly_proof.cpp, tests/libcontact/polygon_pair.cpp.
#pragma once

#include <algorithm>

#include "libcontact/contact.h"

namespace contact {

// How much farther than the nearest facet every other must be, per size: twice what a complete search may err by.
inline constexpr double proof_clearance = 64 * epsilon;

// (1) and (2) for a facet at depth d along n with its foot `reach` within its border, `rise` below it the next vertices
// of either body; core: k and r. `enclosed`: a closed surface within K is known that has nothing as near to the origin
// as this facet but parts of it; this stands for (1) and (2).
inline bool facet_is_alone(double d, double reach, double rise, const Vec3d& n, const Vec3d& core, double core_radius,
                           double size, bool enclosed = false) {
  const double margin = proof_clearance * size;
  if (!(d > margin && reach > 0x1p-20 * size)) return false;
  // Up to an angle of 2 margin / reach a facet could be as near as F; one with a vertex that F has not is not there.
  if (!(rise > 4 * margin * size / reach + 16 * epsilon * size)) return false;
  const double t = std::min(0.875 * reach / d, 8.0);  // tan(θ/2) where (2) takes over from (1)
  // What is as near as F passes over F, at an angle of at most √(2 margin / d), where (1) holds.
  if (enclosed) return t * t * d > 2 * margin;
  const double w = 1 / (1 + t * t), sine = 2 * t * w, cosine = (1 - t * t) * w;
  if (!(sine * (reach - d * t) > margin)) return false;
  const double along = dot(core, n);
  const double across = norm(core - along * n);
  return along * cosine - across * sine + core_radius > d + margin &&  // and it grows from there to θ = π:
         along * sine + across * cosine <= 0;
}

}  // namespace contact
