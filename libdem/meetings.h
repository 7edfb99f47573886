// Pairs of round bodies that meet for the first time since the list of candidates was made. A step looks for them among
// those of the pairs that are near, the awake ones (sleep.h), and adds them to the pairs that have met (Met in
// contacts.h); those then go through the kernels in every step, until the next rebuild, whether they touch or not.
#pragma once

#include "libdem/world.h"

namespace dem {

// Per bin, and last the groups: the awake pairs of round bodies that have not met yet. Cost: 2 ns for each.
std::vector<Tally> meet(World& world, int threads);

// Lists what counts of both bodies of record k anew (Contacts::active); the order stays that of the partners.
void relist(Contacts& c, std::uint32_t k);

}  // namespace dem
