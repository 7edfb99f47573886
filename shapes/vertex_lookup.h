// Which patch of the sphere a direction lies in: the cube around it, each face cut into cells × cells squares. A walk
// to the extreme vertex begins at the one that is extreme for the middle of the patch.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "shapes/math/vec.h"

namespace shapes {

// Any direction is given a patch below 6·cells², one that is not a number too.
inline std::uint32_t lookup_patch(const Vec3d& direction, std::uint32_t cells) {
  const double x = std::abs(direction.x), y = std::abs(direction.y), z = std::abs(direction.z);
  const int axis = x >= y ? (x >= z ? 0 : 2) : (y >= z ? 1 : 2);
  const double high = direction[axis], u = direction[axis == 0 ? 1 : 0], v = direction[axis == 2 ? 1 : 2];
  const double half = 0.5 * cells, scale = half / std::max(std::abs(high), 0x1p-1000);
  const auto cell = [&](double t) {
    return static_cast<std::uint32_t>(std::min(2 * half - 0.5, std::max(0.0, half + scale * t)));
  };
  const std::uint32_t face = 2 * static_cast<std::uint32_t>(axis) + (high < 0 ? 1 : 0);
  return (face * cells + cell(u)) * cells + cell(v);
}

// The direction of the middle of a patch, not unit.
inline Vec3d lookup_direction(std::uint32_t patch, std::uint32_t cells) {
  const std::uint32_t face = patch / (cells * cells), row = patch / cells % cells, column = patch % cells;
  const auto middle = [&](std::uint32_t i) { return (2.0 * i + 1) / cells - 1; };
  Vec3d d;
  const int axis = static_cast<int>(face / 2);
  d[axis] = face % 2 == 0 ? 1 : -1;
  d[axis == 0 ? 1 : 0] = middle(row);
  d[axis == 2 ? 1 : 2] = middle(column);
  return d;
}

}  // namespace shapes
