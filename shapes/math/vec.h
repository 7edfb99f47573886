// Vectors of three components and 3×3 matrices over any scalar T: double, an extended-precision number, or a SIMD pack.
// Row-major matrices; nothing here allocates. Products are written out, in a fixed order: every T gives the same bits.
#pragma once

#include <cmath>

#include "shapes/math/select.h"

namespace shapes {

template <class T>
struct Vec3 {
  T x{}, y{}, z{};
  constexpr T operator[](int i) const { return i == 0 ? x : (i == 1 ? y : z); }
  constexpr T& operator[](int i) { return i == 0 ? x : (i == 1 ? y : z); }
  constexpr Vec3& operator+=(const Vec3& b) { return *this = {x + b.x, y + b.y, z + b.z}; }
  constexpr Vec3& operator-=(const Vec3& b) { return *this = {x - b.x, y - b.y, z - b.z}; }
  constexpr Vec3& operator*=(const T& s) { return *this = {x * s, y * s, z * s}; }
};

using Vec3d = Vec3<double>;

template <class T>
constexpr Vec3<T> operator+(const Vec3<T>& a, const Vec3<T>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class T>
constexpr Vec3<T> operator-(const Vec3<T>& a, const Vec3<T>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class T>
constexpr Vec3<T> operator-(const Vec3<T>& a) {
  return {-a.x, -a.y, -a.z};
}
template <class T>
constexpr Vec3<T> operator*(const T& s, const Vec3<T>& a) {
  return {s * a.x, s * a.y, s * a.z};
}
template <class T>
constexpr Vec3<T> operator*(const Vec3<T>& a, const T& s) {
  return {a.x * s, a.y * s, a.z * s};
}
template <class T>
constexpr bool operator==(const Vec3<T>& a, const Vec3<T>& b) {
  return a.x == b.x && a.y == b.y && a.z == b.z;
}

// a where the mask is set, b elsewhere; see select.h.
template <class M, class T>
Vec3<T> select(const M& mask, const Vec3<T>& a, const Vec3<T>& b) {
  return {select(mask, a.x, b.x), select(mask, a.y, b.y), select(mask, a.z, b.z)};
}

template <class T>
constexpr T dot(const Vec3<T>& a, const Vec3<T>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class T>
constexpr Vec3<T> cross(const Vec3<T>& a, const Vec3<T>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
// Componentwise product.
template <class T>
constexpr Vec3<T> scaled(const Vec3<T>& a, const Vec3<T>& b) {
  return {a.x * b.x, a.y * b.y, a.z * b.z};
}
template <class T>
T norm(const Vec3<T>& a) {
  using std::sqrt;
  return sqrt(dot(a, a));
}
// Unit vector along a; a must not vanish and its square must neither over- nor underflow (scale first).
template <class T>
Vec3<T> normalized(const Vec3<T>& a) {
  return a * (T(1) / norm(a));
}
inline bool is_finite(const Vec3<double>& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }
template <class T>
constexpr T max_abs(const Vec3<T>& a) {
  const T ax = a.x < T(0) ? -a.x : a.x, ay = a.y < T(0) ? -a.y : a.y, az = a.z < T(0) ? -a.z : a.z;
  const T m = ax > ay ? ax : ay;
  return m > az ? m : az;
}

// Two unit vectors that complete the unit vector n to a right-handed frame (t1, t2, n). Continuous but at n.z = 0-.
// Source: Duff et al., J. Comput. Graph. Tech. 6 (2017) 1.
template <class T>
constexpr void tangent_frame(const Vec3<T>& n, Vec3<T>& t1, Vec3<T>& t2) {
  const T s = n.z < T(0) ? T(-1) : T(1);
  const T a = T(-1) / (s + n.z);
  const T b = n.x * n.y * a;
  t1 = {T(1) + s * n.x * n.x * a, s * b, -s * n.x};
  t2 = {b, s + n.y * n.y * a, -n.y};
}

template <class T>
struct Mat3 {
  Vec3<T> row[3]{};  // row-major
  static constexpr Mat3 identity() { return {{{T(1), T(0), T(0)}, {T(0), T(1), T(0)}, {T(0), T(0), T(1)}}}; }
  static constexpr Mat3 diagonal(const Vec3<T>& d) {
    return {{{d.x, T(0), T(0)}, {T(0), d.y, T(0)}, {T(0), T(0), d.z}}};
  }
  constexpr Vec3<T> column(int j) const { return {row[0][j], row[1][j], row[2][j]}; }
};

using Mat3d = Mat3<double>;

template <class T>
constexpr Vec3<T> operator*(const Mat3<T>& m, const Vec3<T>& v) {
  return {dot(m.row[0], v), dot(m.row[1], v), dot(m.row[2], v)};
}
// mᵀ v
template <class T>
constexpr Vec3<T> transposed_times(const Mat3<T>& m, const Vec3<T>& v) {
  return {m.row[0].x * v.x + m.row[1].x * v.y + m.row[2].x * v.z,
          m.row[0].y * v.x + m.row[1].y * v.y + m.row[2].y * v.z,
          m.row[0].z * v.x + m.row[1].z * v.y + m.row[2].z * v.z};
}
template <class T>
constexpr Mat3<T> transposed(const Mat3<T>& m) {
  return {{m.column(0), m.column(1), m.column(2)}};
}
template <class T>
constexpr Mat3<T> operator*(const Mat3<T>& a, const Mat3<T>& b) {
  Mat3<T> r;
  for (int i = 0; i < 3; ++i) r.row[i] = transposed_times(b, a.row[i]);
  return r;
}

}  // namespace shapes
