// Stiffness of linear laws from the speed at which impacts are to last as long as those of Hertz:
//   kn = π²/2.868265699² (m*^½ E*² R* v)^(2/5)                                      [N/m]   (9.22)
// The constant in print, 1.2024, is that of a factor rounded to 2.94; the exact one is 1.19967. kt = kn/κ as in (9.23).
#pragma once

#include "libdem/world.h"

namespace dem {

// (9.22). SI units; all > 0.
double reference_stiffness(double young_eff, double radius_eff, double mass_eff, double speed);

// (9.22) and (9.23) of a pair of materials whose moduli have been mixed.
void set_reference_stiffness(PairParameters& pair, double radius_eff, double mass_eff, double speed);

// Sets the stiffness of every pair of materials that no [[material_pair]] gives: with m* and R* of the largest body of
// each material, those that are still to come included; of a material that only walls are made of, with a wall.
void set_reference_stiffness(World& world);

}  // namespace dem
