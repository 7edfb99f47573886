// A periodic lattice: what stands at x stands at x + any whole number of box lengths too, axis by axis.
//   image of d: d − n · length, n = the nearest whole number of d/length (1)
//   the lengths change at their rates, and with them space flows: at x + d by G d faster than at x, G = diag(rate) (2)
// Validity of (1) as the nearest image: distances below half of every length that is not 0.
// Cost: per axis two multiplications and a rounding by addition of 1.5·2^52 (half to even).
#pragma once

#include "shapes/math/vec.h"

namespace contact {

struct Lattice {
  shapes::Vec3d length{};   // m; 0: no images along this axis
  shapes::Vec3d inverse{};  // 1/m; 0 likewise
  shapes::Vec3d rate{};     // 1/s, of the lengths, over the lengths

  static constexpr double rounder = 0x1.8p52;

  // The nearest image of the offset d, (1).
  [[gnu::always_inline]] shapes::Vec3d nearest(const shapes::Vec3d& d) const {
    const double nx = (d.x * inverse.x + rounder) - rounder, ny = (d.y * inverse.y + rounder) - rounder,
                 nz = (d.z * inverse.z + rounder) - rounder;
    return {d.x - nx * length.x, d.y - ny * length.y, d.z - nz * length.z};
  }
  // G d, (2).
  [[gnu::always_inline]] shapes::Vec3d flow(const shapes::Vec3d& d) const { return shapes::scaled(rate, d); }
};

}  // namespace contact
