// Convex solids as loose polygons, for cutting: inner machinery of bodies of parts.
//
// Lengths near 1 (a power of two has been taken out); points within cell_tolerance of a plane lie on it.
// Tests: tests/shapes/compound.cpp.
#pragma once

#include <vector>

#include "shapes/mass.h"
#include "shapes/polyhedron.h"

namespace shapes::convex {

inline constexpr double cell_tolerance = 1e-13;

using Outline = std::vector<Vec3d>;  // a convex polygon
struct Cell {                        // counter-clockwise from outside; empty: nothing
  std::vector<Outline> faces;
};

Cell cell_of(const Polyhedron& p);
// The part with normal·x <= offset.
Cell part_below(const Cell& cell, const Vec3d& normal, double offset);
Outline part_below(const Outline& polygon, const Vec3d& normal, double offset);
Cell intersection(Cell cell, const Polyhedron& p);
// cell less p, as convex cells that do not overlap.
std::vector<Cell> difference(const Cell& cell, const Polyhedron& p);
// What `parts` add to one another, as convex cells that do not overlap: the first whole, the second less the first, …
std::vector<Cell> disjoint_cells(const std::vector<const Polyhedron*>& parts);

double volume_of(const Cell& cell);
MassProperties mass_of(const Cell& cell);
double area_of(const Outline& polygon);

}  // namespace shapes::convex
