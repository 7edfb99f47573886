#include "libdem/analysis/grid.h"

#include <fmt/format.h>

#include "libdem/scene/where.h"

namespace dem::analysis {

double mean_diameter(const Snapshot& snapshot) {
  double sum = 0;
  for (const double r : snapshot.radius) sum += 2 * r;
  return snapshot.count() > 0 ? sum / static_cast<double>(snapshot.count()) : 0;
}

std::array<int, 3> boxes_of(const Snapshot& snapshot, const Domain& region, const std::array<int, 3>& asked) {
  const double diameter = mean_diameter(snapshot);
  constexpr double most = 4096;  // along an axis, of boxes that nobody asked for
  std::array<int, 3> boxes{1, 1, 1};
  for (int axis = 0; axis < snapshot.dimension; ++axis) {
    const auto i = static_cast<std::size_t>(axis);
    const double width = region.upper[axis] - region.lower[axis];
    if (asked[i] > 0)
      boxes[i] = asked[i];
    else if (diameter > 0)
      boxes[i] = static_cast<int>(std::clamp(std::round(width / (4 * diameter)), 1.0, most));
  }
  return boxes;
}

Domain region_of(const Snapshot& snapshot, const Settings& settings) {
  const Domain region = settings.region ? *settings.region : domain_of(snapshot);
  for (int axis = 0; axis < snapshot.dimension; ++axis)
    if (!(region.lower[axis] <= region.upper[axis]))
      throw InputError(fmt::format("region of an analysis: lower {} is above upper {} along {}", region.lower[axis],
                                   region.upper[axis], "xyz"[axis]));
  return region;
}

Grid grid_of(const Snapshot& snapshot, const Settings& settings) {
  const Domain region = region_of(snapshot, settings);
  return {snapshot, region, boxes_of(snapshot, region, settings.boxes)};
}

}  // namespace dem::analysis
