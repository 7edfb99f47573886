// Nearest point of an ellipsoid's surface to a point, inside or outside, from one scalar equation.
//
// With semi-axes a_i, smallest a_k, point y, and s = t + a_k² where foot + t·grad = y:
//   q_i(s) = a_i |y_i| / (s + a_i² − a_k²),   G(s) = Σ q_i² = 1,   s >= 0                                       (1)
//   foot_i = ± a_i q_i,   normal_i ∝ ± q_i / a_i,   signs of y_i                                               (2)
// s is counted from the last pole, so nothing cancels near the medial disc, and s >= 0 makes the foot the nearest point
// of all. 1/√G is concave and increasing in s: Newton's method on it from the left never passes the root. When y_k = 0
// and G(0+) < 1 the point lies on the medial disc: s = 0 and q_k = √(1 − G) on the positive side      (3)
//
// Source: the secular equation as in D. Eberly, Distance from a point to an ellipse, an ellipsoid (2013), solved here
// for 1/√G as in Moré & Sorensen, SIAM J. Sci. Stat. Comput. 4 (1983) 553. Validity: lengths scaled so that |y| and the
// semi-axes are of order 1 or less (|y_k| below 2^-60 counts as 0). Cost: 3 divisions and a root per step, 2–3 steps
// outside. Accuracy: the foot is the exact answer for a point within (4 eps + residual) |y| + 2^-60 of y. Tests:
// tests/libcontact/smooth_accuracy.cpp.
#pragma once

#include "shapes/math/vec.h"

namespace contact {

struct EllipsoidFoot {
  shapes::Vec3d foot, normal;  // body frame; normal unit, outward at the foot
  double residual;             // |√G − 1| where the iteration ended
  int iterations;
};

EllipsoidFoot nearest_on_ellipsoid(const shapes::Vec3d& semi_axes, const shapes::Vec3d& y);

// The other local minimum of the distance to the surface that an inner point may have, across the medial disc: with
// a_k < a_j the two smallest semi-axes, the root of (1) in −(a_j² − a_k²) < s < 0 that is nearest to 0. A minimum needs
// at most one negative coefficient 1 + t/a_i², so there is no third. False when there is none. Newton's method on G,
// convex there, from s = −z_k: monotone.
bool second_foot(const shapes::Vec3d& semi_axes, const shapes::Vec3d& y, EllipsoidFoot& foot);

}  // namespace contact
