#include "libdem/analysis/tensor.h"

#include <Eigen/Dense>
#include <cmath>

#include "libdem/analysis/table.h"

namespace dem::analysis {

namespace {

Vec3d upright(const Vec3d& v) {  // of v and −v the one whose largest component is positive
  int largest = 0;
  for (int k = 1; k < 3; ++k)
    if (std::abs(v[k]) > std::abs(v[largest]) * (1 + 1e-9)) largest = k;
  return v[largest] < 0 ? -v : v;
}

template <int N>
void solve(const Mat3d& m, Principal& p) {
  Eigen::Matrix<double, N, N> e;
  for (int i = 0; i < N; ++i)
    for (int j = 0; j < N; ++j) e(i, j) = 0.5 * (m.row[i][j] + m.row[j][i]);
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, N, N>> solver(e);
  for (int k = 0; k < N; ++k) {
    const auto at = static_cast<std::size_t>(N - 1 - k);
    p.value[at] = solver.eigenvalues()[k];
    Vec3d v{};
    for (int i = 0; i < N; ++i) v[i] = solver.eigenvectors()(i, k);
    p.axis[at] = upright(v);
  }
}

}  // namespace

Principal principal_of(const Mat3d& m, int dimension) {
  Principal p;
  if (dimension == 3) {
    solve<3>(m, p);
  } else {
    solve<2>(m, p);
    p.value[2] = m.row[2].z;
    p.axis[2] = {0, 0, 1};
  }
  return p;
}

double deviator(const Mat3d& m, int dimension) {
  double mean = 0, square = 0;
  for (int i = 0; i < dimension; ++i) mean += m.row[i][i] / dimension;
  for (int i = 0; i < dimension; ++i)
    for (int j = 0; j < dimension; ++j) {
      const double d = 0.5 * (m.row[i][j] + m.row[j][i]) - (i == j ? mean : 0);
      square += d * d;
    }
  return std::sqrt((dimension == 3 ? 1.5 : 2.0) * square);
}

Mat3d outer(const Vec3d& a, const Vec3d& b) { return {{b * a.x, b * a.y, b * a.z}}; }

void add_to(Mat3d& sum, const Mat3d& term, double factor) {
  for (int i = 0; i < 3; ++i) sum.row[i] += term.row[i] * factor;
}

double trace(const Mat3d& m) { return m.row[0].x + m.row[1].y + m.row[2].z; }

void add_tensor(Result& result, const std::string& name, const std::string& unit, const Mat3d& m, int dimension) {
  const auto component = [&](int i, int j) {
    result.add(name + "_" + "xyz"[i] + "xyz"[j], unit, 0.5 * (m.row[i][j] + m.row[j][i]));
  };
  for (int i = 0; i < dimension; ++i) component(i, i);
  for (int i = 0; i < dimension; ++i)
    for (int j = i + 1; j < dimension; ++j) component(i, j);
  const Principal p = principal_of(m, dimension);
  for (int k = 0; k < dimension; ++k)
    result.add(name + "_" + std::to_string(k + 1), unit, p.value[static_cast<std::size_t>(k)]);
  result.add(name + "_deviator", unit, deviator(m, dimension));
}

Table axes_table(const std::string& name, const std::string& title, const std::string& unit, const Principal& p,
                 int dimension) {
  Table t = table_of(name, title, {{"value", unit}, {"x", "1"}, {"y", "1"}, {"z", "1"}});
  for (std::size_t k = 0; k < static_cast<std::size_t>(dimension); ++k) {
    add_row(t, p.value[k], p.axis[k].x, p.axis[k].y, p.axis[k].z);
  }
  return t;
}

}  // namespace dem::analysis
