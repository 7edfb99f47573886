// Pairs of bodies as structures of arrays: what chunk queries of the methods hand to the kernels, whose lanes run
// across pairs. Plain arrays of doubles, as sources compiled per instruction set include this.
#pragma once

#include <cstddef>
#include <cstdint>

#include "libcontact/sphere_pairs.h"

namespace contact::kernels {

// Without initial values: what a lane does not hold is never read as an answer.
struct EllipsoidChunk {
  static constexpr std::size_t size = 32;   // pairs
  static constexpr std::size_t widest = 8;  // of all packs
  struct alignas(64) Lane {
    double v[size];
    double& operator[](std::size_t i) { return v[i]; }
    double operator[](std::size_t i) const { return v[i]; }
  };
  static constexpr std::size_t inputs = 30;
  // semi-axes of a and b, rotations of a and b row by row, offset, start (zero: none)
  Lane in[inputs];
  Lane outcome, iterations;  // EllipsoidAnswer
  Lane gap, lower, upper;
  Lane normal[3], inner_a[3], inner_b[3];
};

// Two ellipses of the plane.
struct EllipseChunk {
  static constexpr std::size_t size = EllipsoidChunk::size, widest = EllipsoidChunk::widest;
  using Lane = EllipsoidChunk::Lane;
  Lane a[4], b[4];                     // semi-axes, cosine and sine of the turn from body to world
  Lane d[2];                           // centre of b − centre of a
  Lane start[2];                       // proofs: axis in the frame of a; search: where to begin, world, or zero
  Lane outcome;                        // 1: proven, or solved
  Lane iterations, gap, lower, upper;  // EllipseAnswer
  Lane normal[2], inner_a[2], inner_b[2];
};

// Lanes from `count` up to the next multiple of 8 must hold numbers: any pair will do.
// proofs: `lower` = separation along the start, proven; `outcome` = proven where it is above the margin.
// search: EllipsoidSearch::solve, EllipseSearch::solve.
using EllipsoidProofs = void (*)(EllipsoidChunk& chunk, std::size_t count);
using EllipsoidSearchKernel = void (*)(EllipsoidChunk& chunk, std::size_t count, bool stop_at_proof, double tolerance);
using EllipseProofs = void (*)(EllipseChunk& chunk, std::size_t count);
using EllipseSearchKernel = void (*)(EllipseChunk& chunk, std::size_t count, double tolerance);

// As sphere_pairs of libcontact/sphere_pairs.h, for any count. False where some pair is not plain (lengths outside the
// range of squares, radii that are not positive, no numbers): its gap is NaN and the rest of its answer means nothing.
using SpherePairKernel = bool (*)(const SphereRow* spheres, const std::uint32_t* a, const std::uint32_t* b,
                                  std::size_t count, const SphereAnswers& out);

struct PairKernels {
  SpherePairKernel sphere_pairs;
  EllipsoidProofs ellipsoid_proofs;
  EllipsoidSearchKernel ellipsoid_search;
  EllipseProofs ellipse_proofs;
  EllipseSearchKernel ellipse_search;
};

// Those of the set that runs here (chunk.h).
const PairKernels& pair_kernels();

}  // namespace contact::kernels
