// The periodic cell: a fixed box whose opposite faces are one face, along some of its axes or all of them.
//   positions stand in the box from `lower` on; they are wrapped at the end of each drift, never at rebuilds, so that
//   no bit depends on when lists were built;
//   the offset of two bodies is that to the nearest image (contact::Lattice).
// Validity: every length at least twice the reach of the largest pair, its two bounding radii and the skin.
#pragma once

#include <cmath>

#include "libcontact/kernels/lattice.h"

namespace dem {

struct Cell {
  bool periodic = false;
  shapes::Vec3d lower{};  // of the box, m
  contact::Lattice lattice;

  // Takes x into the box.
  [[gnu::always_inline]] void wrap(shapes::Vec3d& x) const {
    for (int k = 0; k < 3; ++k) {
      const double n = std::floor((x[k] - lower[k]) * lattice.inverse[k]);
      if (n != 0) x[k] -= n * lattice.length[k];
    }
  }
};

}  // namespace dem
