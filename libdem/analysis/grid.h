// A regular grid of boxes over a region, for quantities per box.
//
//   box (i, j, k) lies between faces i and i + 1 along x, …; face(axis, i) = lower + (upper − lower) i/count      (1)
//   its place in tables is i + count_x (j + count_y k)                                                            (2)
//
// Every point of the region is in exactly one box: a box holds its lower faces, the last box along an axis both, but
// not where that axis is periodic and the region spans the cell. Along periodic axes images count: a point, or a body,
// is met wherever an image of it lies in the region, which need not be the whole cell. In the plane there is one box
// along z, without limits. Tests: tests/libdem/analysis_grid.cpp.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "libdem/analysis/settings.h"
#include "libdem/analysis/snapshot.h"

namespace dem::analysis {

class Grid {
 public:
  struct Box {
    Vec3d lower{}, upper{};  // m
  };
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  // `boxes` along each axis, each > 0; along z of the plane one in any case.
  Grid(const Snapshot& snapshot, const Domain& region, const std::array<int, 3>& boxes)
      : region_(region), count_(boxes), dimension_(snapshot.dimension) {
    if (dimension_ == 2) count_[2] = 1;
    volume_ = dimension_ == 2 ? snapshot.thickness : 1;
    for (int axis = 0; axis < dimension_; ++axis) {
      if (snapshot.periodic[static_cast<std::size_t>(axis)]) length_[axis] = snapshot.length[axis];
      volume_ *= (region_.upper[axis] - region_.lower[axis]) / count(axis);
    }
  }

  std::size_t size() const { return static_cast<std::size_t>(count(0)) * at(count(1)) * at(count(2)); }
  int count(int axis) const { return count_[static_cast<std::size_t>(axis)]; }
  int dimension() const { return dimension_; }
  const Domain& region() const { return region_; }
  double box_volume() const { return volume_; }  // m³; of the plane: area times thickness

  double face(int axis, int i) const {
    if (i == count(axis)) return region_.upper[axis];
    return region_.lower[axis] + (region_.upper[axis] - region_.lower[axis]) * i / count(axis);
  }
  std::size_t place(int i, int j, int k) const { return at(i) + at(count(0)) * (at(j) + at(count(1)) * at(k)); }
  std::array<int, 3> cell(std::size_t place) const {
    const std::size_t nx = at(count(0)), ny = at(count(1));
    return {static_cast<int>(place % nx), static_cast<int>(place / nx % ny), static_cast<int>(place / nx / ny)};
  }
  Box box(std::size_t place) const {
    const std::array<int, 3> c = cell(place);
    Box b;
    for (int axis = 0; axis < dimension_; ++axis) {
      const int i = c[static_cast<std::size_t>(axis)];
      b.lower[axis] = face(axis, i);
      b.upper[axis] = face(axis, i + 1);
    }
    return b;
  }
  Vec3d centre(std::size_t place) const {
    const Box b = box(place);
    return (b.lower + b.upper) * 0.5;
  }

  // Of a point, or of its image that lies in the region (the first, where there are several); none: outside.
  std::size_t index(const Vec3d& x) const {
    std::array<int, 3> c{};
    for (int axis = 0; axis < dimension_; ++axis) {
      double p = x[axis];
      if (length_[axis] > 0) {
        p -= std::floor((p - region_.lower[axis]) / length_[axis]) * length_[axis];
        if (p < region_.lower[axis]) p = region_.lower[axis];  // rounding
      }
      if (!(p >= region_.lower[axis] && p <= region_.upper[axis])) return none;
      c[static_cast<std::size_t>(axis)] = along(axis, p);
    }
    return place(c[0], c[1], c[2]);
  }

  // visit(place, shift) for every box that the box from `lower` to `upper`, moved by `shift`, reaches into: `shift`
  // leads to the image, zero along axes that are not periodic. In order of the shifts, then of the places.
  template <class Visit>
  void each_touched(const Vec3d& lower, const Vec3d& upper, Visit visit) const {
    std::array<int, 3> first_shift{}, last_shift{};
    for (int axis = 0; axis < dimension_; ++axis)
      if (length_[axis] > 0) {
        const auto i = static_cast<std::size_t>(axis);
        first_shift[i] = static_cast<int>(std::ceil((region_.lower[axis] - upper[axis]) / length_[axis]));
        last_shift[i] = static_cast<int>(std::floor((region_.upper[axis] - lower[axis]) / length_[axis]));
      }
    for (int sz = first_shift[2]; sz <= last_shift[2]; ++sz)
      for (int sy = first_shift[1]; sy <= last_shift[1]; ++sy)
        for (int sx = first_shift[0]; sx <= last_shift[0]; ++sx) {
          const Vec3d shift{sx * length_.x, sy * length_.y, sz * length_.z};
          touched_without_images(lower + shift, upper + shift, [&](std::size_t place) { visit(place, shift); });
        }
  }

 private:
  static std::size_t at(int i) { return static_cast<std::size_t>(i); }
  // The box along an axis of a coordinate; beyond the region the nearest one.
  int along(int axis, double p) const {
    const double width = region_.upper[axis] - region_.lower[axis];
    const double share = width > 0 ? (p - region_.lower[axis]) / width : 0;
    int i = static_cast<int>(std::clamp(share * count(axis), 0.0, count(axis) - 1.0));
    while (i > 0 && p < face(axis, i)) --i;
    while (i + 1 < count(axis) && p >= face(axis, i + 1)) ++i;
    return i;
  }
  template <class Visit>
  void touched_without_images(const Vec3d& lower, const Vec3d& upper, Visit visit) const {
    std::array<int, 3> first{}, last{};
    for (int axis = 0; axis < dimension_; ++axis) {
      if (upper[axis] <= region_.lower[axis] || lower[axis] >= region_.upper[axis]) return;
      const auto i = static_cast<std::size_t>(axis);
      first[i] = along(axis, lower[axis]);
      last[i] = along(axis, upper[axis]);
    }
    for (int k = first[2]; k <= last[2]; ++k)
      for (int j = first[1]; j <= last[1]; ++j)
        for (int i = first[0]; i <= last[0]; ++i) visit(place(i, j, k));
  }

  Domain region_;
  std::array<int, 3> count_;
  int dimension_ = 3;
  Vec3d length_{};  // of the cell along periodic axes, m; 0: not periodic
  double volume_ = 0;
};

// Of the bodies' equivalent radii, m; 0 without bodies.
double mean_diameter(const Snapshot& snapshot);
// Boxes that settings ask for, where they say 0 so many that each is about four mean diameters wide, over
// `region`. Without bodies: one along each axis.
std::array<int, 3> boxes_of(const Snapshot& snapshot, const Domain& region, const std::array<int, 3>& asked);
// settings.region, or domain_of(snapshot). Throws InputError when it is empty inside out.
Domain region_of(const Snapshot& snapshot, const Settings& settings);
// Of the two.
Grid grid_of(const Snapshot& snapshot, const Settings& settings);

}  // namespace dem::analysis
