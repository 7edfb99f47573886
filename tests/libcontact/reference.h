// Signed gaps of smooth pairs in 50 digits, by other formulations than the library's: the oracle of the accuracy tests.
//
// Sphere–ellipsoid: bisection of Σ (a_i y_i/(t + a_i²))² = 1 for t right of the last pole. Ellipsoid–ellipsoid: the
// stationary points of n·d − √(nᵀS_A n) − √(nᵀS_B n) on |n| = 1 as roots of the bordered 4×4 system in (n, λ), started
// from the best local maxima of a scan over directions; the largest value is the gap.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/reference/body.h"

namespace reference {

// Of a sphere or an ellipsoid.
inline Vector semi_axes(const Body& b) {
  return b.kind == Kind::sphere ? exact({b.size.x, b.size.x, b.size.x}) : exact(b.size);
}

// R D² Rᵀ
inline Matrix support_matrix(const Body& b) {
  const Matrix r = b.rotation();
  const Vector a = semi_axes(b);
  return r * Matrix::diagonal(scaled(a, a)) * transposed(r);
}

// n·d − h_A(n) − h_B(n) for a unit n.
inline Real separation(const Body& a, const Body& b, const Vector& d, const Vector& n) {
  using boost::multiprecision::sqrt;
  return dot(n, d) - sqrt(dot(n, support_matrix(a) * n)) - sqrt(dot(n, support_matrix(b) * n));
}

// Signed distance of y from the surface of an ellipsoid in its own frame.
inline Real ellipsoid_distance(const Vector& a, const Vector& y) {
  using boost::multiprecision::abs;
  using boost::multiprecision::sqrt;
  int k = 0;
  for (int i = 1; i < 3; ++i)
    if (a[i] < a[k]) k = i;
  const auto sum = [&](const Real& s) {  // s = t + a_k²
    Real g = 0;
    for (int i = 0; i < 3; ++i)
      if (y[i] != 0) g += pow(a[i] * y[i] / (s + a[i] * a[i] - a[k] * a[k]), 2);
    return g;
  };
  Real low = 0, high = norm(scaled(a, y));
  if (y[k] == 0 && (high == 0 || sum(Real(0)) < 1)) {  // on the medial disc
    Real height = 1, plane_distance = 0;
    for (int i = 0; i < 3; ++i) {
      if (i == k) continue;
      const Real difference = a[i] * a[i] - a[k] * a[k];
      const Real q = y[i] == 0 ? Real(0) : a[i] * y[i] / difference;
      height -= q * q;
      plane_distance += pow(a[i] * q - y[i], 2);
    }
    return -sqrt(plane_distance + a[k] * a[k] * height);
  }
  for (int i = 0; i < 400 && high - low > high * Real("1e-48"); ++i) {
    // By exponent first: the root may lie many decades below the upper end.
    const Real middle =
        low > 0 && low * 4 < high ? Real(sqrt(low * high)) : (low == 0 ? Real(high / 1024) : Real((low + high) / 2));
    (sum(middle) > 1 ? low : high) = middle;
  }
  const Real t = high - a[k] * a[k];
  Vector gradient;
  for (int i = 0; i < 3; ++i) gradient[i] = y[i] / (high + a[i] * a[i] - a[k] * a[k]);
  return t * norm(gradient);
}

// Newton on d − S_A n/h_A − S_B n/h_B − λ n = 0, |n|² = 1. False when it does not settle.
inline bool stationary_point(const Matrix& sa, const Matrix& sb, const Vector& d, Vector& n, Real& value) {
  Real lambda = 0;
  for (int iteration = 0; iteration < 40; ++iteration) {
    const Vector pa = sa * n, pb = sb * n;
    const Real ha = sqrt(dot(n, pa)), hb = sqrt(dot(n, pb));
    const Vector gradient = d - pa * (1 / ha) - pb * (1 / hb);
    if (iteration == 0) lambda = dot(n, gradient);
    Real m[4][5];
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j)
        m[i][j] = -sa.row[i][j] / ha + pa[i] * pa[j] / (ha * ha * ha) - sb.row[i][j] / hb +
                  pb[i] * pb[j] / (hb * hb * hb) - (i == j ? lambda : Real(0));
      m[i][3] = -n[i];
      m[3][i] = n[i];
      m[i][4] = lambda * n[i] - gradient[i];
    }
    m[3][3] = 0;
    m[3][4] = (1 - dot(n, n)) / 2;
    for (int c = 0; c < 4; ++c) {
      int pivot = c;
      for (int r = c + 1; r < 4; ++r)
        if (abs(m[r][c]) > abs(m[pivot][c])) pivot = r;
      if (m[pivot][c] == 0) return false;
      std::swap(m[c], m[pivot]);
      for (int r = 0; r < 4; ++r) {
        if (r == c) continue;
        const Real factor = m[r][c] / m[c][c];
        for (int j = c; j < 5; ++j) m[r][j] -= factor * m[c][j];
      }
    }
    const Vector step = {m[0][4] / m[0][0], m[1][4] / m[1][1], m[2][4] / m[2][2]};
    lambda += m[3][4] / m[3][3];
    n = n + step;
    if (norm(step) > 2) return false;
    n = n * (1 / norm(n));
    if (norm(step) < Real("1e-30")) {
      value = dot(n, d) - sqrt(dot(n, sa * n)) - sqrt(dot(n, sb * n));
      return true;
    }
  }
  return false;
}

// Local maxima of the separation over a scan of directions, climbed by halving compass steps; best first.
inline std::vector<Vec3d> scan(const Body& a, const Body& b, const Vec3d& d, int directions, std::size_t keep) {
  const contact::Body pa = a.placed(), pb = b.placed();
  const Vec3d ea = a.kind == Kind::sphere ? Vec3d{a.size.x, a.size.x, a.size.x} : a.size;
  const auto f = [&](const Vec3d& n) {
    return dot(n, d) - norm(scaled(ea, transposed_times(pa.rotation, n))) -
           norm(scaled(b.size, transposed_times(pb.rotation, n)));
  };
  std::vector<std::pair<double, Vec3d>> found;
  for (int i = 0; i < directions; ++i) {
    const double z = 1 - (2 * i + 1.0) / directions, r = std::sqrt(1 - z * z), angle = 2.399963229728653 * i;
    const Vec3d n{r * std::cos(angle), r * std::sin(angle), z};
    found.push_back({f(n), n});
  }
  for (const contact::Body* body : {&pa, &pb})
    for (int j = 0; j < 3; ++j)
      for (const double sign : {1.0, -1.0})
        found.push_back({f(sign * body->rotation.column(j)), sign * body->rotation.column(j)});
  std::sort(found.begin(), found.end(), [](const auto& x, const auto& y) { return x.first > y.first; });
  std::vector<std::pair<double, Vec3d>> best;
  for (auto [value, n] : found) {
    if (best.size() >= keep) break;
    if (std::any_of(best.begin(), best.end(), [&](const auto& x) { return dot(x.second, n) > 0.995; })) continue;
    double step = 0.05;
    for (int moves = 0; step > 1e-9 && moves < 2000; ++moves) {
      Vec3d t1, t2;
      tangent_frame(n, t1, t2);
      bool moved = false;
      for (int k = 0; k < 8; ++k) {
        const double angle = 0.7853981633974483 * k;
        const Vec3d m = normalized(n + step * (std::cos(angle) * t1 + std::sin(angle) * t2));
        if (const double fm = f(m); fm > value) {
          value = fm;
          n = m;
          moved = true;
        }
      }
      step *= moved ? 1.5 : 0.4;
    }
    best.push_back({value, n});
  }
  std::sort(best.begin(), best.end(), [](const auto& x, const auto& y) { return x.first > y.first; });
  std::vector<Vec3d> result;
  for (const auto& x : best) result.push_back(x.second);
  return result;
}

inline Real ellipsoid_gap(const Body& a, const Body& b, const Vec3d& offset, std::size_t starts = 6) {
  const Matrix sa = support_matrix(a), sb = support_matrix(b);
  const Vector d = exact(offset);
  Real best = Real("-1e300");
  for (const Vec3d& start : scan(a, b, offset, 1000, starts)) {
    Vector n = exact(start);
    n = n * (1 / norm(n));
    best = std::max(best, separation(a, b, d, n));
    Real value;
    if (stationary_point(sa, sb, d, n, value)) best = std::max(best, value);
  }
  return best;
}

// Signed gap of a smooth pair in kind order, from A's origin.
inline Real gap(const Body& a, const Body& b, const Vec3d& offset) {
  const Vector d = exact(offset);
  if (b.kind == Kind::plane) {
    const Vector normal = b.rotation().column(2);
    return -dot(normal, d) - norm(scaled(semi_axes(a), transposed_times(a.rotation(), normal)));
  }
  if (b.kind == Kind::sphere) return norm(d) - Real(a.size.x) - Real(b.size.x);
  if (a.kind == Kind::sphere)
    return ellipsoid_distance(semi_axes(b), transposed_times(b.rotation(), d)) - Real(a.size.x);
  return ellipsoid_gap(a, b, offset);
}

}  // namespace reference
