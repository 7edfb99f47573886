// The signed gap of a pair in 50 digits, with a lower and an upper bound and the residual of its optimality condition.
//
// Where it comes from: every direction is searched in double with a bound (directions.h); what can be best is then
// settled in 50 digits. Corners against corners: all face normals and edge pairs that the search leaves, and the
// nearest points of all their features. Else Newton's method on the sphere, on the arc about each edge and in the
// plane: uphill in double first, and on in 50 digits only where double cannot tell that another direction is better.
//
//   lower = n·d − h_A(n) − h_B(−n)  for the n found: true whatever the way there                                (1)
//   residual r = distance of (lower n) from the set of differences of support points at n                       (2)
//   upper: corners: the nearest points apart, the complete list of axes overlapping;
//          else lower + r²/(2(ρ + lower)), ρ the sum of the least radii of curvature, where ρ + lower > 0       (3)
//          else the bound of the search over all directions; then `matched` is false                            (4)
//
// (4) is up to 1e-5 L wide where many directions are nearly as good. Cost: 0.2 to 100 ms, 1 s where many directions of
// many faces are nearly as good. Tests: tests/reference/reference.cpp.
#pragma once

#include "tests/reference/body.h"

namespace reference {

struct Answer {
  Real lower, upper;  // m
  Vector normal;      // unit
  Real residual;      // m
  bool matched;       // upper − lower below 1e-25 L
};

// n·d − h_A(n) − h_B(−n) in 50 digits; n need not be unit. Not for half-spaces.
Real separation(const Body& a, const Body& b, const Vec3d& offset, const Vec3d& n);

// In kind order; the second may be a half-space. Needs known(a), known(b), finite input.
Answer answer(const Body& a, const Body& b, const Vec3d& offset);

}  // namespace reference
