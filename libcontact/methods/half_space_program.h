// The largest ball that fits between the planes of two bodies, by a linear program in four variables.
//
//   max t   subject to   a_i·x + t <= b_i   for every plane of both bodies, a_i unit                           (1)
//   dual:   min Σ λ_i b_i   subject to   Σ λ_i a_i = 0,  Σ λ_i = 1,  λ >= 0                                     (2)
//
// t > 0: the bodies overlap, and (x, t) is a ball in both; t < 0: n = Σ over a of λ_i a_i separates them. The dual
// simplex method: four constraints with λ >= 0 are a basis, whose (x, t) bounds t from above; the most violated
// constraint enters, the one whose λ would first turn negative leaves, and t falls. It starts from a tetrahedron about
// the pair. Neither the planes are copied nor anything allocated: those of b are asked in their own frame.
//
//   min over i of (b_i − a_i·x) <= t* <= Σ λ_i b_i          proven from x and from λ, whatever rounding did        (3)
//
// Source: C. Boon, G. Houlsby & S. Utili, Comput. Geotech. 44 (2012) 73, for (1); the solver our own. Cost: 6–15
// pivots, each one pass over the planes and 60 ns. Tests: tests/libcontact/approximate_polyhedra.cpp.
#pragma once

#include "libcontact/methods/polyhedron_pair.h"

namespace contact {

struct HalfSpaceOptimum {
  bool converged = false;
  int pivots = 0;
  Vec3d x{};            // units, frame of the pair
  double lower, upper;  // of t*, (3)
  Vec3d normal{};       // Σ over a of λ_i a_i; not unit, zero when the ball touches planes of one body alone
};

// Without `pair.other` its place is taken by a wall: the half-space below the plane through `offset` whose normal is
// the third column of `other_to_self`.
HalfSpaceOptimum largest_ball(const PolyhedronPair& pair, double size);

// The analytic centre of the overlap: the x with the largest Π (b_i − a_i·x), from a point inside all planes. False
// when Newton's method, damped, has not found it in 60 steps.
bool analytic_centre(const PolyhedronPair& pair, Vec3d& x, int& steps);

}  // namespace contact
