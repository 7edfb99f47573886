// A small packed bed of a scene's bodies, made to see what a step costs once the bodies lie on each other: copies of
// them on a lattice in a periodic box that shrinks, slowly damped, until they hold each other.
//
// For measuring only: no load is reproduced, and a scene's own bed may be looser or denser (tested: equal spheres come
// to 0.55 to 0.66 of solid with 4 to 6 contacts each). The same scene gives the same sample.
#pragma once

#include "libdem/world.h"

namespace dem::forecast {

struct Packing {
  World world;                   // periodic, without walls and gravity
  double solid_fraction = 0;     // –
  double contacts_per_body = 0;  // pairs that touch, per body (half the coordination number)
  double records_per_body = 0;   // candidates, per body
  bool packed = false;           // false: the box could not shrink far enough
};

// Cost: some hundred steps of 200 to 3000 bodies, fewer the dearer they are: about a second.
Packing packed_sample(const World& world);
// A single body, alone: what a step costs that does nothing.
World lone_body(const World& world);

}  // namespace dem::forecast
