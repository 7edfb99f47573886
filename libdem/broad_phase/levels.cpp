#include "libdem/broad_phase/levels.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace dem {
namespace {

constexpr std::size_t most = 24;  // levels; smaller bodies are in the last

// The bodies of each level that has any.
std::vector<std::vector<std::uint32_t>> by_level(const std::vector<Motion>& bodies) {
  double largest = 0;
  for (const Motion& m : bodies) largest = std::max(largest, m.bounding_radius);
  std::vector<std::vector<std::uint32_t>> levels(most);
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const double halvings = std::floor(std::log2(largest / bodies[i].bounding_radius));
    levels[static_cast<std::size_t>(std::clamp(halvings, 0.0, most - 1.0))].push_back(static_cast<std::uint32_t>(i));
  }
  std::erase_if(levels, [](const auto& level) { return level.empty(); });
  return levels;
}

double largest_of(const std::vector<std::uint32_t>& level, const std::vector<Motion>& bodies) {
  double r = 0;
  for (const std::uint32_t i : level) r = std::max(r, bodies[i].bounding_radius);
  return r;
}

}  // namespace

Levels::Levels(const std::vector<Motion>& bodies, double skin, const Cell& box, double side)
    : bodies_(bodies), skin_(skin), lattice_(box.lattice) {
  const auto position = [&](std::uint32_t i) -> const Vec3d& { return bodies[i].position; };
  for (const std::vector<std::uint32_t>& level : by_level(bodies)) {
    const double radius = largest_of(level, bodies);
    Level& fresh = levels_.emplace_back(Level{radius, Cells(level, position, side * (2 * radius + skin), box), {}});
    for (const std::uint32_t i : fresh.cells.order())
      fresh.balls.push_back({bodies[i].position, bodies[i].bounding_radius});
  }
}

std::vector<std::uint32_t> order_in_space(const std::vector<Motion>& bodies, double skin, const Cell& box) {
  double side = skin;
  std::size_t members = 0;
  for (const std::vector<std::uint32_t>& level : by_level(bodies)) {
    if (level.size() <= members) continue;
    members = level.size();
    side = 2 * largest_of(level, bodies) + skin;
  }
  std::vector<std::uint32_t> all(bodies.size());
  std::iota(all.begin(), all.end(), 0U);
  return Cells(
             all, [&](std::uint32_t i) -> const Vec3d& { return bodies[i].position; }, side, box)
      .order();
}

}  // namespace dem
