// Building convex polyhedra: from points, half-spaces or files, and the generated solids.
//
// Every builder checks its input and throws shapes::Error with the name, the value and the allowed range. Input
// multiplied by a power of two gives the same bits, scaled, as far as the exponent range goes (inertia, m⁵: sizes
// 2^±200). Vertices are numbered in the order of the input; loops start at their lowest vertex; faces are sorted by
// their loops. Apart from that numbering the body does not depend, to the bit, on the order in which the points come.
// Accuracy: coordinates as given (bit for bit in Frame::as_given; in the principal frame to 6 eps of the largest one);
// normals a few eps of (size / face height); mass properties a few eps. Cost: Qhull's n log n, for set-up only. Tests:
// tests/shapes/hull.cpp, half_spaces.cpp, files.cpp, grains.cpp, mass.cpp.
#pragma once

#include <array>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "shapes/export.h"
#include "shapes/polyhedron.h"

namespace shapes {

struct SHAPES_API Error : std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct HalfSpace {
  Vec3d normal;   // need not be unit
  double offset;  // normal·x <= offset
};

// Convex hull of points, by Qhull: n >= 4, not coplanar. Points nearer than 64 eps of the largest coordinate are one,
// and neighbouring faces are one when all their vertices are that near to the plane of the larger face
// (shapes/convex.h).
SHAPES_API Polyhedron polyhedron_from_points(std::span<const Vec3d> points, Frame frame);
// Intersection of half-spaces, any order, redundant ones allowed; refused when empty or unbounded. Vertices are
// numbered in lexicographic order of their coordinates; each is where its three most independent planes meet.
SHAPES_API Polyhedron polyhedron_from_half_spaces(std::span<const HalfSpace> planes, Frame frame);
// OFF, OBJ or STL file (shapes/surface_file.h); the surface must be closed, oriented alike and convex, otherwise it is
// refused by edge or face. Convex: no face lies inside the hull of the vertices by more than 1e-9 of the size, or by
// more than one unit of the last decimal printed where that is coarser (but never more than 1e-5 of the size). The body
// is the exact hull.
SHAPES_API Polyhedron polyhedron_from_file(const std::string& path, Frame frame);

SHAPES_API Polyhedron make_box(const Vec3d& size);                                // full extents; frame identity
SHAPES_API Polyhedron make_prism(int sides, double circumradius, double height);  // axis z, first corner on +x
enum class Platonic { tetrahedron, cube, octahedron, dodecahedron, icosahedron };
SHAPES_API Polyhedron make_platonic(Platonic solid, double circumradius);
// The same polyhedron with every length multiplied by s > 0.
SHAPES_API Polyhedron scaled(const Polyhedron& p, double s);

}  // namespace shapes
