#include "libdem/analysis/near_bodies.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace dem::analysis {

namespace {

// Cells at least as wide as the range over the box of all centres.
Grid cells_over(const Snapshot& s, double range) {
  Domain box;
  std::array<int, 3> cells{1, 1, 1};
  for (int k = 0; k < s.dimension; ++k) {
    const auto axis = static_cast<std::size_t>(k);
    double low = 0, high = 0;
    for (std::size_t i = 0; i < s.count(); ++i) {
      low = i == 0 ? s.position[i][k] : std::min(low, s.position[i][k]);
      high = i == 0 ? s.position[i][k] : std::max(high, s.position[i][k]);
    }
    box.lower[k] = s.periodic[axis] ? s.lower[k] : low;
    box.upper[k] = s.periodic[axis] ? s.lower[k] + s.length[k] : high;
    const double most = std::max(1.0, std::cbrt(8.0 * static_cast<double>(s.count())));  // memory as for the bodies
    cells[axis] = static_cast<int>(std::clamp(std::floor((box.upper[k] - box.lower[k]) / range), 1.0, most));
  }
  return {s, box, cells};
}

}  // namespace

NearBodies::NearBodies(const Snapshot& s, double range) : s_(s), range_(range), grid_(cells_over(s, range)) {
  start_.assign(grid_.size() + 1, 0);
  for (const Vec3d& x : s.position) {
    cell_of_.push_back(grid_.index(x));
    ++start_[cell_of_.back() + 1];
  }
  std::partial_sum(start_.begin(), start_.end(), start_.begin());
  bodies_.resize(s.count());
  std::vector<std::uint32_t> next(start_.begin(), start_.end() - 1);
  for (std::uint32_t i = 0; i < s.count(); ++i) bodies_[next[cell_of_[i]]++] = i;
}

}  // namespace dem::analysis
