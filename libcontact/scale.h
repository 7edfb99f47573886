// Powers of two taken out of a problem before it is solved, so that sizes near 1 are all a solver ever sees.
//
//   2^e <= length < 2^(e+1),   inputs times 2^-e,   answers times 2^e                                         (1)
//
// Multiplication by a power of two is exact: the answer of bodies scaled by 2^k is the answer times 2^k, bit for bit,
// and no square or cubic term under- or overflows. Cost: about 1 ns.
#pragma once

#include <bit>

#include "libcontact/contact.h"

namespace contact {

// Extents (distance of the origins plus circumradii, m) that a query accepts. Outside, products of two lengths with
// epsilon are subnormal or infinite, and the query is refused.
inline constexpr double smallest_extent = 0x1p-960, largest_extent = 0x1p960;
// Ratio of a body's smallest size to the extent below which a query is refused: its square must stay a normal number.
inline constexpr double smallest_ratio = 0x1p-300;

// False for NaN too.
inline bool extent_in_range(double extent) { return extent >= smallest_extent && extent <= largest_extent; }

// False when any component is NaN.
inline bool all_at_least(const Vec3d& v, double limit) { return v.x >= limit && v.y >= limit && v.z >= limit; }

struct Scale {
  double down, up;  // 2^-e and 2^e
};

// Needs an extent in range.
inline Scale scale_of(double extent) {
  const std::uint64_t exponent = std::bit_cast<std::uint64_t>(extent) >> 52;
  return {std::bit_cast<double>((std::uint64_t{2046} - exponent) << 52), std::bit_cast<double>(exponent << 52)};
}

// |v| and the unit vector along v, without under- or overflow of the squares and with the same bits at every scale.
// Zero gives the z axis; so does what is too large, NaN and infinity, which are passed on.
inline double length_and_direction(const Vec3d& v, Vec3d& direction) {
  const double square = dot(v, v);
  if (square > 0x1p-900 && square < 0x1p900) [[likely]] {
    const double length = std::sqrt(square);
    direction = v * (1 / length);
    return length;
  }
  const double size = std::abs(v.x) + std::abs(v.y) + std::abs(v.z);
  if (size > 0 && size < smallest_extent) return length_and_direction(v * 0x1p600, direction) * 0x1p-600;
  if (!extent_in_range(size)) {
    direction = {0, 0, 1};
    return size;
  }
  const Scale scale = scale_of(size);
  const Vec3d near_one = v * scale.down;
  const double length = norm(near_one);
  direction = near_one * (1 / length);
  return length * scale.up;
}

// Every length of an answer times a power of two.
inline void rescale(OverlapDepth& d, double up) {
  d.depth *= up;
  d.point *= up;
  d.screw *= up;
}
inline void rescale(Contact& c, double up) {
  c.gap *= up;
  c.gap_lower *= up;
  c.gap_upper *= up;
  c.point_a *= up;
  c.point_b *= up;
  c.patch.centre *= up;
  for (double& moment : c.patch.spread) moment = moment * up * up;
  c.patch.weight = c.patch.weight * up * up * up;
  c.method_overlap *= up;
  c.method_point *= up;
  rescale(c.measure, up);
}

}  // namespace contact
