// The periodic cell: a box whose opposite faces are one face, along some of its axes or all of them.
//   positions stand in the box, centre ± ½ length; they are wrapped at the end of each drift, never at rebuilds, so
//   that no bit depends on when lists were built
//   the offset of two bodies is that to the nearest image (contact::Lattice)
//   velocities are those relative to the homogeneous flow of the cell, so they are the same for every image: what moves
//   through space as v + G (x − centre) has velocity v. G: rates of the box lengths, and a shear of x along y.    (1)
//   stress is that of the bodies on what surrounds them, compression positive:
//     V σ = Σ m v⊗v − Σ f⊗d,   f on a, d from a to b (Love and Weber); at a wall d ends at the contact             (2)
//   with V the volume of the box; an axis without images only takes part in V
#pragma once

#include <cmath>

#include "libcontact/kernels/lattice.h"
#include "libdem/accumulator.h"
#include "shapes/math/vec.h"

namespace dem {

using shapes::Mat3d;
using shapes::Vec3d;

struct Cell {
  bool periodic = false, deforms = false;
  Vec3d centre{}, length{};  // of the box, m
  double depth = 1;  // V = length.x · length.y · depth; m: length.z, or in two dimensions the bodies' thickness
  contact::Lattice lattice;
  // How the box has deformed since the list of candidates was made: about the centre, x → stretch · x + slant (0, x.y).
  Vec3d stretch{1, 1, 1};
  double slant = 0;
  Mat3d virial{};         // V σ, (2), J
  Accumulator work;       // of the deformation on the bodies, J
  Accumulator potential;  // gained by bodies in being wrapped along gravity, J; taken off the sum of their positions

  double volume() const { return length.x * length.y * depth; }
  Mat3d stress() const {
    Mat3d s = virial;
    for (Vec3d& row : s.row) row *= 1 / volume();
    return s;
  }

  // Where a point of the homogeneous flow is now that stood at x when the list was made.
  Vec3d carried(const Vec3d& x) const {
    const Vec3d r = x - centre;
    return centre + Vec3d{stretch.x * r.x + slant * r.y, stretch.y * r.y, stretch.z * r.z};
  }
  // Takes x into the box; true when it was moved.
  [[gnu::always_inline]] bool wrap(Vec3d& x) const {
    bool moved = false;
    const auto outside = [](double s) { return !(s >= -0.5 && s < 0.5); };
    const double sy = (x.y - centre.y) * lattice.inverse.y;
    if (outside(sy)) {
      const double n = std::floor(sy + 0.5);
      x.y -= n * lattice.length.y;
      x.x -= n * lattice.tilt;
      moved = true;
    }
    for (const int k : {0, 2}) {
      const double s = (x[k] - centre[k]) * lattice.inverse[k];
      if (!outside(s)) continue;
      x[k] -= std::floor(s + 0.5) * lattice.length[k];
      moved = true;
    }
    return moved;
  }
};

}  // namespace dem
