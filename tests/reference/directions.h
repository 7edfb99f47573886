// Branch and bound over all directions, in double: where the greatest support separation can be, and a bound on it.
//
//   f(n) = n·w(n),   w(n) = d + x_B(−n) − x_A(n) + m n                                                          (1)
//   f(n) <= w(n')·n  for every n'  (f − m|n| is concave and homogeneous; m at most the sum of the least radii of
//   curvature, of which both bodies are shrunk)                                                                 (2)
//
// A cell of directions (a spherical triangle; an arc in the plane) is split until no cell's bound (2) is above the best
// value known by more than `tolerance`. No local maximum is missed, whatever the bodies.
#pragma once

#include <functional>
#include <vector>

#include "shapes/math/vec.h"

namespace reference {

struct Cell {
  shapes::Vec3d centre;  // unit
  double radius;         // of a ball about it that holds the cell
};

struct Directions {
  std::vector<Cell> cells;            // the largest f is in one of these
  std::vector<shapes::Vec3d> starts;  // the best directions known, no two near each other
  double best, bound;                 // best <= max f <= bound
};

Directions search(bool planar, double tolerance, const std::function<shapes::Vec3d(const shapes::Vec3d&)>& w);

}  // namespace reference
