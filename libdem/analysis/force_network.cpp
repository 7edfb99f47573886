#include "libdem/analysis/force_network.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace dem::analysis {

namespace {

class Percolation {
 public:
  Percolation(const Snapshot& s, const Domain& region) : s_(s), clusters_(s.count()) {
    double reach = 0;
    for (const double r : s.bounding_radius) reach += r / static_cast<double>(s.count());
    for (std::uint32_t i = 0; i < s.count(); ++i) {
      std::uint32_t marks = 0;
      for (int k = 0; k < s.dimension; ++k) {
        const double r = s.bounding_radius[i] + reach, x = s.position[i][k];
        if (s.periodic[static_cast<std::size_t>(k)]) continue;
        if (x - r <= region.lower[k]) marks |= side(k, 0);
        if (x + r >= region.upper[k]) marks |= side(k, 1);
      }
      clusters_.mark(i, marks);
    }
  }
  void join(const Pair& p) {
    Clusters::Shift shift{};
    for (int k = 0; k < 3; ++k) {
      const auto axis = static_cast<std::size_t>(k);
      if (!s_.periodic[axis]) continue;
      const double beyond = s_.position[p.a][k] + p.branch[k] - s_.position[p.b][k];
      shift[axis] = static_cast<int>(std::lround(beyond / s_.length[k]));
    }
    clusters_.join(p.a, p.b, shift);
  }
  // Whether the cluster that body i is in goes through along the axis.
  bool through(std::uint32_t i, int axis) {
    const std::uint32_t both = side(axis, 0) | side(axis, 1);
    if (s_.periodic[static_cast<std::size_t>(axis)]) return clusters_.winds(i, axis);
    return clusters_.size(i) > 1 && (clusters_.marks(i) & both) == both;
  }
  Clusters& clusters() { return clusters_; }

 private:
  static std::uint32_t side(int axis, int upper) { return 1u << (2 * axis + upper); }
  const Snapshot& s_;
  Clusters clusters_;
};

}  // namespace

ForceNetwork force_network_of(const Snapshot& s, const Pairs& pairs, const Domain& region, double strong) {
  ForceNetwork network;
  network.strong.assign(pairs.bodies.size(), 0);
  std::vector<std::uint32_t> order;  // of the pairs that push, by falling force
  for (std::uint32_t k = 0; k < pairs.bodies.size(); ++k) {
    if (!(pairs.bodies[k].pressing > 0)) continue;
    order.push_back(k);
    network.mean += pairs.bodies[k].pressing;
  }
  if (!order.empty()) network.mean /= static_cast<double>(order.size());
  network.threshold = strong * network.mean;
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t i, std::uint32_t j) {
    return pairs.bodies[i].pressing > pairs.bodies[j].pressing;
  });
  Percolation percolation(s, region);
  const auto look = [&](std::uint32_t pair) {
    const Pair& p = pairs.bodies[pair];
    for (int k = 0; k < s.dimension; ++k) {
      auto& critical = network.critical[static_cast<std::size_t>(k)];
      if (!critical && percolation.through(p.a, k)) critical = p.pressing;
    }
  };
  std::size_t next = 0;
  for (; next < order.size() && pairs.bodies[order[next]].pressing >= network.threshold; ++next) {
    network.strong[order[next]] = 1;
    percolation.join(pairs.bodies[order[next]]);
    look(order[next]);
  }
  for (std::size_t k = 0; k < 3; ++k) network.percolates[k] = network.critical[k].has_value();
  network.clusters = percolation.clusters().list(2);
  for (; next < order.size(); ++next) {
    percolation.join(pairs.bodies[order[next]]);
    look(order[next]);
  }
  return network;
}

std::vector<NetworkLine> network_lines(const Snapshot& s, const Pairs& pairs, const ForceNetwork& network) {
  std::vector<NetworkLine> lines;
  const auto add = [&](const Pair& p, std::size_t place, bool strong) {
    const double relative = network.mean > 0 ? p.pressing / network.mean : 0;
    const Vec3d& from = s.position[p.a];
    lines.push_back({from, p.wall ? p.point : from + p.branch, static_cast<std::uint32_t>(place), p.wall, strong,
                     p.pressing, relative, p.tangential});
  };
  for (std::size_t k = 0; k < pairs.bodies.size(); ++k) add(pairs.bodies[k], k, network.strong[k] != 0);
  for (std::size_t k = 0; k < pairs.walls.size(); ++k)
    add(pairs.walls[k], k, pairs.walls[k].pressing > 0 && pairs.walls[k].pressing >= network.threshold);
  return lines;
}

Surface network_surface(const std::vector<NetworkLine>& lines) {
  Surface x;
  x.name = "network";
  x.lines = true;
  x.columns = {
      {"force", "N", {}}, {"relative", "1", {}}, {"tangential", "N", {}}, {"strong", "1", {}}, {"wall", "1", {}}};
  x.at_points = {{"width", "1", {}}};
  for (const NetworkLine& line : lines) {
    for (const Vec3d& end : {line.from, line.to}) {
      x.corners.push_back(static_cast<std::int32_t>(x.points.size()));
      x.points.push_back(end);
      x.at_points[0].values.push_back(std::max(line.relative, 0.0));
    }
    x.ends.push_back(static_cast<std::int32_t>(x.points.size()));
    const double row[] = {line.force, line.relative, line.tangential, line.strong ? 1.0 : 0.0, line.wall ? 1.0 : 0.0};
    for (std::size_t k = 0; k < x.columns.size(); ++k) x.columns[k].values.push_back(row[k]);
  }
  return x;
}

}  // namespace dem::analysis
