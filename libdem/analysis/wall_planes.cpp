#include "libdem/analysis/wall_planes.h"

#include <cmath>

namespace dem::analysis {

using shapes::HalfSpace;

std::vector<HalfSpace> planes_of(const SnapshotWall& wall, const Snapshot& s) {
  std::vector<HalfSpace> planes;
  if (s.count() == 0) return planes;
  const auto add = [&](const Vec3d& normal, double offset) {
    const Vec3d n = rotate(wall.orientation, normal);
    planes.push_back({n, offset + dot(n, wall.position)});
  };
  if (is_half_space(wall.kind))
    planes.push_back({-wall.normal(), -dot(wall.normal(), wall.position)});
  else if (wall.polygon)
    for (std::size_t k = 0; k < wall.polygon->normals.size(); ++k)
      add(wall.polygon->normals[k], wall.polygon->offsets[k]);
  else if (wall.mesh)
    for (const auto& f : wall.mesh->facets) add(f.normal, f.offset);
  for (HalfSpace& h : planes) {
    if (dot(h.normal, s.position[0]) > h.offset) h = {-h.normal, -h.offset};
    for (const Vec3d& x : s.position)
      if (dot(h.normal, x) > h.offset) return {};
  }
  return planes;
}

std::vector<HalfSpace> side_of(const std::vector<HalfSpace>& planes) {
  constexpr std::size_t round = 6;  // sides of a prism that stands for a cylinder
  std::vector<HalfSpace> side;
  for (std::size_t k = 1; k < planes.size(); ++k) {
    const Vec3d axis = cross(planes[0].normal, planes[k].normal);
    if (!(norm(axis) > 1e-3)) continue;
    std::vector<HalfSpace> along;
    for (const HalfSpace& h : planes)
      if (std::fabs(dot(h.normal, axis)) < 1e-6 * norm(axis)) along.push_back(h);
    if (along.size() >= round && along.size() > side.size()) side = along;
  }
  return side.empty() ? planes : side;
}

}  // namespace dem::analysis
