#include "libdem/mesh_triangles.h"

#include <algorithm>
#include <limits>

namespace dem {

using shapes::Vec3d;

namespace {

// How far inside a triangle a point of its plane is: the least of its barycentric coordinates.
double depth_in(const std::array<Vec3d, 3>& corner, const Vec3d& x) {
  const Vec3d n = cross(corner[1] - corner[0], corner[2] - corner[0]);
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3d &a = corner[k], &b = corner[(k + 1) % 3];
    least = std::min(least, dot(n, cross(b - a, x - a)));
  }
  return least / dot(n, n);
}

}  // namespace

std::array<Vec3d, 3> corners_of(const shapes::Mesh& mesh, std::size_t triangle) {
  const std::uint32_t* t = &mesh.triangles[3 * triangle];
  return {mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]};
}

double area_of(const std::array<Vec3d, 3>& corner) {
  return 0.5 * norm(cross(corner[1] - corner[0], corner[2] - corner[0]));
}

std::size_t triangle_at(const shapes::Mesh& mesh, std::uint32_t facet, const Vec3d& x) {
  const auto& f = mesh.facets[facet];
  std::size_t best = mesh.facet_triangles[f.first_triangle];
  if (f.triangle_count == 1) return best;
  double deepest = -std::numeric_limits<double>::infinity();
  for (std::uint32_t i = 0; i < f.triangle_count; ++i) {
    const std::size_t t = mesh.facet_triangles[f.first_triangle + i];
    const double depth = depth_in(corners_of(mesh, t), x);
    if (depth > deepest) {
      deepest = depth;
      best = t;
    }
  }
  return best;
}

}  // namespace dem
