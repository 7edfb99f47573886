// Free rotation of a rigid body over a step, by symmetric splitting about the principal axes.
//   H = Σ πᵢ²/(2 Iᵢ):  x(h/2) y(h/2) z(h) y(h/2) x(h/2), each a rotation about one principal axis            (1)
// The state is the angular momentum in world axes, which free motion leaves alone: |L| is kept to the last bit, only
// the orientation moves. Each rotation by the angle φ is done as the Cayley map tan(φ'/2) = φ/2: an angle that depends
// on the conserved πᵢ alone, so the map stays symplectic and reversible, of second order, and needs no trigonometry.
// Source of the splitting: Dullweber, Leimkuhler, McLachlan, J. Chem. Phys. 107 (1997) 5840. Error O(h²), energy
// without drift. Over any scalar: double, or lanes across bodies (bodies.kernel.cpp), with the same bits. Cost about
// 150 flops. Tests: tests/libdem/rotation.cpp
#pragma once

#include "shapes/math/quat.h"

namespace dem {

using shapes::Quatd;
using shapes::Vec3d;

namespace detail {
// Turns q by the angle w·h about body axis `axis`, and the body-frame momentum the other way.
template <int axis, class T>
void turn_about(const T& angle, shapes::Quat<T>& q, shapes::Vec3<T>& pi) {
  constexpr int j = (axis + 1) % 3, k = (axis + 2) % 3;
  const T t = T(0.5) * angle, s = T(1) / (T(1) + t * t);
  const T c1 = (T(1) - t * t) * s, s1 = (t + t) * s;
  const T pj = pi[j], pk = pi[k];
  pi[j] = c1 * pj + s1 * pk;
  pi[k] = c1 * pk - s1 * pj;
  // q times (1, t about the axis); normalised once at the end: the factor sqrt(1 + t²) drops out there.
  const shapes::Vec3<T> v{q.x, q.y, q.z};
  shapes::Vec3<T> turned;
  turned[axis] = v[axis] + q.w * t;
  turned[j] = v[j] + v[k] * t;
  turned[k] = v[k] - v[j] * t;
  q = {q.w - v[axis] * t, turned.x, turned.y, turned.z};
}
}  // namespace detail

// Orientation after h at angular momentum L (world), principal inertia (all > 0).
template <class T>
shapes::Quat<T> rotated_freely(const shapes::Quat<T>& orientation, const shapes::Vec3<T>& momentum,
                               const shapes::Vec3<T>& inertia, double h) {
  shapes::Quat<T> q = orientation;
  shapes::Vec3<T> pi = shapes::transposed_times(shapes::rotation_matrix(q), momentum);
  const T half(0.5 * h), of_x = half / inertia.x, of_y = half / inertia.y, of_z = T(h) / inertia.z;
  detail::turn_about<0>(of_x * pi.x, q, pi);
  detail::turn_about<1>(of_y * pi.y, q, pi);
  detail::turn_about<2>(of_z * pi.z, q, pi);
  detail::turn_about<1>(of_y * pi.y, q, pi);
  detail::turn_about<0>(of_x * pi.x, q, pi);
  return shapes::normalized(q);
}

// The same for a body of equal moments: one rotation about ω, also by the Cayley map.
template <class T>
shapes::Quat<T> rotated_uniformly(const shapes::Quat<T>& q, const shapes::Vec3<T>& spin, double h) {
  const shapes::Vec3<T> t = spin * T(0.5 * h);
  return shapes::normalized(shapes::Quat<T>{T(1), t.x, t.y, t.z} * q);
}

// ω = R I⁻¹ Rᵀ L
template <class T>
shapes::Vec3<T> spin_of(const shapes::Quat<T>& orientation, const shapes::Vec3<T>& momentum,
                        const shapes::Vec3<T>& inertia) {
  const shapes::Mat3<T> r = shapes::rotation_matrix(orientation);
  const shapes::Vec3<T> pi = shapes::transposed_times(r, momentum);
  return r * shapes::Vec3<T>{pi.x / inertia.x, pi.y / inertia.y, pi.z / inertia.z};
}

}  // namespace dem
