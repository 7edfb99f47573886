// Triangles of a mesh: corners, area, and which one of a facet holds a point.
#pragma once

#include <array>

#include "shapes/mesh.h"

namespace dem {

std::array<shapes::Vec3d, 3> corners_of(const shapes::Mesh& mesh, std::size_t triangle);
double area_of(const std::array<shapes::Vec3d, 3>& corners);  // m²
// The triangle of a facet that holds a point, or that it is least outside of.
std::size_t triangle_at(const shapes::Mesh& mesh, std::uint32_t facet, const shapes::Vec3d& x);

}  // namespace dem
