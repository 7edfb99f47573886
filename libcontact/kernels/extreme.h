// The lowest of many points along a direction, and the planes that a ball reaches over: lanes run over the points or
// planes of one body. Ties go to the lowest index, so every set gives the same answer.
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
// Planes normal·x <= offset that a ball reaches over, in order, into `out`, which has room for normals.count; how many.
// Of the padded planes only the first `planes` count.
using ReachingKernel = std::size_t (*)(const Points& normals, const double* offsets, std::size_t planes,
                                       const shapes::Vec3d& centre, double radius, std::uint32_t* out);
struct SearchKernels {
  LowestKernel lowest;
  LowestTwoKernel lowest_two;
  ReachingKernel reaching;
};
// Those of kernels(), chunk.h.
CONTACT_API const SearchKernels& search_kernels();

}  // namespace kernels

}  // namespace contact
