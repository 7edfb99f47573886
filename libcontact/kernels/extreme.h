// The lowest of many points along a direction: lanes run over the points of one body. Ties go to the lowest index, so
// every set gives the same answer.
#pragma once

#include <cstddef>
#include <cstdint>

#include "libcontact/export.h"
#include "shapes/math/vec.h"

namespace contact {

struct Extreme {
  double value;         // direction · point
  std::uint32_t index;  // of the point; 0 where nothing compares
};

namespace kernels {

struct Points {
  const double *x, *y, *z;
  std::size_t count;  // a positive multiple of eight
};

using LowestKernel = Extreme (*)(const Points& points, const shapes::Vec3d& direction);
// Both in one call: their latencies overlap.
using LowestTwoKernel = void (*)(const Points& a, const shapes::Vec3d& direction_a, const Points& b,
                                 const shapes::Vec3d& direction_b, Extreme* out);
struct SearchKernels {
  LowestKernel lowest;
  LowestTwoKernel lowest_two;
};
// Those of kernels(), chunk.h.
CONTACT_API const SearchKernels& search_kernels();

}  // namespace kernels

}  // namespace contact
