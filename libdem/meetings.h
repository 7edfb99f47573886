// Pairs that go through lanes from now on (Met in contacts.h). Of round bodies those that meet for the first time since
// the list of candidates was made: a step looks for them among those of the pairs that are near, the awake ones
// (sleep.h), and from then on they go through the kernels in every step, until the next rebuild, whether they touch or
// not. Of smooth bodies those that touched a step ago, until the awake are listed anew.
#pragma once

#include "libdem/world.h"

namespace dem {

// Per bin, and last the groups: the awake pairs of round bodies that have not met yet. Cost: 2 ns for each.
std::vector<Tally> meet(World& world, int threads);

// Lists what counts of both bodies of record k anew (Contacts::active); the order stays that of the partners.
void relist(Contacts& c, std::uint32_t k);

}  // namespace dem
