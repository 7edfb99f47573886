// Wall meshes from a few numbers: panels, boxes, tubes and frusta, dies, the shell of a V-mixer.
//
// All are open or closed surfaces of triangles that mesh_from_triangles merges into flat facets; which way a facet is
// wound does not matter to contact (both sides of a mesh are solid). Round walls are polygons: the vertices of a tube
// lie on its radius, the middles of its facets at radius · cos(π / segments). Sines and cosines are those of
// shapes/math/trig.h: the same bits on every machine; lengths multiplied by a power of two give the same bits, scaled.
// Set-up only; throw Error with what is allowed. Tests: tests/shapes/mesh_generate.cpp.
#pragma once

#include <cstdint>

#include "shapes/export.h"
#include "shapes/mesh.h"

namespace shapes {

// The parallelogram corner, corner + side_1, corner + side_1 + side_2, corner + side_2 (m): one facet.
SHAPES_API Mesh make_panel(const Vec3d& corner, const Vec3d& side_1, const Vec3d& side_2);

// Faces of a box by the direction in which they lie.
struct BoxFaces {
  bool low[3] = {true, true, true};   // at lower.x, lower.y, lower.z
  bool high[3] = {true, true, true};  // at upper.x, upper.y, upper.z
};
// The faces of the box lower … upper (m) that are asked for, at least one.
SHAPES_API Mesh make_box_shell(const Vec3d& lower, const Vec3d& upper, const BoxFaces& faces);

// The side of a truncated cone about the axis base → top (centres of its ends, m) with `segments` flat facets, and its
// end discs where asked for. One radius may be 0: a cone; both the same: a tube.
SHAPES_API Mesh make_frustum(const Vec3d& base, const Vec3d& top, double base_radius, double top_radius,
                             std::uint32_t segments, bool base_closed, bool top_closed);

// A box-shaped cavity lower … upper (m), open at upper.z, in a table of width `flange` about it at that height; with or
// without its bottom (a punch may take its place).
SHAPES_API Mesh make_die(const Vec3d& lower, const Vec3d& upper, double flange, bool bottom_closed);

// The shell of a V-mixer: two round arms of `radius`, whose axes start at `centre` and run in the x–z plane at
// ± angle / 2 (rad) from z over `length` (m), joined in the plane x = centre.x; ends closed or open.
// Needs length > radius / tan(angle / 2): the arms must reach beyond their joint.
SHAPES_API Mesh make_v_shell(const Vec3d& centre, double angle, double radius, double length, std::uint32_t segments,
                             bool ends_closed);

// Area of a facet, m²; and of the whole surface as seen along the unit vector `axis`: sum of area · |normal · axis|,
// halved when the mesh is closed (front and back).
SHAPES_API double facet_area(const Mesh& mesh, std::uint32_t facet);
SHAPES_API double projected_area(const Mesh& mesh, const Vec3d& axis);
// Whether every edge has two facets.
SHAPES_API bool is_closed(const Mesh& mesh);

}  // namespace shapes
