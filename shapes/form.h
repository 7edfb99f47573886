// Form of a convex body: length, width, thickness and sphericity, as tables of scanned grains give them.
//   L  the longest distance of two points of the surface, along e                                                 [m]
//   W  the longest distance of two points whose connection is perpendicular to e, along f                         [m]
//   T  the longest distance of two points whose connection is parallel to g = e x f                               [m]
//   ψ = π^(1/3) (6V)^(2/3) / A, 1 for a sphere; here its cube 36 π V²/A³, which needs no root                   (1)
// Source: Bullard and Garboczi, Powder Technology 249 (2013) 241. For a convex body L >= W; a box has L along its
// diagonal. Exact to rounding. Cost: O(v²) for L, O(v (edges + section²)) for W, O(edges²) for T; tens of microseconds
// for 20 vertices. Tests: tests/shapes/form.cpp.
#pragma once

#include "shapes/export.h"
#include "shapes/polyhedron.h"

namespace shapes {

struct SHAPES_API Form {
  double length = 0, width = 0, thickness = 0;  // m
  Vec3d along{}, across{}, through{};           // unit: e, f, g
  double area = 0, volume = 0;                  // m², m³
  double sphericity_cubed() const;              // (1)
  double sphericity() const;                    // its root; error 2 ulp
};

SHAPES_API Form form_of(const Polyhedron& p);

}  // namespace shapes
