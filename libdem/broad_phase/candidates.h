// The candidate list: every pair whose bounding spheres are nearer than the sum of the bodies' allowances
// (allowance.h), and every body near a wall or a facet. Sorted by key; the history of contacts is carried over by
// merging. A contact can only form between candidates as long as no body and no wall has moved by its allowance since
// the list was made.
#pragma once

#include "libdem/world.h"

namespace dem {

bool candidates_outdated(World& world, int threads);
void rebuild_candidates(World& world, int threads);

}  // namespace dem
