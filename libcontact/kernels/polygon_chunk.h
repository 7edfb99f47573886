// Pairs of polygons, or of convex parts of them, that met by a corner of one behind a side of the other the step
// before: what the loop hands to the kernel that tries whether they still do. Plain arrays of doubles.
#pragma once

#include <cstddef>
#include <cstdint>

#include "libcontact/kernels/lattice.h"
#include "libcontact/kernels/pair_chunks.h"
#include "libcontact/kernels/records.h"

namespace contact::kernels {

// Without initial values: what a lane does not hold is never read as an answer. [0]: of body a, [1]: of body b.
struct PolygonChunk {
  static constexpr std::size_t size = EllipsoidChunk::size, widest = EllipsoidChunk::widest;
  using Lane = EllipsoidChunk::Lane;
  // in
  std::uint32_t body[2][size];
  const double *side[size], *corner[size];  // rows of shapes/polygon_rows.h: the side, of self; the corner, of other
  Lane self_is_b;                           // 1 or 0
  Lane quat_w[2], quat_z[2];                // orientations in the plane
  Lane scale[2];
  Lane inertia[2];  // kg m²
  Lane core[2];     // radius of a circle in the body about its origin, of scale 1, m; of whole polygons
  // out, m, relative to the origin of a
  Lane arm_a[2], arm_b[2];  // x and y of the point that the contact acts at, from either origin
  Lane centre[2];           // of the area of the overlap
  Lane outward[2];          // the side's normal, from a to b
  Lane gain;                // J of overlap_depth.h
  // Bodies that do not turn out of the plane; the kernel's own.
  Lane of_motion[2][12], of_side[16], of_corner[16];
};

struct LawChunk;

// Answers lanes 0 … count of the chunk, lanes up to the next multiple of 8 being filled with any pair: overlap, motion
// and patch of those that still meet so into the law's chunk. Returns them, bit i for lane i: where everything is
// proven that polygon_pair.h (whole polygons) or polygon_regions.h (`parts`) would find, to the same bits. What is in
// other lanes means nothing.
using PolygonSideKernel = std::uint32_t (*)(const Motion* motion, const Lattice* lattice, PolygonChunk& chunk,
                                            std::size_t count, bool parts, LawChunk& law);

}  // namespace contact::kernels
