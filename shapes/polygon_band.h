// Band of solid along a chain of straight sides in the plane z = 0: what a wall of such a chain is made of.
//
// The bodies are on the left of the way from vertex to vertex, the solid on the right, `depth` thick (m):
//
//   side k   from x_k to x_k+1, direction t_k, normal n_k = t_k turned by +90°, towards the bodies              (1)
//   back     b_k = x_k − depth (n_k−1 + n_k)/(1 + n_k−1·n_k) at a joint, x_k − depth n_k at an end              (2)
//   part     one for each side: x_k+1, x_k, b_k, b_k+1; neighbours meet in the seam x_k b_k                     (3)
//
// So inner joints never give a normal, and sides that continue each other are one: a vertex within 64 eps of the
// largest coordinate of the line through its neighbours is dropped. The seams are the cuts that polygon_parts.h would
// make of the outline of an open band; a closed chain makes a ring, counter-clockwise about the bodies, clockwise about
// its own hole. A chain of one side makes a convex polygon.
//
// Refused (shapes::Error): too few vertices, neighbours that are one point, a chain that turns back on itself, a side
// too short for its depth, bands of two sides that cross or touch. Lengths multiplied by a power of two give the same
// bits, scaled. Cost: sides², for set-up only. Tests: tests/shapes/polygon_band.cpp.
#pragma once

#include <span>

#include "shapes/export.h"
#include "shapes/polygon.h"

namespace shapes {

SHAPES_API Polygon band_along(std::span<const Vec3d> chain, double depth, bool closed);

}  // namespace shapes
