// Stresses inside a regular array of bodies, for the validations that know them exactly.
#pragma once

#include <vector>

#include "libdem/validate/validation.h"

namespace dem::validate {

// Per id: whether the body's centre lies in the middle half of the box of all centres, along each axis. Call at the
// start.
std::vector<bool> in_the_middle(const World& world);

// Diagonal of Love's stress times the volume, from the contacts of some bodies (all of one size): force times unit
// normal, summed over the sides of contacts that belong to one of them, N. Ratios of its components are those of the
// stress; compression is positive.
Vec3d stress_of(const World& world, const std::vector<bool>& bodies);

}  // namespace dem::validate
