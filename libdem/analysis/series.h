// A number over time, at equal intervals: where its steady part begins, its mean, and how sure that mean is.
//
//   steady part   MSER: of all points d where to begin, that which minimises
//                   MSER(d) = Σ_{i >= d} (z_i − mean_d)² / (k − d)²                                               (1)
//                 over the first half of the k values z, each the mean of five values where there are 50 or more
//                 (MSER-5). A minimum at the end of that half, where a drift has it, means: not steady.
//                 K. P. White, Simulation 69 (1997) 323; White, Cobb, Spratt, Proc. Winter Simulation Conf. (2000) 755.
//   error         of a mean of values that remember each other: halve the series again and again, each time into means
//                 of neighbours; from each level sqrt(c₀/(n − 1)), with its own error of 1/sqrt(2 (n − 1)) of it   (2)
//                 The first level that no later one of eight values or more exceeds by its own error counts.
//                 H. Flyvbjerg, H. G. Petersen, J. Chem. Phys. 91 (1989) 461.
//
// Validity: values at equal intervals. Steady: at least 16 values; a slow drift that is small beside the scatter is not
// seen. Error: a series of less than about 20 memory times gives too small a one, and says so (`settled`). Cost:
// linear. Accuracy of the error: a quarter of it or so, for it comes from eight values at times. Tests:
// tests/libdem/analysis_series.cpp.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace dem::analysis {

struct SteadyPart {
  bool steady = false;   // false: drifts, or too short to say
  bool decided = false;  // false: too short
  std::size_t from = 0;  // first value of the steady part; 0 when there is none
};
SteadyPart steady_part(std::span<const double> values);

struct MeanOverTime {
  std::size_t count = 0;
  double mean = 0;
  double deviation = 0;         // standard, of the values
  std::optional<double> error;  // standard, of the mean; none of less than two values
  std::size_t block = 1;        // values per block of the level that (2) took
  bool settled = false;         // whether the error no longer grows with the blocks; else it is a lower bound
};
MeanOverTime mean_over_time(std::span<const double> values);

struct Block {
  std::size_t first = 0, count = 0;  // of the values
  double mean = 0;
  double error = 0;  // standard, from the scatter in the block as if its values were independent
};
// As many blocks of equal length (to one value) as asked, each of two values at least; none of less than two values.
std::vector<Block> block_means(std::span<const double> values, std::size_t blocks);

}  // namespace dem::analysis
