// Where the outlines of two ellipses cross: how often, and at which points.
//
//   g(u) = |e + Σu|² − 1,  u = (cos θ, sin θ) on B's outline, in the space where A is the unit circle            (1)
//   g′ = 0:  α/cos φ − β/sin φ = Δ        in the quadrants of the nearest and of the farthest point (there with −Δ) (2)
//            α/cos φ + β/sin φ = Δ        twice or never, in the quadrant across the long axis                    (3)
//   α = σ₁|e₁|,  β = σ₂|e₂|,  Δ = σ₁² − σ₂² >= 0
//
// g is monotone from one stationary point to the next. Each has its own bracket, in t = tan φ: (2) is monotone, (3) is
// concave with its top at t³ = β/α. So the changes of sign of g are all the crossings, and a zero at a stationary point
// is a tangency: the count is known without the roots of a quartic. A point counts as a zero below 8 eps of the terms
// of (1). Cost: 1.5 us. Tests: tests/libcontact/ellipse_crossings.cpp.
#pragma once

#include "libcontact/methods/unit_ball_space.h"

namespace contact {

struct EllipseCrossings {
  int count = 0;            // crossings and tangencies, 0 to 4
  int tangencies = 0;       // of these
  bool everywhere = false;  // one outline
  Vec3d point[4]{};         // from A's centre, units
};

EllipseCrossings ellipse_crossings(const UnitBallSpace& space);

}  // namespace contact
