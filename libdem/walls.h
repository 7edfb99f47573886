// Motion of walls: prescribed as a function of time, or by a servo that keeps a force.
#pragma once

#include "libdem/world.h"

namespace dem {

// Puts walls where they are at world.time() and takes away those whose time has come. A servo moves by one step.
void move_walls(World& world);
// The motion begins now, from where the wall is; the wall stays where it is.
void start_motion(Wall& wall, double time);
void stop_motion(Wall& wall, double time);
// What the bodies in touch with each servo wall oppose to its speed, after the forces have been summed.
void sum_resistance(World& world);

}  // namespace dem
