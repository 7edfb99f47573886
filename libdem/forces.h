// Contact forces of all candidates, and their sums per particle and per wall.
#pragma once

#include "libdem/world.h"

namespace dem {

// Answers every candidate and gives each touching contact its slot. dt > 0 advances the histories; dt = 0 evaluates
// them.
void compute_forces(World& world, int threads, double dt);
// Throws RunError when the step has passed the stability limit of a touching contact by itself. Before a list of
// candidates is dropped; compute_forces does so for contacts that come or go.
void check_contacts(const World& world);
// Slots → force and torque of each particle and wall, in order of partner; no atomics, the same bits on any thread
// count.
void sum_forces(World& world, int threads);

}  // namespace dem
