// A histogram of numbers on bins of one width from zero, as a density.
#pragma once

#include <string>
#include <vector>

#include "libdem/analysis/result.h"

namespace dem::analysis {

struct Histogram {
  double width = 1;            // of a bin
  std::vector<double> counts;  // bin i: [i, i + 1) width; up to the largest value, at most `most` bins
  double beyond = 0;           // that lie past the last bin
  double below = 0;            // that are negative
  double total = 0;
  double density(std::size_t bin) const { return total > 0 ? counts[bin] / (total * width) : 0; }
};
Histogram histogram_of(const std::vector<double>& values, double width, std::size_t most);
// Columns: middle of the bin, count, density (of `unit` to the −1).
Table histogram_table(const std::string& name, const std::string& title, const std::string& variable,
                      const std::string& unit, const Histogram& h);

}  // namespace dem::analysis
