#include "libdem/analysis/force_network.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "libdem/io/vtp.h"

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

void write_network(const std::string& path, const std::vector<NetworkLine>& lines) {
  std::vector<Vec3d> points;
  std::vector<std::int32_t> connectivity, ends, strong, wall;
  std::vector<float> force, relative, tangential, width;
  for (const NetworkLine& line : lines) {
    for (const Vec3d& x : {line.from, line.to}) {
      connectivity.push_back(static_cast<std::int32_t>(points.size()));
      points.push_back(x);
      width.push_back(static_cast<float>(std::max(line.relative, 0.0)));
    }
    ends.push_back(static_cast<std::int32_t>(points.size()));
    strong.push_back(line.strong ? 1 : 0);
    wall.push_back(line.wall ? 1 : 0);
    force.push_back(static_cast<float>(line.force));
    relative.push_back(static_cast<float>(line.relative));
    tangential.push_back(static_cast<float>(line.tangential));
  }
  io::Vtp file;
  file.set_points(points, false);
  file.set_cells(io::Vtp::Cells::lines, connectivity, ends);
  file.add_point_array("width", 1, width);  // for filters that make tubes of lines
  file.add_cell_array("force", 1, force);
  file.add_cell_array("relative", 1, relative);
  file.add_cell_array("tangential", 1, tangential);
  file.add_cell_array("strong", 1, strong);
  file.add_cell_array("wall", 1, wall);
  file.write(path);
}

}  // namespace dem::analysis
