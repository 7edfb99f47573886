// Pairs that are known to be apart still: from a proven gap and a bound of how far bodies have moved since.
//
// Travel of a body, a sum over steps since the list of candidates was made:
//   T += |Δx| + 2 R |Δq|,   |Δq| the difference of its unit quaternions as vectors                                 (1)
// No point of a body within R of its centre has moved farther: a turn by θ takes it at most 2 R sin(θ/2), and
// |Δq| = 2 sin(θ/4) >= sin(θ/2). A gap g > 0 found at travels T_a, T_b is still positive while
//   T_a + T_b < until,   until = (T_a + T_b)(1 − 2^-30) + g (1 − 2^-20) − 2^-36 (R_a + R_b) (2)
// The last terms hold what rounds: the sum of the travels over up to 2^20 steps, the offset of the query, and the query
// itself, which then would not find an overlap either. So (2) changes no bit of a run, whatever it spares; it is not
// part of the state.
#pragma once

#include <cmath>

#include "shapes/math/quat.h"
#include "shapes/math/vec.h"

namespace dem {

// Of one step, m: displacement, turn from one unit quaternion to the next, radius of the body about its centre.
inline double travel_of(const shapes::Vec3d& displacement, const shapes::Quatd& before, const shapes::Quatd& after,
                        double radius) {
  const double w = after.w - before.w, x = after.x - before.x, y = after.y - before.y, z = after.z - before.z;
  return norm(displacement) + 2 * radius * std::sqrt(w * w + x * x + y * y + z * z);
}

// (2), m. Not above the present sum of the travels when the gap is too small to tell.
inline double apart_until(double travels, double gap, double radii) {
  return travels * (1 - 0x1p-30) + gap * (1 - 0x1p-20) - 0x1p-36 * radii;
}

}  // namespace dem
