// Building polygons from outlines and points.
//
// Every builder checks its input and throws shapes::Error. Points nearer than 64 eps of the largest coordinate are one,
// and a vertex that near to the line through its neighbours is dropped. Lengths multiplied by a power of two give the
// same bits, scaled. Cost: n² for the test of simplicity, for set-up only. Tests: tests/shapes/polygon.cpp.
#pragma once

#include <span>
#include <vector>

#include "shapes/export.h"
#include "shapes/polygon.h"

namespace shapes {

// Outline in either sense, z ignored; refused when it crosses or touches itself, or encloses no area.
SHAPES_API Polygon polygon_from_outline(std::span<const Vec3d> outline);
// One outline from simple polygons in either sense, in any order, that cover a region without overlap, corner on edge
// allowed; refused when they overlap, are apart, meet only in a point or enclose a hole. Corners within 1e-12 of the
// largest coordinate are one: the first in order of (x, y).
SHAPES_API Polygon polygon_from_pieces(std::span<const std::vector<Vec3d>> pieces);
// Convex hull.
SHAPES_API Polygon polygon_hull(std::span<const Vec3d> points);
// Equal sides, first corner on +x.
SHAPES_API Polygon make_regular_polygon(int sides, double circumradius);

// The same polygon about its centroid; unchanged when that is at the origin to round-off.
SHAPES_API Polygon centred(const Polygon& p);

SHAPES_API double perimeter(const Polygon& p);  // m

}  // namespace shapes
