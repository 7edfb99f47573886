// (1)–(4) of overlap_depth.h for an overlap that has been made as a body.
#pragma once

#include "libcontact/methods/overlap_body.h"

namespace contact {

// Lengths and axes of the body's frame.
struct DepthSlope {
  double depth = 0;  // d
  Vec3d force{};     // −∂d/∂u: what a unit of force of d puts on other
  Vec3d moment{};    // −∂d/∂θ about `centroid`
  Vec3d centroid{};
  // In space: V, and the variances of K across its vector area, along t and u.
  double volume = 0, tt = 0, uu = 0, tu = 0;
  Vec3d t{}, u{};
};

// As libcontact gives it.
OverlapDepth line_of_action(const DepthSlope& slope);

// An overlap shallower than this of the smaller body has lost half its digits to rounding: its depth is the gap's.
inline constexpr double least_depth = 0x1p-26;

// `size`: of the smaller body. False where the overlap is shallower than that, or its vector area has no direction.
bool depth_slope(const OverlapBody& body, double size, DepthSlope& out);

}  // namespace contact
