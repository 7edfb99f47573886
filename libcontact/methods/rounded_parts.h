// From the answer for the cores to that for rounded bodies.
#pragma once

#include "libcontact/contact.h"

namespace contact {

// Directions that two queries of one face give differ by rounding only.
inline constexpr double same_direction = 1 - 64 * epsilon;

inline Status status_of(const Contact& c) {
  return c.gap_lower > 0 ? Status::separated : (c.gap_upper < 0 ? Status::overlapping : Status::touching);
}

// Takes the radii off the gap of the cores; `allowance` for the rounding of doing so, m.
inline void take_off(Contact& c, double radii, double allowance) {
  c.gap -= radii;
  c.gap_lower -= radii + allowance;
  c.gap_upper += allowance - radii;
  c.method_overlap = -c.gap;
  c.status = status_of(c);
}

}  // namespace contact
