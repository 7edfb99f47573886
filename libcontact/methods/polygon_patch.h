// Patch and depth of two convex loops that overlap by a corner, or several, of one behind a side of the other.
#pragma once

#include "libcontact/methods/polygon_pair.h"

namespace contact {

// A corner of `other` lies `gap` < 0 over a side of `self`, whose normal is `out`, its foot `from_start` along it.
struct SideView {
  const Loop &self, &other;
  SideContact at;
  Vec3d out;
  double gap, from_start;
};

// Where the overlap lies about that corner alone (side_overlap.h): the patch in closed form and, on request, the depth.
// False elsewhere; then nothing is set.
bool corner_patch(const SideView& side, double smaller, double up, const Options& options, Contact& c);

// To metres by `up`: the centroid of the area of the overlap and its spread along the side; on request the depth of
// overlap_depth.h, `smaller` being the size of the smaller body in units. Leaves what it has no answer for.
void polygon_patch(const SideView& side, double smaller, double up, const Options& options, Contact& c);

}  // namespace contact
