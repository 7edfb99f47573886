// Polygon surfaces from files: OFF and OBJ by the reader here, STL (ASCII and binary) by Assimp.
//
// Assimp keeps coordinates in single precision, which would cost OFF and OBJ half of their digits; so those are read
// here, every number to the nearest double. STL is single precision by its own format (binary), and taken as such in
// both. Read: vertices and faces; comments and blank lines anywhere; OBJ `i/t/n` and negative indices; colours after
// OFF faces. Tests: tests/shapes/files.cpp.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "shapes/math/vec.h"

namespace shapes {

struct Surface {
  std::vector<Vec3d> vertices;                    // identical ones joined
  std::vector<std::vector<std::uint32_t>> faces;  // polygons of at least three different vertices
  double resolution = 0;  // m: unit of the last decimal printed (STL: of the last bits of a float)
};

// Throws shapes::Error with file, line and value: missing file, unknown format, not a number, bad index, no faces.
Surface read_surface(const std::string& path);

}  // namespace shapes
