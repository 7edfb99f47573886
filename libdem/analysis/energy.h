// Energy of the bodies, and of a run and its record that of their contacts.
//   translational Σ ½ m v², rotational Σ ½ ω·I ω, potential −Σ m g·x                                              (1)
//   elastic: what contacts store, as the laws have it (report.cpp of libdem), from what a record keeps of each; with a
//   ledger (law.ledger) a running world (in-run analysis) also has what they have lost up to now by mechanism
// Velocities in a deforming box are those beside its flow (libdem/cell.h). Where gravity has a part along a periodic
// axis the potential energy jumps as a body is wrapped. Cost: linear. Accuracy: round-off. Tests:
// tests/libdem/analysis_energy.cpp.
#pragma once

#include "libdem/analysis/result.h"
#include "libdem/analysis/settings.h"

namespace dem::analysis {

struct BodyEnergies {  // J
  double translational = 0, rotational = 0, potential = 0;
};
BodyEnergies energies_of(const Snapshot& snapshot);
// Principal moments of inertia of a body, kg m².
Vec3d inertia_of(const Snapshot& snapshot, std::size_t body);

Result report_energy(const Snapshot& snapshot, const Settings& settings);

}  // namespace dem::analysis
