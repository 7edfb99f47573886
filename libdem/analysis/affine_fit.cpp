#include "libdem/analysis/affine_fit.h"

#include <Eigen/Dense>
#include <algorithm>

namespace dem::analysis {

namespace {

constexpr double flat = 1e-6;

template <int N>
std::optional<Mat3d> solve(const Mat3d& xx, const Mat3d& ux) {
  Eigen::Matrix<double, N, N> a, b;
  for (int i = 0; i < N; ++i)
    for (int j = 0; j < N; ++j) {
      a(i, j) = xx.row[i][j];
      b(i, j) = ux.row[j][i];  // transposed: a Gᵀ = b
    }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, N, N>> spectrum(a, Eigen::EigenvaluesOnly);
  const auto& values = spectrum.eigenvalues();
  if (!(values[0] > flat * values[N - 1])) return std::nullopt;
  const Eigen::Matrix<double, N, N> g = a.ldlt().solve(b);
  Mat3d result{};
  for (int i = 0; i < N; ++i)
    for (int j = 0; j < N; ++j) result.row[i][j] = g(j, i);
  return result;
}

}  // namespace

void AffineFit::add(const Vec3d& x, const Vec3d& u) {
  add_to(xx_, outer(x, x));
  add_to(ux_, outer(u, x));
  uu_ += dot(u, u);
  ++count_;
}

std::optional<Mat3d> AffineFit::gradient(int dimension) const {
  return dimension == 3 ? solve<3>(xx_, ux_) : solve<2>(xx_, ux_);
}

double AffineFit::left_over(const Mat3d& g) const {
  double fitted = 0;
  for (int i = 0; i < 3; ++i) fitted += dot(g.row[i], ux_.row[i]);
  return count_ > 0 ? std::max(uu_ - fitted, 0.0) / static_cast<double>(count_) : 0;
}

Vec3d curl_of(const Mat3d& g) { return {g.row[2].y - g.row[1].z, g.row[0].z - g.row[2].x, g.row[1].x - g.row[0].y}; }

Mat3d finite_strain(const Mat3d& g) {
  Mat3d e = transposed(g) * g;
  add_to(e, g);
  add_to(e, transposed(g));
  for (Vec3d& row : e.row) row *= 0.5;
  return e;
}

double volume_change(const Mat3d& g) {
  Mat3d f = Mat3d::identity();
  add_to(f, g);
  return dot(f.row[0], cross(f.row[1], f.row[2])) - 1;
}

}  // namespace dem::analysis
