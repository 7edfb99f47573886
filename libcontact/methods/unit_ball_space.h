// A pair of ellipsoids seen where the first one is the unit ball and the second one lies along the axes.
//
//   D_A⁻¹ R_Aᵀ R_B D_B = U Σ Vᵀ      singular values by one-sided Jacobi rotations                             (1)
//   x = R_A D_A U p,  p in that space: A is |p| = 1, B is |Σ⁻¹(p − e)| = 1, e = Uᵀ D_A⁻¹ R_Aᵀ d                (2)
//
// The problems of geometric_potential and perram_wertheim become one scalar equation there. Cost: 0.15 us. Accuracy:
// the answers of those methods are bounded by what their direction proves, whatever rounding does here.
#pragma once

#include "libcontact/methods/quadric_pair.h"

namespace contact {

struct UnitBallSpace {
  Mat3d to_world;  // R_A D_A U
  Mat3d turn;      // U, in A's frame
  Vec3d sigma;     // semi-axes of B; of a flat pair the third is the larger of the other two
  Vec3d e;         // centre of B
  bool valid;
};

UnitBallSpace unit_ball_space(const QuadricPair& pair);

}  // namespace contact
