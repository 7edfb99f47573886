// Bodies whose centres are within a range of each other, by cells.
//
// Along periodic axes the nearest image counts, each body once. Visits go in an order that depends on the places alone.
// Cost: O(bodies) to build, O(neighbours) to visit. Tests: tests/libdem/analysis_displacement.cpp.
#pragma once

#include <cstdint>
#include <vector>

#include "libdem/analysis/grid.h"

namespace dem::analysis {

class NearBodies {
 public:
  NearBodies(const Snapshot& snapshot, double range);  // range > 0, m

  // visit(j, d) for all j other than i with |d| <= range, d from i to j's nearest image.
  template <class Visit>
  void each(std::size_t i, Visit visit) const {
    const std::array<int, 3> home = grid_.cell(cell_of_[i]);
    std::array<int, 3> first{}, last{};
    for (int axis = 0; axis < grid_.dimension(); ++axis) {
      const auto k = static_cast<std::size_t>(axis);
      const int n = grid_.count(axis);
      first[k] = n < 3 ? 0 : home[k] - 1;  // so few cells: all of them, once
      last[k] = n < 3 ? n - 1 : home[k] + 1;
    }
    for (int z = first[2]; z <= last[2]; ++z)
      for (int y = first[1]; y <= last[1]; ++y)
        for (int x = first[0]; x <= last[0]; ++x) visit_cell(i, x, y, z, visit);
  }

 private:
  int wrapped(int axis, int i) const {  // −1: there is no such cell
    const int n = grid_.count(axis);
    if (i >= 0 && i < n) return i;
    return s_.periodic[static_cast<std::size_t>(axis)] ? (i + n) % n : -1;
  }
  template <class Visit>
  void visit_cell(std::size_t i, int x, int y, int z, Visit& visit) const {
    x = wrapped(0, x);
    y = wrapped(1, y);
    z = wrapped(2, z);
    if (x < 0 || y < 0 || z < 0) return;
    const std::size_t cell = grid_.place(x, y, z);
    for (std::uint32_t k = start_[cell]; k < start_[cell + 1]; ++k) {
      const std::uint32_t j = bodies_[k];
      if (j == i) continue;
      const Vec3d d = s_.between(s_.position[i], s_.position[j]);
      if (dot(d, d) <= range_ * range_) visit(j, d);
    }
  }

  const Snapshot& s_;
  double range_;
  Grid grid_;
  std::vector<std::size_t> cell_of_;
  std::vector<std::uint32_t> start_, bodies_;
};

}  // namespace dem::analysis
