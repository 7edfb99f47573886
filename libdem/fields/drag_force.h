// The drag of a scene's flow on its bodies, at the time of the positions: the velocity at hand is that of half a step
// ago, so with c = |F|/|u| there and F' all other forces
//   F = c (u_fluid − v − (F'/m + g) dt/2)/(1 + c dt/(2 m))                                              [N]     (1)
// is −c times the velocity at the end of the step to second order, and stable at any step. The diameter is that of the
// sphere of equal volume.
#pragma once

#include "libdem/world.h"

namespace dem {

// Adds (1) to the forces that sum_forces left, and keeps the sum in World::drag_force. Nothing without [drag].
void add_drag(World& world, int threads, double dt);

}  // namespace dem
