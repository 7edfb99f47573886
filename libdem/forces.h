// Contact forces of all candidates, and their sums per particle and per wall.
#pragma once

#include "libdem/integrators/bodies.h"
#include "libdem/world.h"

namespace dem {

// Answers every candidate, gives each touching contact its slot, sums what acts on each wall (dt > 0: also over time,
// wall_load.h), and does with the bodies what `then` says: their sums at least, in order of partner; no atomics, the
// same bits on any thread count. dt > 0 advances the histories; dt = 0 evaluates them. Throws RunError where a contact
// asks for a shorter step or bodies pass through each other (contact_checks.h).
BodyTally compute_forces(World& world, int threads, double dt, const BodyStep& then = {.sum = true});
// Throws RunError when the step has passed the stability limit of a touching contact by itself. Before a list of
// candidates is dropped; compute_forces does so for contacts that come or go.
void check_contacts(const World& world);

}  // namespace dem
