// Potential particle (Houlsby 2009; Boon, Houlsby & Utili 2013): the convex body f(x) <= 0 with
//   f = (1 − k)[Σ⟨aᵢ·x − dᵢ⟩² / r² − 1] + k[|x|² / R² − 1],  ⟨y⟩ = max(y, 0)                                        (1)
#pragma once

#include <vector>

#include "shapes/math/vec.h"

namespace shapes {

struct PotentialParticle {
  static constexpr const char* name = "potential_particle";
  struct Plane {
    Vec3d normal;   // aᵢ, unit
    double offset;  // dᵢ, m
  };
  std::vector<Plane> planes;
  double k{};  // 0 < k <= 1: 1 is the sphere of radius R
  double r{};  // m, > 0: how far the faces are set off
  double R{};  // m, > 0
};

}  // namespace shapes
