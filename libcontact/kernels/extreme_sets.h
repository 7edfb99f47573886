// The searches of extreme.h as each set has them: inside the kernels only.
#pragma once

#include "libcontact/kernels/extreme.h"

namespace contact::kernels {
inline namespace KERNEL_SET {

Extreme lowest(const Points& points, const shapes::Vec3d& direction);
void lowest_two(const Points& a, const shapes::Vec3d& direction_a, const Points& b, const shapes::Vec3d& direction_b,
                Extreme* out);
std::size_t reaching(const Points& normals, const double* offsets, std::size_t planes, const shapes::Vec3d& centre,
                     double radius, std::uint32_t* out);

}  // namespace KERNEL_SET
}  // namespace contact::kernels
