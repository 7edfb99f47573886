// Building bodies of parts.
//
// What is done with the parts, in this order:
//   parts inside another part are dropped;
//   polyhedra whose union is convex (volume of the hull = volume of the union, to 1e-9) become one polyhedron: a body
//     that is cut into convex pieces is the whole body, however it was cut;
//   polyhedra grow through their inner faces, as far as they stay convex and in the body; what is then inside another
//     part is dropped. The pieces of an L, however it was cut, become its two bars.
// Mass: exact to rounding for polyhedra, overlapping or not, and for parts of any kind that do not overlap; overlapping
// spheres to 1e-10 (areas of the slices exact, adaptive Gauss–Kronrod across them), other overlaps to 1e-5.
// Lengths multiplied by a power of two give the same bits, scaled. Cost: set-up only; milliseconds for tens of parts.
// Tests: tests/shapes/compound.cpp, tests/shapes/compound_mass.cpp.
#pragma once

#include <span>
#include <variant>

#include "shapes/compound.h"
#include "shapes/ellipsoid.h"
#include "shapes/export.h"
#include "shapes/sphere.h"

namespace shapes {

struct CompoundPart {
  std::variant<Sphere, Ellipsoid, Polyhedron> solid;
  Pose pose;  // of the solid's own frame; position m
};

// Throws shapes::Error for no parts and for a part that is not finite. Parts need not hang together. A result of one
// part is that sphere, ellipsoid or polyhedron in its own frame: centre 0, no rotation.
SHAPES_API Compound make_compound(std::span<const CompoundPart> parts);

}  // namespace shapes
