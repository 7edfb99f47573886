// Walls with prescribed motion.
#pragma once

#include "libdem/world.h"

namespace dem {

// Puts every wall where its motion has it at the world's time, with its velocity; removes walls whose time has come.
void move_walls(World& world);

}  // namespace dem
