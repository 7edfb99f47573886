// Compiled once per instruction set.
#include "libcontact/kernels/extreme_sets.h"
#include "shapes/math/pack.h"

namespace contact::kernels {
inline namespace KERNEL_SET {
namespace {

using shapes::Pack;
using std::experimental::element_aligned;

struct Search {
  Pack best, at;  // least value in each lane, and its index

  [[gnu::always_inline]] Search(const Points& p, const shapes::Vec3d& direction) {
    constexpr std::size_t width = Pack::size(), second = width < 8 ? width : 0, step = second + width;
    const Pack nx = direction.x, ny = direction.y, nz = direction.z;
    const auto value_at = [&](std::size_t i) __attribute__((always_inline)) {
      return nx * Pack(p.x + i, element_aligned) + ny * Pack(p.y + i, element_aligned) +
             nz * Pack(p.z + i, element_aligned);
    };
    // Two independent minima (one where a pack fills the padding): the loop is bound by throughput, not by the latency
    // of the comparison. Indices are counted in doubles, lane by lane.
    const Pack count([](auto lane) { return static_cast<double>(lane); });
    Pack here = count, best2 = value_at(second), at2 = count + static_cast<double>(second);
    best = value_at(0);
    at = count;
    for (std::size_t i = step; i < p.count; i += step) {
      here += static_cast<double>(step);
      const Pack value = value_at(i);
      where(value < best, at) = here;
      best = min(value, best);
      if constexpr (second > 0) {
        const Pack value2 = value_at(i + second);
        where(value2 < best2, at2) = here + static_cast<double>(second);
        best2 = min(value2, best2);
      }
    }
    if constexpr (second > 0) {
      where(best2 < best || (best2 == best && at2 < at), at) = at2;
      best = min(best2, best);
    }
  }
  [[gnu::always_inline]] Extreme finish(std::size_t count) {
    const double value = hmin(best), none = static_cast<double>(count);
    where(best != value, at) = none;
    const double index = hmin(at);  // none when the direction is not a number
    return {value, index < none ? static_cast<std::uint32_t>(index) : 0};
  }
};

}  // namespace

Extreme lowest(const Points& points, const shapes::Vec3d& direction) {
  return Search(points, direction).finish(points.count);
}

void lowest_two(const Points& a, const shapes::Vec3d& direction_a, const Points& b, const shapes::Vec3d& direction_b,
                Extreme* out) {
  Search first(a, direction_a), second(b, direction_b);
  out[0] = first.finish(a.count);
  out[1] = second.finish(b.count);
}

std::size_t reaching(const Points& normals, const double* offsets, std::size_t planes, const shapes::Vec3d& centre,
                     double radius, std::uint32_t* out) {
  constexpr std::size_t width = Pack::size();
  const Pack x = centre.x, y = centre.y, z = centre.z;
  std::size_t found = 0;
  for (std::size_t i = 0; i < normals.count; i += width) {
    const Pack over = x * Pack(normals.x + i, element_aligned) + y * Pack(normals.y + i, element_aligned) +
                      z * Pack(normals.z + i, element_aligned) - Pack(offsets + i, element_aligned) + radius;
    if (none_of(over > 0)) continue;
    double by[width];
    over.copy_to(by, element_aligned);
    for (std::size_t lane = 0; lane < width; ++lane) {
      out[found] = static_cast<std::uint32_t>(i + lane);
      found += static_cast<std::size_t>(by[lane] > 0) & static_cast<std::size_t>(i + lane < planes);
    }
  }
  return found;
}

}  // namespace KERNEL_SET
}  // namespace contact::kernels
