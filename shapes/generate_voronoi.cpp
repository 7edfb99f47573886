#include <algorithm>
#include <cmath>

#include "shapes/generate.h"
#include "shapes/geometry.h"
#include "shapes/math/random.h"
#include "shapes/polyhedron_build.h"

namespace shapes {
namespace {

constexpr std::size_t block = 64;

// The cell of points[i] about that point. Planes halfway to the nearest images; more of them until no other image can
// reach the cell: one is cut off only by images nearer than twice its farthest corner.
Polyhedron cell_of(std::span<const Vec3d> points, std::size_t i) {
  std::vector<std::pair<double, Vec3d>> around;  // squared distance, way
  for (std::size_t j = 0; j < points.size(); ++j)
    for (int a = -1; a <= 1; ++a)
      for (int b = -1; b <= 1; ++b)
        for (int c = -1; c <= 1; ++c) {
          if (i == j && a == 0 && b == 0 && c == 0) continue;
          const Vec3d d = points[j] - points[i] + Vec3d{double(a), double(b), double(c)};
          around.emplace_back(dot(d, d), d);
        }
  std::stable_sort(around.begin(), around.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<HalfSpace> planes;
  for (std::size_t use = std::min<std::size_t>(60, around.size());; use = std::min(2 * use, around.size())) {
    planes.clear();
    for (std::size_t k = 0; k < use; ++k) planes.push_back({around[k].second, 0.5 * around[k].first});
    // The box of the point's own images bounds the cell while few neighbours are looked at.
    for (int k = 0; k < 3; ++k)
      for (const double side : {-1.0, 1.0}) {
        HalfSpace own{{}, 0.5};
        own.normal[k] = side;
        planes.push_back(own);
      }
    Polyhedron p = polyhedron_from_half_spaces(planes, Frame::as_given);
    if (use == around.size() || 4 * p.circumradius * p.circumradius < around[use].first) return p;
  }
}

double wrapped(double x) { return x - std::floor(x); }

}  // namespace

std::vector<VoronoiCell> voronoi_cells(std::span<const Vec3d> points) {
  std::vector<VoronoiCell> cells;
  for (std::size_t i = 0; i < points.size(); ++i) cells.push_back({points[i], cell_of(points, i)});
  return cells;
}

std::vector<Polyhedron> voronoi_grains(std::size_t count, int relaxations, std::uint64_t seed, std::uint64_t stream) {
  std::vector<Polyhedron> grains;
  for (std::uint64_t b = 0; grains.size() < count; ++b) {
    Random random(seed, stream, b);
    std::vector<Vec3d> points;
    for (std::size_t i = 0; i < block; ++i) {
      const double x = random.uniform(), y = random.uniform(), z = random.uniform();
      points.push_back({x, y, z});
    }
    for (int r = 0; r < relaxations; ++r) {
      const std::vector<VoronoiCell> cells = voronoi_cells(points);
      for (std::size_t i = 0; i < block; ++i) {
        const Vec3d x = points[i] + cells[i].cell.mass.centre;
        points[i] = {wrapped(x.x), wrapped(x.y), wrapped(x.z)};
      }
    }
    for (std::size_t i = 0; i < block && grains.size() < count; ++i) {
      const Polyhedron p = polyhedron_from_points(cell_of(points, i).vertices, Frame::principal);
      grains.push_back(scaled(p, 0.5 / equivalent_radius(p.mass.volume)));
    }
  }
  return grains;
}

}  // namespace shapes
