// Cutting a simple polygon into convex parts.
//
//   from every reflex corner, in order, along the bisector of the angle that is left of it, to the nearest edge or
//   earlier cut                                                                                                  (1)
//
// One part more than there are reflex corners, at most. A cut that ends within rounding of a corner ends in it. The
// parts do not depend on units (powers of two). Throws shapes::Error where two edges are so near to each other that
// rounding hides what is between them. Cost: reflex corners × vertices, for set-up only.
// Tests: tests/shapes/polygon_parts.cpp.
#pragma once

#include "shapes/polygon.h"

namespace shapes {

// Fills parts and seams of a polygon whose vertices, normals, offsets and convexity are there; lengths near 1.
void cut_into_parts(Polygon& p);

// What builders that make parts share: the circle about a part's vertices, and every length times 2^exponent.
void add_circle(Polygon::Part& part);
void to_units(Polygon& p, int exponent);

}  // namespace shapes
