// A periodic lattice: what stands at x stands at x + any whole number of box vectors too.
//   box vectors: (length.x, 0, 0), (tilt, length.y, 0), (0, 0, length.z); an axis without images has length 0
//   homogeneous flow of the lattice: v(x) = G x, with G = diag(rate), and G_xy = shear
//   image of d: d − n_y b_y, then − n_x b_x, − n_z b_z, n = the nearest whole number of d/length (1)
// Validity of (1) as the nearest image: distances below half of every length, tilt within ± half of length.x.
// Cost: three multiplications and roundings by addition of 1.5·2^52 (half to even).
#pragma once

#include "shapes/math/vec.h"

namespace contact {

struct Lattice {
  shapes::Vec3d length{};   // m; 0: no images along this axis
  shapes::Vec3d inverse{};  // 1/m; 0 likewise
  double tilt = 0;          // m, along x, of the box vector y
  shapes::Vec3d rate{};     // 1/s
  double shear = 0;         // 1/s

  static constexpr double rounder = 0x1.8p52;

  // The nearest image of the offset d, (1).
  [[gnu::always_inline]] shapes::Vec3d nearest(const shapes::Vec3d& d) const {
    const double ny = (d.y * inverse.y + rounder) - rounder;
    const double x = d.x - ny * tilt;
    const double nx = (x * inverse.x + rounder) - rounder, nz = (d.z * inverse.z + rounder) - rounder;
    return {x - nx * length.x, d.y - ny * length.y, d.z - nz * length.z};
  }
  // G d: by how much faster the flow is at x + d than at x.
  [[gnu::always_inline]] shapes::Vec3d flow(const shapes::Vec3d& d) const {
    return {rate.x * d.x + shear * d.y, rate.y * d.y, rate.z * d.z};
  }
};

}  // namespace contact
