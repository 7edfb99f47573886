// Extreme vertex of a polyhedron along a direction, over the padded coordinate arrays: the inner loop of every
// polyhedron query.
#pragma once

#include <cstddef>
#include <cstdint>

#include "libcontact/kernels/extreme.h"
#include "shapes/polyhedron.h"

namespace contact {

inline kernels::Points points_of(const shapes::Polyhedron& p) {
  return {p.vx.data(), p.vy.data(), p.vz.data(), p.vx.size()};
}
inline Extreme lowest_vertex(const shapes::Polyhedron& p, const shapes::Vec3d& direction) {
  return kernels::search_kernels().lowest(points_of(p), direction);
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
      const auto& spoke = p.spokes[k];
      if (const double value = dot(direction, spoke.to); value > best.value) best = {value, spoke.vertex};
    }
    if (best.index == from) return best;
    from = best.index;
  }
}
// Up to this many (padded) vertices looking at all of them is faster than a walk from a vertex of the lookup table:
// they come in order from memory, and nothing has to be guessed.
inline constexpr std::size_t scan_limit = 256;

// A ball inside the polyhedron: centre and radius in the units of the geometry.
struct CoreBall {
  shapes::Vec3d centre;
  double radius;
};
inline CoreBall core_ball(const shapes::Polyhedron& p) { return {p.mass.centre, p.core_radius}; }

}  // namespace contact
