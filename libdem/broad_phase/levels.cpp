#include "libdem/broad_phase/levels.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace dem {
namespace {

constexpr std::size_t most = 24;  // levels; smaller bodies are in the last

// The bodies of each level that has any.
std::vector<std::vector<std::uint32_t>> by_level(const std::vector<double>& radii) {
  double largest = 0;
  for (const double r : radii) largest = std::max(largest, r);
  std::vector<std::vector<std::uint32_t>> levels(most);
  for (std::size_t i = 0; i < radii.size(); ++i) {
    const double halvings = std::floor(std::log2(largest / radii[i]));
    levels[static_cast<std::size_t>(std::clamp(halvings, 0.0, most - 1.0))].push_back(static_cast<std::uint32_t>(i));
  }
  std::erase_if(levels, [](const auto& level) { return level.empty(); });
  return levels;
}

double largest_of(const std::vector<std::uint32_t>& level, const std::vector<double>& radii) {
  double r = 0;
  for (const std::uint32_t i : level) r = std::max(r, radii[i]);
  return r;
}

// With what the bodies are allowed to move.
std::vector<double> radii_of(const std::vector<Motion>& bodies, const std::vector<double>& allowance) {
  std::vector<double> radii(bodies.size());
  for (std::size_t i = 0; i < bodies.size(); ++i) radii[i] = bodies[i].bounding_radius + allowance[i];
  return radii;
}

}  // namespace

Levels::Levels(const std::vector<Motion>& bodies, const std::vector<double>& allowance, const Cell& box, double side)
    : bodies_(bodies), allowance_(allowance), lattice_(box.lattice) {
  const std::vector<double> radii = radii_of(bodies, allowance);
  const auto position = [&](std::uint32_t i) -> const Vec3d& { return bodies[i].position; };
  for (const std::vector<std::uint32_t>& level : by_level(radii)) {
    const double radius = largest_of(level, radii);
    Level& fresh = levels_.emplace_back(Level{radius, Cells(level, position, side * 2 * radius, box), {}});
    for (const std::uint32_t i : fresh.cells.order()) fresh.balls.push_back({bodies[i].position, radii[i]});
  }
}

std::vector<std::uint32_t> order_in_space(const std::vector<Motion>& bodies, const std::vector<double>& allowance,
                                          const Cell& box) {
  const std::vector<double> radii = radii_of(bodies, allowance);
  double side = 0;
  std::size_t members = 0;
  for (const std::vector<std::uint32_t>& level : by_level(radii)) {
    if (level.size() <= members) continue;
    members = level.size();
    side = 2 * largest_of(level, radii);
  }
  std::vector<std::uint32_t> all(bodies.size());
  std::iota(all.begin(), all.end(), 0U);
  return Cells(
             all, [&](std::uint32_t i) -> const Vec3d& { return bodies[i].position; }, side, box)
      .order();
}

}  // namespace dem
