#include "libdem/analysis/single_cell.h"

#include <algorithm>
#include <cmath>

#include "libdem/analysis/cut_solid.h"

namespace dem::analysis {

namespace {

struct Plane {  // normal·(x − seed) <= height
  Vec3d normal;
  double height;
};

double reach_of(const CutSolid& cell) {
  double square = 0;
  for (const Vec3d& v : cell.corners()) square = std::max(square, dot(v, v));
  return std::sqrt(square);
}

}  // namespace

double single_cell_volume(const CellBox& box, const Seeds& seeds, const std::vector<std::uint8_t>& left_out,
                          std::size_t i) {
  const Vec3d size = box.upper - box.lower;
  Vec3d at = seeds.position[i], lower{}, upper{};
  std::array<int, 3> images{};
  for (std::size_t k = 0; k < 3; ++k) {
    const int axis = static_cast<int>(k);
    images[k] = box.periodic[k] ? 1 : 0;
    if (box.periodic[k]) at[axis] -= std::floor((at[axis] - box.lower[axis]) / size[axis]) * size[axis];
    lower[axis] = box.periodic[k] ? -0.5 * size[axis] : box.lower[axis] - at[axis];
    upper[axis] = box.periodic[k] ? 0.5 * size[axis] : box.upper[axis] - at[axis];
  }
  CutSolid cell = CutSolid::box(lower, upper);
  for (const shapes::HalfSpace& h : box.planes) cell.cut(h.normal, h.offset - dot(h.normal, at));
  const double reach = reach_of(cell), radius = seeds.radius.empty() ? 0 : seeds.radius[i];
  std::vector<Plane> planes;
  for (std::size_t j = 0; j < seeds.position.size(); ++j) {
    if (!left_out.empty() && left_out[j] != 0) continue;
    const double other = seeds.radius.empty() ? 0 : seeds.radius[j];
    Vec3d base = seeds.position[j] - at;
    for (int axis = 0; axis < 3; ++axis)
      if (images[static_cast<std::size_t>(axis)] != 0)
        base[axis] -= std::nearbyint(base[axis] / size[axis]) * size[axis];
    for (int x = -images[0]; x <= images[0]; ++x)
      for (int y = -images[1]; y <= images[1]; ++y)
        for (int z = -images[2]; z <= images[2]; ++z) {
          const Vec3d d = base + scaled(size, Vec3d{1.0 * x, 1.0 * y, 1.0 * z});
          const double length = norm(d);
          if (!(length > 0)) continue;  // itself
          const double height = 0.5 * (length + (radius - other) * (radius + other) / length);
          if (height < reach) planes.push_back({d * (1 / length), height});
        }
  }
  std::sort(planes.begin(), planes.end(), [](const Plane& a, const Plane& b) { return a.height < b.height; });
  double rest = reach;
  for (std::size_t k = 0; k < planes.size() && planes[k].height < rest && !cell.empty(); ++k) {
    cell.cut(planes[k].normal, planes[k].height);
    if (k % 8 == 7) rest = reach_of(cell);
  }
  return cell.volume();
}

}  // namespace dem::analysis
