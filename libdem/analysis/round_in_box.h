// Volume of a ball in a box, area of a disc in a rectangle: closed forms.
//
// With R = 1, a, b, c >= 0 distances of planes from the centre, A, B, C the areas that the part beyond all of them has
// in these planes, and ω the solid angle of its round side:
//   beyond one plane     ω = 2π(1 − a)
//   beyond two           ω = 2α_ab − aβ_a − bβ_b                     a² + b² < 1                                  (1)
//   beyond three         ω = α_ab + α_bc + α_ca − π − aβ_a − bβ_b − cβ_c     a² + b² + c² < 1                     (2)
//   volume               (ω − aA − bB − cC)/3                                                                     (3)
// α: angle between two circles on the sphere, cos α_ab = ab/√((1 − a²)(1 − b²)); β: angle that the part's arc spans in
// its plane (theorem of Gauss and Bonnet). A box is a signed sum of such parts, at most 27, of which those near the
// ball are not zero. Accuracy: 1e-15 of the ball. Cost: 10 ns a plane, 0.1 us a corner.
// Tests: tests/libdem/analysis_cut_solid.cpp.
#pragma once

#include "shapes/math/vec.h"

namespace dem::analysis {

using shapes::Vec3d;

// Of the ball (of the disc: x and y alone) about `centre` in the box from lower to upper.
double ball_in_box(const Vec3d& centre, double radius, const Vec3d& lower, const Vec3d& upper);
double disc_in_box(const Vec3d& centre, double radius, const Vec3d& lower, const Vec3d& upper);
// Of the unit ball (disc) below a plane (line) that lies `height` over its centre, < 0: under it.
double unit_ball_below(double height);
double unit_disc_below(double height);

}  // namespace dem::analysis
