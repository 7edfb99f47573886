#include "tests/reference/climb.h"

#include <cmath>
#include <type_traits>

namespace reference {
namespace {

using std::sqrt;

template <class T>
void local(const Piece<T>& p, const shapes::Vec3<T>& n, shapes::Vec3<T>& point, shapes::Mat3<T>& hessian) {
  hessian = shapes::Mat3<T>{};
  if (p.corner != nullptr)
    point = *p.corner;
  else
    p.core->at(n, point, hessian);
}

template <class T>
struct Local {
  shapes::Vec3<T> w;
  shapes::Mat3<T> hessian;
  T f;
};

template <class T>
Local<T> local(const Piece<T>& a, const Piece<T>& b, const shapes::Vec3<T>& d, const shapes::Vec3<T>& n) {
  shapes::Vec3<T> xa, xb;
  shapes::Mat3<T> ha, hb;
  local(a, n, xa, ha);
  local(b, -n, xb, hb);
  Local<T> at{d + xb - xa, ha, T(0)};
  for (int i = 0; i < 3; ++i) at.hessian.row[i] += hb.row[i];
  at.f = dot(n, at.w);
  return at;
}

}  // namespace

template <class T>
shapes::Vec3<T> climb(const Piece<T>& a, const Piece<T>& b, const shapes::Vec3<T>& d, shapes::Vec3<T> n,
                      const shapes::Vec3<T>* axis) {
  const T tiny = std::is_same_v<T, double> ? T(1e-15) : T(1e-36);
  Local<T> at = local(a, b, d, n);
  for (int iteration = 0; iteration < 80; ++iteration) {
    shapes::Vec3<T> t1, t2;
    if (axis != nullptr)
      t1 = cross(*axis, n), t2 = {};
    else
      tangent_frame(n, t1, t2);
    const T r1 = dot(t1, at.w), r2 = dot(t2, at.w);
    if (r1 * r1 + r2 * r2 < tiny * tiny) break;
    T k11 = dot(t1, at.hessian * t1) + at.f, k12 = dot(t1, at.hessian * t2),
      k22 = axis != nullptr ? T(1) : T(dot(t2, at.hessian * t2) + at.f);
    // Not a maximum of the quadratic model: shifted until it is one.
    const T trace = (k11 + k22) / 2;
    const T spread = sqrt((k11 - k22) * (k11 - k22) / 4 + k12 * k12);
    if (axis != nullptr) {
      if (k11 <= 0) k11 = -k11 + norm(at.w) / 4;
    } else if (trace - spread <= 0) {
      const T shift = 2 * (spread - trace) + norm(at.w) / 16;
      k11 += shift, k22 += shift;
    }
    const T determinant = k11 * k22 - k12 * k12;
    T s1 = (k22 * r1 - k12 * r2) / determinant, s2 = (k11 * r2 - k12 * r1) / determinant;
    const T length = sqrt(s1 * s1 + s2 * s2);
    if (length > 1) s1 /= length, s2 /= length;
    bool moved = false;
    for (int halving = 0; halving < 60 && !moved; ++halving, s1 /= 2, s2 /= 2) {
      const shapes::Vec3<T> next = normalized(n + s1 * t1 + s2 * t2);
      const Local<T> there = local(a, b, d, next);
      if (there.f < at.f) continue;
      moved = true;
      n = next;
      at = there;
    }
    if (!moved) break;
  }
  return n;
}

template shapes::Vec3d climb(const Piece<double>&, const Piece<double>&, const shapes::Vec3d&, shapes::Vec3d,
                             const shapes::Vec3d*);
template Vector climb(const Piece<Real>&, const Piece<Real>&, const Vector&, Vector, const Vector*);

}  // namespace reference
