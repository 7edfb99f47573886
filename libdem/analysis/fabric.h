// Fabric: which way contacts point.
//
//   φ_ij   = <n_i n_j>, φ_ijkl = <n_i n_j n_k n_l>   mean over contacts (of n and −n alike); trace 1        (9.46)
//   F_ij   = (2 NC R / V) φ_ij    [1/m²]   R mean radius, V of the region: the factor of Love and Weber's
//            σ_ij = (2 NC R / V) <f_i n_j> [Pa]; not a pure number                                           (9.47)
//   branch: the same of l/|l|, l from centre to centre; force: <f n_i n_j>/<f> over normal forces f
//   E(n) = (1/4π)(1 + D_ij n_i n_j), D = (15/2)(φ − I/3);  plane (1/2π)(1 + D_ij n_i n_j), D = 4 (φ − I/2)
// Source: physics.md 1.5; D: Kanatani, Int. J. Eng. Sci. 22 (1984) 149. The noise of an isotropic set is ~1/√NC.
// The deviator is φ1 − φ3 where the other two agree (tensor.h), φ1 − φ2 in the plane.
// Cost: O(contacts). Tests: tests/libdem/analysis_fabric.cpp.
#pragma once

#include <array>

#include "libdem/analysis/pairs.h"
#include "libdem/analysis/settings.h"
#include "libdem/analysis/tensor.h"

namespace dem::analysis {

// Sums w d_i d_j … over unit vectors d; a mean of what was added.
class DirectionMoments {
 public:
  void add(const Vec3d& d, double weight = 1);
  double weight() const { return weight_; }
  Mat3d second() const;                             // zero where nothing was added
  double fourth(int i, int j, int k, int l) const;  // the same in any order of the indices

 private:
  double weight_ = 0;
  Mat3d second_{};
  std::array<double, 15> fourth_{};  // by numbers of x and y among the four
};

struct Fabric {
  std::size_t contacts = 0;
  DirectionMoments normals, branches, forces;  // of contacts, of branches, of contacts weighted by normal force
  double mean_branch = 0;                      // m
  double factor = 0;                           // 2 NC R / V of (9.47), 1/m²; 0 where V is
};
// Between bodies; contacts that pull have no weight among `forces`.
Fabric fabric_of(const Snapshot& snapshot, const Pairs& pairs, const Domain& region);
// D of the fit to second order.
Mat3d second_order_fit(const Mat3d& second, int dimension);

Result report_fabric(const Snapshot& snapshot, const Settings& settings);

}  // namespace dem::analysis
