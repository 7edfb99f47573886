// A grid of cells over points: which points lie near a point. Cell side = reach, so the 27 cells around hold every
// neighbour within reach; the number of cells is bounded by enlarging the side when bodies are spread out. Along a
// periodic axis the cells divide the box, and the first one follows the last.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "libdem/cell.h"

namespace dem {

class Cells {
 public:
  template <class Position>
  Cells(std::size_t count, Position position, double reach, const Cell& box = {}) : box_(box) {
    shapes::Vec3d low = count > 0 ? position(0) : shapes::Vec3d{}, high = low;
    for (std::size_t i = 1; i < count; ++i)
      for (int k = 0; k < 3; ++k) {
        low[k] = std::min(low[k], position(i)[k]);
        high[k] = std::max(high[k], position(i)[k]);
      }
    const double limit = std::max(8.0, 2 * std::cbrt(static_cast<double>(count)));
    low_ = low;
    shapes::Vec3d span = high - low;
    for (int k = 0; k < 3; ++k) wraps_[k] = box.lattice.length[k] > 0;
    for (int k = 0; k < 3; ++k) {
      if (wraps_[k]) span[k] = box.lattice.length[k];
      // A long, thin scene may use more cells along one axis, but never more than 64 per body on the whole.
      const double n = reach > 0 ? std::clamp(std::floor(span[k] / reach), 1.0, 16 * limit) : 1;  // no bodies: no reach
      number_[k] = static_cast<std::int64_t>(n);
    }
    while (number_[0] * number_[1] * number_[2] > 64 * static_cast<std::int64_t>(count) + 64) {
      std::int64_t* largest = std::max_element(number_, number_ + 3);
      *largest = (*largest + 1) / 2;
    }
    for (int k = 0; k < 3; ++k) per_length_[k] = span[k] > 0 ? static_cast<double>(number_[k]) / span[k] : 0;
    const std::size_t cells = static_cast<std::size_t>(number_[0] * number_[1] * number_[2]);
    start_.assign(cells + 1, 0);
    cell_.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
      std::int64_t c[3];
      locate(position(i), c);
      cell_[i] = static_cast<std::uint32_t>((c[2] * number_[1] + c[1]) * number_[0] + c[0]);
      ++start_[cell_[i] + 1];
    }
    for (std::size_t c = 0; c < cells; ++c) start_[c + 1] += start_[c];
    member_.resize(count);
    std::vector<std::uint32_t> next(start_.begin(), start_.end() - 1);
    for (std::size_t i = 0; i < count; ++i) member_[next[cell_[i]]++] = static_cast<std::uint32_t>(i);
  }

  // visit(j) for every point j in the cells around point i's (i itself included).
  template <class Visit>
  void around(std::size_t i, Visit visit) const {
    const std::int64_t cell = cell_[i];
    const std::int64_t cx = cell % number_[0], cy = cell / number_[0] % number_[1],
                       cz = cell / (number_[0] * number_[1]);
    if (box_.periodic) return around_in_box(cx, cy, cz, visit);
    for (std::int64_t z = std::max<std::int64_t>(cz - 1, 0); z <= std::min(cz + 1, number_[2] - 1); ++z)
      for (std::int64_t y = std::max<std::int64_t>(cy - 1, 0); y <= std::min(cy + 1, number_[1] - 1); ++y) {
        const std::int64_t row = (z * number_[1] + y) * number_[0];
        const std::int64_t first = row + std::max<std::int64_t>(cx - 1, 0),
                           last = row + std::min(cx + 1, number_[0] - 1);
        for (std::uint32_t k = start_[static_cast<std::size_t>(first)]; k < start_[static_cast<std::size_t>(last) + 1];
             ++k)
          visit(member_[k]);
      }
  }

  // All points, cell by cell.
  const std::vector<std::uint32_t>& order() const { return member_; }

 private:
  // The cells next to number c of axis k and itself, each once.
  int next_to(std::int64_t c, int k, std::int64_t* list) const {
    int n = 0;
    for (std::int64_t i = c - 1; i <= c + 1; ++i) {
      const bool inside = i >= 0 && i < number_[k];
      if (!inside && (!wraps_[k] || number_[k] < 3)) continue;
      list[n++] = inside ? i : (i + number_[k]) % number_[k];
    }
    return n;
  }
  template <class Visit>
  void around_in_box(std::int64_t cx, std::int64_t cy, std::int64_t cz, Visit visit) const {
    std::int64_t x[3], y[3], z[3];
    const int nx = next_to(cx, 0, x), ny = next_to(cy, 1, y), nz = next_to(cz, 2, z);
    for (int c = 0; c < nz; ++c)
      for (int b = 0; b < ny; ++b)
        for (int a = 0; a < nx; ++a) {
          const auto cell = static_cast<std::size_t>((z[c] * number_[1] + y[b]) * number_[0] + x[a]);
          for (std::uint32_t k = start_[cell]; k < start_[cell + 1]; ++k) visit(member_[k]);
        }
  }
  void locate(const shapes::Vec3d& x, std::int64_t* c) const {
    for (int k = 0; k < 3; ++k) {
      double s = x[k] - low_[k];
      if (wraps_[k]) {
        const double share = (x[k] - box_.lower[k]) * box_.lattice.inverse[k];
        s = (share - std::floor(share)) * box_.lattice.length[k];
      }
      c[k] = std::clamp<std::int64_t>(static_cast<std::int64_t>(s * per_length_[k]), 0, number_[k] - 1);
    }
  }
  Cell box_;
  bool wraps_[3] = {};
  shapes::Vec3d low_{};
  std::int64_t number_[3] = {1, 1, 1};
  double per_length_[3] = {};
  std::vector<std::uint32_t> start_, cell_, member_;
};

}  // namespace dem
