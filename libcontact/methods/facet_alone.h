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
  if (!(rise * reach > (4 * margin + 16 * epsilon * reach) * size)) return false;
  // tan(θ/2) where (2) takes over from (1)
  const bool shallow = 0.875 * reach >= 8 * d;
  const double t = shallow ? 8 : 0.875 * reach / d;
  // What is as near as F passes over F, at an angle of at most √(2 margin / d), where (1) holds.
  if (enclosed) return t * t * d > 2 * margin;
  const double w = shallow ? 1.0 / 65 : 1 / (1 + t * t), sine = 2 * t * w, cosine = (1 - t * t) * w;
  if (!(sine * (reach - d * t) > margin)) return false;
  const double along = dot(core, n);
  const Vec3d rest = core - along * n;
  const double square = dot(rest, rest);  // k_t²
  const double above = along * cosine + core_radius - (d + margin), turn = along * sine;
  if (!(above > 0 && above * above > square * (sine * sine))) return false;
  // and it grows from there to θ = π: turn + k_t cos θ <= 0
  const double bound = square * (cosine * cosine);
  return cosine <= 0 ? turn <= 0 || turn * turn <= bound : turn <= 0 && turn * turn >= bound;
}

}  // namespace contact
