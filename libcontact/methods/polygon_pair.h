// Two convex loops of the plane: the side and corner that answer for them, from all sides or from a cache.
//
//   f = lowest corner of the other over a side,   gap = max over the sides of both                            (1)
//   apart, the foot of that corner beyond the side: the direction between the nearest two corners too
//
// A side cannot win whose line the other's inner circle, or any corner of it, does not clear by more than the best so
// far: a few are looked at closely. A cached side with its corner stands where facet_alone.h proves that the search
// would find it. The patch is the area of the overlap: its centroid, and its spread along the side. It is counted from
// the foot of the deepest corner, so nothing cancels however small the overlap. Accuracy: 32 eps L. Cost: octagons
// 0.29 us, 0.17 us from the cache. Tests: tests/libcontact/polygon_pair.cpp.
#pragma once

#include "libcontact/methods/planar_outline.h"

namespace contact {

// A side of one loop under a corner of the other; what a cache keeps of an overlap.
struct SideContact {
  enum Kind : std::uint32_t { none, side_of_a, side_of_b };
  Kind kind = none;
  std::uint32_t side = 0, corner = 0;
};

// In units, metres by `up`: the extent of the pair, the circumradius of the smaller body.
struct PairSize {
  double extent, smaller, up;
};

// The answer. `known`: what may answer it, any content; set to what did when the bodies overlap. Out of range, the
// answer is left as it is.
void loop_pair(const Loop& a, const Loop& b, const PairSize& pair, const Options& options, SideContact& known,
               Contact& c);

}  // namespace contact
