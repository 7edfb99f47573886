// The searches of extreme.h as each set has them: inside the kernels only.
#pragma once

#include "libcontact/kernels/extreme.h"

namespace contact::kernels {
inline namespace KERNEL_SET {

Extreme lowest(const Points& points, const shapes::Vec3d& direction);
void lowest_two(const Points& a, const shapes::Vec3d& direction_a, const Points& b, const shapes::Vec3d& direction_b,
                Extreme* out);

}  // namespace KERNEL_SET
}  // namespace contact::kernels
