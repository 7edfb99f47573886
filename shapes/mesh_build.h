// Building wall meshes from triangles or files (OFF, OBJ, STL): vertices are welded, coplanar neighbours merged to
// facets.
//
// Vertices within 1e-12 of the mesh's size are one; a triangle belongs to a neighbour's facet when it lies within 1e-10
// of the size of that facet's plane (the plane of the facet's largest triangle), whichever way it is wound. The facet's
// normal is that of its total area, on the side of its lowest triangle, about which all its triangles are then wound;
// its offset is the area-weighted mean. Facets are numbered by their lowest triangle, edges by their owner. Real edges
// of the same two facets that run straight on through a vertex are one edge. Input multiplied by a power of two gives
// the same bits, scaled. Cost: n log n. Tests: tests/shapes/mesh.cpp.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "shapes/export.h"
#include "shapes/mesh.h"
#include "shapes/polyhedron_build.h"

namespace shapes {

// vertices and triangles as given (indices three per triangle). Refused: NaN, an index out of range, a triangle without
// area (height below 1e-12 of the size), an edge shared by more than two triangles.
SHAPES_API Mesh mesh_from_triangles(std::span<const Vec3d> vertices, std::span<const std::uint32_t> triangles);
// Polygons must be convex; coordinates are multiplied by scale (m per file unit). Also refused: what read_surface
// refuses.
SHAPES_API Mesh mesh_from_file(const std::string& path, double scale = 1.0);

}  // namespace shapes
