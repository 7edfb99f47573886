// Extreme vertex of a polyhedron along a direction, over the padded coordinate arrays: the inner loop of every
// polyhedron query. Lanes run over vertices; ties go to the lowest index, so the answer does not depend on the lane
// count.
#pragma once

#include <cstddef>
#include <cstdint>
#include <experimental/simd>

#include "shapes/polyhedron.h"

namespace contact {

struct Extreme {
  double value;         // dot(direction, vertex), in the units of the geometry
  std::uint32_t index;  // of the vertex
};

// min over i of direction·(x_i, y_i, z_i); n is a positive multiple of shapes::polyhedron_padding. About n/2 ns with
// two lanes.
inline Extreme lowest(const double* x, const double* y, const double* z, std::size_t n,
                      const shapes::Vec3d& direction) {
  using Lanes = std::experimental::native_simd<double>;
  using std::experimental::element_aligned;
  constexpr std::size_t width = Lanes::size();
  static_assert(shapes::polyhedron_padding % width == 0);
  const Lanes nx = direction.x, ny = direction.y, nz = direction.z;
  const auto value_at = [&](std::size_t i) {
    return nx * Lanes(x + i, element_aligned) + ny * Lanes(y + i, element_aligned) + nz * Lanes(z + i, element_aligned);
  };
  // Two independent minima (one where a pack fills the padding): the loop is bound by throughput, not by the latency of
  // the comparison. Indices are counted in doubles, lane by lane.
  constexpr std::size_t second = width < shapes::polyhedron_padding ? width : 0;
  constexpr std::size_t step = second + width;
  const Lanes count([](auto lane) { return static_cast<double>(lane); });
  Lanes best = value_at(0), at = count, here = count;
  Lanes best2 = value_at(second), at2 = count + static_cast<double>(second);
  for (std::size_t i = step; i < n; i += step) {
    here += static_cast<double>(step);
    const Lanes value = value_at(i);
    where(value < best, at) = here;
    best = min(value, best);
    if constexpr (second > 0) {
      const Lanes value2 = value_at(i + second);
      where(value2 < best2, at2) = here + static_cast<double>(second);
      best2 = min(value2, best2);
    }
  }
  where(best2 < best || (best2 == best && at2 < at), at) = at2;
  best = min(best2, best);
  const double value = hmin(best);
  where(best != value, at) = static_cast<double>(n);
  const double index = hmin(at);  // n when the direction is not a number: the caller refuses the value
  return {value, index < static_cast<double>(n) ? static_cast<std::uint32_t>(index) : 0};
}

inline Extreme lowest_vertex(const shapes::Polyhedron& p, const shapes::Vec3d& direction) {
  return lowest(p.vx.data(), p.vy.data(), p.vz.data(), p.vx.size(), direction);
}
inline Extreme highest_vertex(const shapes::Polyhedron& p, const shapes::Vec3d& direction) {
  const Extreme e = lowest_vertex(p, -direction);
  return {-e.value, e.index};
}

// The same by a walk over neighbouring vertices from `start`: for the many vertices of a large body, or from one that
// is nearly the highest. Where edges are level to rounding the walk may end early, lower than the highest by rounding
// times the length of the way left over the width of the faces there.
inline Extreme climb(const shapes::Polyhedron& p, const shapes::Vec3d& direction, std::uint32_t start) {
  Extreme best{dot(direction, p.vertices[start]), start};
  for (std::uint32_t from = start;;) {
    const std::uint32_t end = p.first_spoke[from + 1];
    for (std::uint32_t k = p.first_spoke[from]; k < end; ++k) {
      const std::uint32_t u = p.spokes[k].vertex;
      if (const double value = dot(direction, p.vertices[u]); value > best.value) best = {value, u};
    }
    if (best.index == from) return best;
    from = best.index;
  }
}
// Up to this many (padded) vertices looking at all of them is faster than a walk.
inline constexpr std::size_t scan_limit = 32;

// A ball inside the polyhedron: centre and radius in the units of the geometry.
struct CoreBall {
  shapes::Vec3d centre;
  double radius;
};
inline CoreBall core_ball(const shapes::Polyhedron& p) { return {p.mass.centre, p.core_radius}; }

}  // namespace contact
