// Events of a scene: each happens once, at the end of the first step at which it is due.
#pragma once

#include "libdem/world.h"

namespace dem {

// Before the first step: reads the conditions, puts what waits for an event to rest.
void prepare_events(World& world);
// At the end of a step: judges every condition on the state as it is, then acts in the order of the scene; ends the run
// when run.until holds.
void apply_events(World& world);
// After the forces: bodies must not lie deep inside a wall that has just been inserted. Throws RunError.
void check_inserted_walls(World& world);

}  // namespace dem
