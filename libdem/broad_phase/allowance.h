// How far each body and wall may go before the list of candidates is made anew: pairs are listed that are nearer than
// the sum of theirs. With run.skin it is half the skin for all. Else each gets besides
// what its speed takes it in a number of steps, so that a few fast bodies do not make the list of slow ones long or
// short-lived; the number is tuned at each rebuild by what the list was like. Nothing that a run computes depends on
// any of it.
#pragma once

#include "libdem/world.h"

namespace dem {

// Sets Contacts::allowance and Wall::allowance for the list that is to be made; first the steps that it is to last.
void choose_allowances(World& world);

// Steps that the next list is to last at the least cost, of what the last one was like: made to last `steps`, with
// `listed` pairs. A rebuild costs R, and a step s for each pair that does not touch; if their number grows as steps do,
// R / n + s (listed − touching) n / steps is least at
//   n = sqrt(R steps / (s (listed − touching)))                                                                    (1)
double best_steps(double bodies, double listed, double touching, double steps);

}  // namespace dem
