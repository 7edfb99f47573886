// Velocities of the bodies: mean, fluctuation, their distribution.
//   v̄ = Σ m v/Σ m,  T = ⟨(v − v̄)²⟩/d over the bodies, d the dimension (granular temperature, m²/s²)               (1)
//   spins: ω̄ = mean over the bodies, T_ω = ⟨(ω − ω̄)²⟩/(3; in the plane 1)                                         (2)
// over all bodies, or those whose centres lie in the settings' region. T holds the gradients of a flow too: per box,
// and without them, see `boxes`. Velocities in a deforming box are those beside its flow. Cost: linear. Accuracy:
// round-off. Tests: tests/libdem/analysis_energy.cpp.
#pragma once

#include "libdem/analysis/result.h"
#include "libdem/analysis/settings.h"

namespace dem::analysis {

struct Velocities {
  std::size_t count = 0;
  Vec3d mean{}, mean_spin{};                     // m/s; rad/s
  double temperature = 0, spin_temperature = 0;  // m²/s²; rad²/s²
  double mean_speed = 0, largest_speed = 0;      // m/s
};
Velocities velocities_of(const Snapshot& snapshot, const Settings& settings);

Result report_velocity(const Snapshot& snapshot, const Settings& settings);

}  // namespace dem::analysis
