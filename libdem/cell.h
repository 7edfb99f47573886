// The periodic cell: a box whose opposite faces are one face, along some of its axes or all of them.
//   positions stand in the box from `lower` on; they are wrapped at the end of each drift, never at rebuilds, so that
//   no bit depends on when lists were built;
//   the offset of two bodies is that to the nearest image (contact::Lattice).
// Validity: every length at least twice the reach of the largest pair, its two bounding radii and the skin.
// A cell that is periodic along every axis may deform (deformation.h). Velocities of bodies are then those relative to
// its homogeneous flow, so they are the same for every image: what moves through space as v + G (x − centre) has
// velocity v, with G the rates of the lengths, contact::Lattice::rate.
#pragma once

#include <cmath>

#include "libcontact/kernels/lattice.h"
#include "libdem/accumulator.h"

namespace dem {

struct Cell {
  bool periodic = false;
  bool deforms = false;
  shapes::Vec3d lower{};   // of the box, m
  shapes::Vec3d centre{};  // stays where it is when the box deforms
  contact::Lattice lattice;
  shapes::Vec3d stretch{1, 1, 1};  // of the box since the list of candidates was made
  shapes::Mat3d virial{};          // V σ, J; see deformation.h
  Accumulator work;                // of the deformation on the bodies, J

  // Takes x into the box.
  [[gnu::always_inline]] void wrap(shapes::Vec3d& x) const {
    for (int k = 0; k < 3; ++k) {
      const double n = std::floor((x[k] - lower[k]) * lattice.inverse[k]);
      if (n != 0) x[k] -= n * lattice.length[k];
    }
  }
  // Lengths along the periodic axes, about the centre.
  void set_lengths(const shapes::Vec3d& length) {
    for (int k = 0; k < 3; ++k) {
      if (lattice.length[k] == 0) continue;
      lattice.length[k] = length[k];
      lattice.inverse[k] = 1 / length[k];
      lower[k] = centre[k] - 0.5 * length[k];
    }
  }
};

}  // namespace dem
