// dem law --fit: parameters of a law from measured impacts.
//
// Measured is a CSV file of impacts, one a row: speed and angle_deg (or impact_angle_deg), or normal_speed and
// tangential_speed, spin (what is left out is that of [impact]); and of each what there is of restitution,
// tangential_restitution, rebound_angle_deg (of the centre), duration (s). A cell may be empty. Least is
//   Σ ((got − measured)/scale)²,  scale: 1 for restitutions, 1 rad for angles, the measured one for durations    (1)
// by DIRECT-L over the allowed range, then subplex (NLopt).
#pragma once

#include <string>

#include "libdem/law_driver/spec.h"

namespace dem::cli {

int fit_law(const law_driver::LawTest& test, const std::string& file);

}  // namespace dem::cli
