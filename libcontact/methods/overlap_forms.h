// d of overlap_depth.h and its slope for the two overlaps that most contacts have, in closed form.
//
// A corner cut off by one plane: a cone of height δ along n over a polygon of area A, centroid g and second moment M
// about it; w = g less the foot of the tip.
//   κ = wᵀ M⁻¹ w / 16,  σ² = 3/80 δ²/(1 + κ),  β = −δ/16 M⁻¹ w/(1 + κ),  d = J δ,  J² = 0.45/(1 + κ)            (1)
//   the force is J n, at the mean of y weighted by r² − σ² over the polygon, moved by δ β                       (2)
// Two edges through each other, δ deep along n: e the part of self's in other, f that of other's in self, their middles
// α e and β f from their common perpendicular.
//   d = J δ,  J² = 0.6/(1 + 2 α² + 2 β²)                                                                         (3)
//   the force is J n along the common perpendicular, with the couple −δ ∂J/∂θ: α, β depend on the rotation alone (4)
//
// Source: own, from (1)–(4) there. Validity: no other plane has a part in the overlap; the body's `form` says so. Cost:
// 30 ns. Accuracy: as the sums over any body. Tests: tests/libcontact/overlap_depth.cpp
#pragma once

#include "libcontact/methods/overlap_moments.h"

namespace contact {

// The first: corners[0] is the tip, the others are about n in order, which runs from the plane to the tip, `depth`
// apart.
struct CornerOverlap {
  static constexpr std::uint32_t cap = 9;  // more than nearly all tips have, for each is cleared
  Vec3d corner[cap];
  std::size_t count;
  Vec3d n;
  double depth;
};
// The second: self's edge runs from corner 0 to 1 and other's from 2 to 3; outward normals of self's faces at corners 2
// and 3, of other's at 0 and 1.
struct EdgesOverlap {
  Vec3d corner[4], normal[4];
};

// Where self has one vertex under a face of other, which holds its foot and what is `reach` about it, and that is all
// of the overlap; and where it is that of two edges. False when this does not follow from these features alone: other
// faces are not looked at. In self's frame.
bool corner_alone(const PolyhedronPair& pair, std::uint32_t face, std::uint32_t vertex, double reach,
                  CornerOverlap& out);
bool edges_alone(const PolyhedronPair& pair, const EdgesMeeting& meeting, std::uint32_t edge_of_self,
                 std::uint32_t edge_of_other, EdgesOverlap& out);

// False as depth_slope.
bool corner_slope(std::span<const Vec3d> corners, const Vec3d& n, double depth, double size, DepthSlope& out);
bool edges_slope(const Vec3d* corner, const Vec3d* normal, double size, DepthSlope& out);

}  // namespace contact
