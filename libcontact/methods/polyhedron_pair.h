// Two polyhedra seen from the body frame of one of them, lengths in a unit near the size of the pair. Vertices are
// never transformed: a direction is taken to each body's own frame, where the geometry's arrays are used as they are.
// Any number of vertices, no scratch.
#pragma once

#include "libcontact/contact.h"
#include "libcontact/methods/vertex_support.h"

namespace contact {

// Half width of the bounds that a query over polyhedra gives, for a pair of size L: rotation matrices rounded from unit
// quaternions (8 eps), two rotations of a direction and three products (12 eps), and candidates that are dropped
// because they cannot win by more than 8 eps L.
inline constexpr double polyhedron_rounding = 32 * epsilon;
// What an edge must be better by, so that a patch is never lost to rounding.
inline constexpr double face_preference = 8 * epsilon;

struct Separation {
  double value;                     // min over other of n·x − max over self of n·x
  std::uint32_t on_self, on_other;  // the vertices that give it
};

struct PolyhedronPair {
  const shapes::Polyhedron* self;
  const shapes::Polyhedron* other;
  double self_scale, other_scale;  // geometry -> units
  Mat3d other_to_self;             // rotation of other's body frame into self's
  Vec3d offset;                    // origin of other in self's frame, units

  Vec3d self_vertex(std::uint32_t i) const { return self_scale * self->vertices[i]; }
  Vec3d other_vertex(std::uint32_t i) const { return other_to_self * (other_scale * other->vertices[i]) + offset; }

  // Support of other along −n and of self along n; n in self's frame.
  Extreme lowest_of_other(const Vec3d& n) const {
    const Extreme e = lowest_vertex(*other, transposed_times(other_to_self, n));
    return {other_scale * e.value + dot(n, offset), e.index};
  }
  Extreme highest_of_self(const Vec3d& n) const {
    const Extreme e = highest_vertex(*self, n);
    return {self_scale * e.value, e.index};
  }
  Separation separation(const Vec3d& n) const {
    const Extreme b = lowest_of_other(n), a = highest_of_self(n);
    return {b.value - a.value, a.index, b.index};
  }
  PolyhedronPair swapped() const {
    return {other, self, other_scale, self_scale, transposed(other_to_self), -transposed_times(other_to_self, offset)};
  }
};

}  // namespace contact
