// Outlets: bodies whose centre is behind an outlet's plane are deleted and counted.
#pragma once

#include "libdem/world.h"

namespace dem {

void remove_behind_outlets(World& world);

}  // namespace dem
