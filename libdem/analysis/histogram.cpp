#include "libdem/analysis/histogram.h"

#include <algorithm>
#include <cmath>

#include "libdem/analysis/table.h"

namespace dem::analysis {

Histogram histogram_of(const std::vector<double>& values, double width, std::size_t most) {
  Histogram h;
  h.width = width;
  for (const double v : values) {
    ++h.total;
    if (v < 0) {
      ++h.below;
      continue;
    }
    const double place = std::floor(v / width);
    if (!(place < static_cast<double>(most))) {
      ++h.beyond;
      continue;
    }
    const auto bin = static_cast<std::size_t>(place);
    if (bin >= h.counts.size()) h.counts.resize(bin + 1, 0);
    ++h.counts[bin];
  }
  return h;
}

Table histogram_table(const std::string& name, const std::string& title, const std::string& variable,
                      const std::string& unit, const Histogram& h) {
  const std::string per = unit == "1" ? "1" : "1/(" + unit + ")";
  Table t = table_of(name, title, {{variable, unit}, {"count", "1"}, {"density", per}});
  for (std::size_t i = 0; i < h.counts.size(); ++i) {
    add_row(t, (static_cast<double>(i) + 0.5) * h.width, h.counts[i], h.density(i));
  }
  return t;
}

}  // namespace dem::analysis
