// (1)–(4) of overlap_depth.h for what lies of a body under a flat region of a plane: columns of depth h. Sides of the
// region and of the body count as upright.
//   V = ∫h dA,  c, C from ∫h, ∫u h, ∫h²/2, ∫u² h, ∫u h²/2, ∫h³/3, …,   J n_f = n d/(2σ²V) ∫(r² − σ²) dA over the plane
#pragma once

#include "libcontact/methods/patch.h"
#include "libcontact/methods/short_list.h"

namespace contact {

class PlaneOverlap {
 public:
  // As DepthMoments::add.
  void add(const DepthPoint* polygon, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) points_.push_back(polygon[i]);
    ends_.push_back(static_cast<std::uint32_t>(points_.size()));
  }
  // From the body into the plane's solid, in the frame of `plane`. False where it is shallower than least_depth of
  // `size`, that of the body.
  bool slope(const PlaneFrame& plane, double size, OverlapDepth& out) const;

 private:
  template <class Visit>
  void each_triangle(Visit&& visit) const;  // visit(area, a, b, c)
  ShortList<DepthPoint, 32> points_;
  ShortList<std::uint32_t, 8> ends_;
};

}  // namespace contact
