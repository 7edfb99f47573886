// Pairs of spheres in bulk: gap, normal and contact point of every pair of an index list, as arrays.
//
//   d = x_b − x_a,   gap = |d| − (r_a + r_b),   n = d/|d|,   point = ½ (r_a n + d − r_b n)
//
// Any consistent unit of length; the point is relative to the centre of a. Source: closed form, as `Analytic`
// (methods/analytic.h). Validity: every input; coincident centres take n = z; a pair that `Analytic` refuses (a radius
// that is not positive, no numbers, a length out of range) gets its gap, NaN. Cost: a third of the scalar query or less
// (`bench_pairs`, row "own packed"), gather and scatter included; instruction set chosen at run time. Accuracy: the
// bits of `Analytic`; the true gap lies within 16 eps (|d| + r_a + r_b). Thread-safe for disjoint outputs; allocates
// nothing. Tests: tests/libcontact/sphere_pairs.cpp.
#pragma once

#include <cstddef>
#include <cstdint>

#include "libcontact/export.h"
#include "shapes/math/vec.h"

namespace contact {

struct alignas(32) SphereRow {
  shapes::Vec3d centre{};
  double radius{};
};
static_assert(sizeof(SphereRow) == 4 * sizeof(double));

// Arrays of the caller, `count` long each.
struct SphereAnswers {
  double* gap;
  double* normal[3];  // x, y, z; unit, a → b
  double* point[3];   // x, y, z; relative to a's centre
};

CONTACT_API void sphere_pairs(const SphereRow* spheres, const std::uint32_t* a, const std::uint32_t* b,
                              std::size_t count, const SphereAnswers& out);

}  // namespace contact
