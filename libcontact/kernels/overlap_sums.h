// What the overlap of two polyhedra is summed to, four triangles or sides at a time: lanes run within a body. Sums are
// those of four lanes, added in one order: every set gives the same answer.
#pragma once

#include <cstddef>
#include <cstdint>

#include "libcontact/kernels/extreme.h"
#include "shapes/math/vec.h"

namespace contact {

// Of the d of overlap_depth.h. Lengths and axes of the body's frame.
struct DepthSlope {
  double depth = 0;        // d
  shapes::Vec3d force{};   // −∂d/∂u: what a unit of force of d puts on other
  shapes::Vec3d moment{};  // −∂d/∂θ about `centroid`
  shapes::Vec3d centroid{};
  // In space: V, and the variances of K across its vector area, along t and u.
  double volume = 0, tt = 0, uu = 0, tu = 0;
  shapes::Vec3d t{}, u{};
};

// An overlap shallower than this of the smaller body has lost half its digits to rounding: its depth is the gap's.
inline constexpr double least_depth = 0x1p-26;

namespace kernels {

struct OverlapTriangle {
  std::uint32_t a, b, c;  // corners
};
struct OverlapSide {
  std::uint32_t from, to;     // corners
  std::uint32_t left, right;  // faces, seen from outside along the side
};
struct OverlapRow {
  double x, y, z, other;
};

// A body as the sums take it. Lists are filled up to a multiple of four: corners by corner 0, the others by entries of
// zeros.
struct OverlapLists {
  const OverlapRow *corner, *normal;  // outward ones of faces
  const OverlapTriangle *cones, *of_other;
  const OverlapSide* rim;
  OverlapRow* places;  // scratch, as many as corners
  std::size_t corners, filled_corners, cone_count, other_count, rim_count;
};

// `size`: of the smaller body. False where the overlap is shallower than least_depth of it, or its vector area has no
// direction.
using OverlapSlopeKernel = bool (*)(const OverlapLists& body, double size, DepthSlope& out);

// Planes normal·x <= offset that some of the corners lie over, in order, into `out`, which has room for normals.count;
// how many. Of the padded planes only the first `planes` count; corners are filled up to a multiple of four by repeats.
using OverlapCuttingKernel = std::size_t (*)(const Points& normals, const double* offsets, std::size_t planes,
                                             const OverlapRow* corner, std::size_t filled, std::uint32_t* out);
// The same of a list of planes, with room for three more: it keeps those and is put in `deepest` which of them the
// farthest corner lies over.
struct OverlapPlanes {
  double *x, *y, *z, *level;
};
using OverlapDeepestKernel = std::size_t (*)(const OverlapPlanes& planes, std::size_t count,
                                             const shapes::Vec3d* corner, std::size_t corners, std::size_t& deepest);
struct OverlapKernels {
  OverlapSlopeKernel slope;
  OverlapCuttingKernel cutting;
  OverlapDeepestKernel deepest;
};

}  // namespace kernels
}  // namespace contact
