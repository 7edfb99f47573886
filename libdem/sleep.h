// Candidates that sleep: pairs so far apart that a step need not even look at them.
//
// A pair is known to be apart while the sum of its travels is below its bound (coherence.h). No travel grows by more in
// a step than the way of the farthest body, nor of a wall than that of the farthest wall; their sum over steps is W. A
// pair for which
//   T_a + T_b + 2 w < until                                                                                       (1)
// now is thus apart for as long as W grows by less than w, and sleeps so long. w is what some steps at the present pace
// make. A sleeping pair would be refused by its bound if it were looked at, so no bit depends on who sleeps.
#pragma once

#include "libdem/world.h"

namespace dem {

// Sum of the travels of the two that meet in place r of a bin, m.
inline double travels(const World& world, const Bin& bin, std::size_t r) {
  const Contacts& c = world.contacts;
  const std::uint32_t b = bin.b_index[r];
  return c.travel[bin.a_index[r]] + (bin.wall ? world.walls[b].travel : c.travel[b]);
}

// Once a step, after bodies and walls have moved: lists anew who is awake, where the list has run out. Cost: (1) for
// every candidate, every 16 steps or so.
void wake(World& world, int threads);

}  // namespace dem
