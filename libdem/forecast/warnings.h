// What a run of the scene would regret: one sentence each.
#pragma once

#include <string>
#include <vector>

#include "libdem/forecast/cost.h"
#include "libdem/forecast/loads.h"
#include "libdem/world.h"

namespace dem::forecast {

// The step against its limits, stiffness against the loads, bodies that nothing holds.
std::vector<std::string> dynamic_warnings(const World& world, const Loads& loads,
                                          const std::vector<PairForecast>& pairs);
// Numbers that no scene in SI units is likely to have.
std::vector<std::string> unit_hints(const World& world);
// Time, memory and disk that are out of proportion.
std::vector<std::string> cost_warnings(const Cost& cost);

}  // namespace dem::forecast
