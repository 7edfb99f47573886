// The tables of --profile: the time of each phase, and by pair of kinds what became of the candidates.
#pragma once

#include "libdem/world.h"

namespace dem::cli {

void print_profile(const World& world, int threads);

}  // namespace dem::cli
