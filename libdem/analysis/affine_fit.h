// The linear field that fits best what neighbours do: Σ |u − G x|² least.
//
//   G = (Σ u xᵀ)(Σ x xᵀ)⁻¹                                                                                       (1)
//   left over: Σ |u − G x|²/n = (Σ |u|² − G : Σ u xᵀ)/n, of displacements the D²min over n                         (2)
// Source: Falk and Langer, Phys. Rev. E 57 (1998) 7192. Nothing where the x do not span the space: the least
// eigenvalue of Σ x xᵀ below 1e-6 of the largest. Accuracy: a few ulp times the condition of that sum.
// Tests: tests/libdem/analysis_displacement.cpp.
#pragma once

#include <optional>

#include "libdem/analysis/tensor.h"

namespace dem::analysis {

class AffineFit {
 public:
  void add(const Vec3d& x, const Vec3d& u);  // both relative to the same body, or to their means
  std::size_t count() const { return count_; }
  std::optional<Mat3d> gradient(int dimension) const;  // (1): row i, column j: ∂u_i/∂x_j
  double left_over(const Mat3d& gradient) const;       // (2), >= 0

 private:
  Mat3d xx_{}, ux_{};
  double uu_ = 0;
  std::size_t count_ = 0;
};

Vec3d curl_of(const Mat3d& gradient);
// Of displacements: (FᵀF − I)/2 with F = I + G, Green and Lagrange's strain.
Mat3d finite_strain(const Mat3d& gradient);
// det(I + G) − 1: change of volume over the volume; in the plane of area.
double volume_change(const Mat3d& gradient);

}  // namespace dem::analysis
