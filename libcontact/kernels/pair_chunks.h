// Pairs of bodies as structures of arrays: what chunk queries of the methods hand to the kernels, whose lanes run
// across pairs. Plain arrays of doubles, as sources compiled per instruction set include this.
#pragma once

#include <cstddef>

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

// Lanes from `count` up to the next multiple of 8 must hold numbers: any pair will do.
// proofs: `lower` = separation along the start, proven; `outcome` = proven where it is above the margin.
// search: EllipsoidSearch::solve.
using EllipsoidProofs = void (*)(EllipsoidChunk& chunk, std::size_t count);
using EllipsoidSearchKernel = void (*)(EllipsoidChunk& chunk, std::size_t count, bool stop_at_proof, double tolerance);

struct PairKernels {
  EllipsoidProofs ellipsoid_proofs;
  EllipsoidSearchKernel ellipsoid_search;
};

// Those of the set that runs here (chunk.h).
const PairKernels& pair_kernels();

}  // namespace contact::kernels
