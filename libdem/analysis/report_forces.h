// Forces of contacts: their distributions, the strong network and its graph (force_network.h, force_chains.h).
//
//   P(f/<f>) of normal forces f of contacts that push, and of tangential forces over their own mean; density
//   mobilised friction ft/fn of contacts that push; at most the coefficient of friction where the law is Coulomb's
//   participation (Σ f)² / (N Σ f²): share of the contacts that bear the load, 1 where all forces are equal
// Cost: O(contacts log contacts). Tests: tests/libdem/analysis_forces.cpp.
#pragma once

#include "libdem/analysis/pairs.h"
#include "libdem/analysis/settings.h"

namespace dem::analysis {

Result report_forces(const Snapshot& snapshot, const Settings& settings);

}  // namespace dem::analysis
