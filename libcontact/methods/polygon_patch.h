// Patch of two convex loops that overlap by a corner, or several, of one behind a side of the other.
#pragma once

#include "libcontact/methods/polygon_pair.h"

namespace contact {

// The corner of `other` lies `gap` < 0 over the side of `self`, whose normal is `out`, its foot `from_start` along it.
// Sets the centroid of the area of the overlap and its spread along the side, to metres by `up`; leaves the patch where
// there is no area.
void polygon_patch(const Loop& self, const Loop& other, const SideContact& at, const Vec3d& out, double gap,
                   double from_start, double up, Patch& patch);

}  // namespace contact
