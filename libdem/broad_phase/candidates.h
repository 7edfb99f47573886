// The candidate list: every pair whose bounding spheres are nearer than the skin, and every body near a wall or a
// facet. Sorted by key; the history of contacts is carried over by merging. A contact can only form between candidates
// as long as no body has moved by half the skin since the list was made (and no wall by the other half).
#pragma once

#include "libdem/world.h"

namespace dem {

bool candidates_outdated(World& world, int threads);
void rebuild_candidates(World& world, int threads);

}  // namespace dem
