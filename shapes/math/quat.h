// Unit quaternions (w, x, y, z) and rigid poses. x_world = R(q) x_body + position.
#pragma once

#include "shapes/math/vec.h"

namespace shapes {

template <class T>
struct Quat {
  T w{T(1)}, x{T(0)}, y{T(0)}, z{T(0)};
};
using Quatd = Quat<double>;

// Hamilton product: rotation b first, then a.
template <class T>
constexpr Quat<T> operator*(const Quat<T>& a, const Quat<T>& b) {
  return {a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z, a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
          a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x, a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w};
}
template <class T>
constexpr Quat<T> conjugate(const Quat<T>& q) {
  return {q.w, -q.x, -q.y, -q.z};
}
template <class T>
Quat<T> normalized(const Quat<T>& q) {
  using std::sqrt;
  const T s = T(1) / sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
  return {q.w * s, q.x * s, q.y * s, q.z * s};
}
// Rotation matrix of a unit quaternion; error a few ulp.
template <class T>
constexpr Mat3<T> rotation_matrix(const Quat<T>& q) {
  const T x2 = q.x + q.x, y2 = q.y + q.y, z2 = q.z + q.z;
  const T xx = q.x * x2, yy = q.y * y2, zz = q.z * z2, xy = q.x * y2, xz = q.x * z2, yz = q.y * z2;
  const T wx = q.w * x2, wy = q.w * y2, wz = q.w * z2;
  return {{{T(1) - (yy + zz), xy - wz, xz + wy},
           {xy + wz, T(1) - (xx + zz), yz - wx},
           {xz - wy, yz + wx, T(1) - (xx + yy)}}};
}
template <class T>
constexpr Vec3<T> rotate(const Quat<T>& q, const Vec3<T>& v) {
  return rotation_matrix(q) * v;
}

struct Pose {
  Vec3d position;     // m
  Quatd orientation;  // unit
};

}  // namespace shapes
