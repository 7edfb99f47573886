// A grid of cells over points: which points lie near a place. The number of cells is bounded by enlarging the side when
// points are spread out. Along a periodic axis the cells divide the box, and the first one follows the last.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "libdem/cell.h"

namespace dem {

class Cells {
 public:
  // Of the points `members` by `position(member)`; side: that of a cell, at least, m.
  template <class Position>
  Cells(const std::vector<std::uint32_t>& members, Position position, double side, const Cell& box = {}) : box_(box) {
    const std::size_t count = members.size();
    shapes::Vec3d low = count > 0 ? position(members[0]) : shapes::Vec3d{}, high = low;
    for (const std::uint32_t i : members)
      for (int k = 0; k < 3; ++k) {
        low[k] = std::min(low[k], position(i)[k]);
        high[k] = std::max(high[k], position(i)[k]);
      }
    const double limit = std::max(8.0, 2 * std::cbrt(static_cast<double>(count)));
    low_ = low;
    shapes::Vec3d span = high - low;
    for (int k = 0; k < 3; ++k) wraps_[k] = box.lattice.length[k] > 0;
    for (int k = 0; k < 3; ++k) {
      if (wraps_[k]) {
        span[k] = box.lattice.length[k];
        low_[k] = box.lower[k];
      }
      // A long, thin scene may use more cells along one axis, but never more than 64 per body on the whole.
      const double n = side > 0 ? std::clamp(std::floor(span[k] / side), 1.0, 16 * limit) : 1;  // no bodies: no side
      number_[k] = static_cast<std::int64_t>(n);
    }
    while (number_[0] * number_[1] * number_[2] > 64 * static_cast<std::int64_t>(count) + 64) {
      std::int64_t* largest = std::max_element(number_, number_ + 3);
      *largest = (*largest + 1) / 2;
    }
    for (int k = 0; k < 3; ++k) per_length_[k] = span[k] > 0 ? static_cast<double>(number_[k]) / span[k] : 0;
    start_.assign(static_cast<std::size_t>(number_[0] * number_[1] * number_[2]) + 1, 0);
    std::vector<std::uint32_t> cell(count);
    for (std::size_t i = 0; i < count; ++i) {
      std::int64_t c[3];
      for (int k = 0; k < 3; ++k) c[k] = inside(along(position(members[i])[k], k), k);
      cell[i] = static_cast<std::uint32_t>((c[2] * number_[1] + c[1]) * number_[0] + c[0]);
      ++start_[cell[i] + 1];
    }
    for (std::size_t c = 0; c + 1 < start_.size(); ++c) start_[c + 1] += start_[c];
    member_.resize(count);
    std::vector<std::uint32_t> next(start_.begin(), start_.end() - 1);
    for (std::size_t i = 0; i < count; ++i) member_[next[cell[i]]++] = members[i];
  }

  // visit(first, last) for runs of places in order() that hold every point no farther than `range` from x along each
  // axis, and others near them, each once.
  template <class Visit>
  void near(const shapes::Vec3d& x, double range, Visit visit) const {
    std::int64_t from[3], to[3];
    for (int k = 0; k < 3; ++k) {
      from[k] = along(x[k] - range, k);
      to[k] = along(x[k] + range, k);
      if (!wraps_[k]) {
        from[k] = inside(from[k], k);
        to[k] = inside(to[k], k);
      } else {
        to[k] = std::min(to[k], from[k] + number_[k] - 1);
      }
    }
    for (std::int64_t z = from[2]; z <= to[2]; ++z)
      for (std::int64_t y = from[1]; y <= to[1]; ++y) {
        const std::int64_t row = (inside(z, 2) * number_[1] + inside(y, 1)) * number_[0];
        for (std::int64_t first = from[0]; first <= to[0];) {  // runs of cells up to the end of the row
          const std::int64_t begin = inside(first, 0), length = std::min(to[0] - first, number_[0] - 1 - begin);
          visit(start_[static_cast<std::size_t>(row + begin)],
                start_[static_cast<std::size_t>(row + begin + length) + 1]);
          first += length + 1;
        }
      }
  }

  // All points, cell by cell.
  const std::vector<std::uint32_t>& order() const { return member_; }

 private:
  // Number of the cell along axis k at coordinate x, as if the cells went on for ever.
  std::int64_t along(double x, int k) const {
    const double c = std::floor((x - low_[k]) * per_length_[k]);
    return static_cast<std::int64_t>(std::clamp(c, -0x1p40, 0x1p40));
  }
  std::int64_t inside(std::int64_t c, int k) const {
    const std::int64_t n = number_[k];
    if (!wraps_[k]) return std::clamp<std::int64_t>(c, 0, n - 1);
    return c >= 0 && c < n ? c : ((c % n) + n) % n;
  }
  Cell box_;
  bool wraps_[3] = {};
  shapes::Vec3d low_{};
  std::int64_t number_[3] = {1, 1, 1};
  double per_length_[3] = {};
  std::vector<std::uint32_t> start_, member_;
};

}  // namespace dem
