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

// Of a body of that form; false as depth_slope.
bool corner_slope(const OverlapBody& body, double size, DepthSlope& out);
bool edges_slope(const OverlapBody& body, double size, DepthSlope& out);

}  // namespace contact
