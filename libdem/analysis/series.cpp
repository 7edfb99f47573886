#include "libdem/analysis/series.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dem::analysis {
namespace {

// Mean and sum of squares about it, value by value: equal values give exactly zero.
struct Running {
  std::size_t count = 0;
  double mean = 0, squares = 0;
  void add(double x) {
    ++count;
    const double d = x - mean;
    mean += d / static_cast<double>(count);
    squares += d * (x - mean);
  }
};

Running running_of(std::span<const double> values) {
  Running r;
  for (const double x : values) r.add(x);
  return r;
}

}  // namespace

SteadyPart steady_part(std::span<const double> values) {
  constexpr std::size_t least = 16, many = 50, group = 5;
  SteadyPart part;
  if (values.size() < least) return part;
  part.decided = true;
  const std::size_t width = values.size() >= many ? group : 1, count = values.size() / width;
  std::vector<double> z(count);
  for (std::size_t i = 0; i < count; ++i) z[i] = running_of(values.subspan(i * width, width)).mean;
  const std::size_t last = count / 2;
  double best = std::numeric_limits<double>::infinity();
  std::size_t at = last;
  Running tail;
  for (std::size_t d = count; d-- > 0;) {
    tail.add(z[d]);
    if (d > last) continue;
    const double n = static_cast<double>(count - d), mser = tail.squares / (n * n);  // (1)
    if (mser <= best) {
      best = mser;
      at = d;
    }
  }
  part.steady = at < last;
  if (part.steady) part.from = at * width;
  return part;
}

MeanOverTime mean_over_time(std::span<const double> values) {
  constexpr std::size_t fewest = 8;
  MeanOverTime m;
  m.count = values.size();
  if (values.empty()) return m;
  const Running all = running_of(values);
  m.mean = all.mean;
  if (m.count < 2) return m;
  m.deviation = std::sqrt(all.squares / static_cast<double>(m.count - 1));
  struct Level {
    double error, own;
    std::size_t block;
  };
  std::vector<Level> levels;
  std::vector<double> x(values.begin(), values.end());
  for (std::size_t block = 1;; block *= 2) {
    const double n = static_cast<double>(x.size()), error = std::sqrt(running_of(x).squares / n / (n - 1));  // (2)
    levels.push_back({error, error / std::sqrt(2 * (n - 1)), block});
    if (x.size() / 2 < fewest) break;
    for (std::size_t i = 0; i < x.size() / 2; ++i) x[i] = 0.5 * (x[2 * i] + x[2 * i + 1]);
    x.resize(x.size() / 2);
  }
  for (std::size_t l = 0; l < levels.size(); ++l) {
    const bool reached = std::all_of(levels.begin() + static_cast<std::ptrdiff_t>(l) + 1, levels.end(),
                                     [&](const Level& later) { return later.error <= levels[l].error + later.own; });
    if (!reached) continue;
    m.error = levels[l].error;
    m.block = levels[l].block;
    m.settled = l + 1 < levels.size();
    break;
  }
  return m;
}

std::vector<Block> block_means(std::span<const double> values, std::size_t blocks) {
  std::vector<Block> list;
  const std::size_t count = std::min(blocks, values.size() / 2);
  for (std::size_t b = 0; b < count; ++b) {
    const std::size_t first = values.size() * b / count, end = values.size() * (b + 1) / count;
    const Running r = running_of(values.subspan(first, end - first));
    const double n = static_cast<double>(r.count);
    list.push_back({first, r.count, r.mean, std::sqrt(r.squares / n / (n - 1))});
  }
  return list;
}

}  // namespace dem::analysis
