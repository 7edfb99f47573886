// Free rotation of a rigid body over a step, by symmetric splitting about the principal axes.
//   H = Σ πᵢ²/(2 Iᵢ):  x(h/2) y(h/2) z(h) y(h/2) x(h/2), each a rotation about one principal axis            (1)
// The state is the angular momentum in world axes, which free motion leaves alone: |L| is kept to the last bit, only
// the orientation moves. Each rotation by the angle φ is done as the Cayley map tan(φ'/2) = φ/2: an angle that depends
// on the conserved πᵢ alone, so the map stays symplectic and reversible, of second order, and needs no trigonometry.
// Source of the splitting: Dullweber, Leimkuhler, McLachlan, J. Chem. Phys. 107 (1997) 5840. Error O(h²), energy
// without drift. Cost about 150 flops. Tests: tests/libdem/rotation.cpp
#pragma once

#include "shapes/math/quat.h"

namespace dem {

using shapes::Quatd;
using shapes::Vec3d;

namespace detail {
// Turns q by the angle w·h about body axis `axis`, and the body-frame momentum the other way.
inline void turn_about(int axis, double angle, Quatd& q, Vec3d& pi) {
  const double t = 0.5 * angle, s = 1 / (1 + t * t);
  const double c1 = (1 - t * t) * s, s1 = (t + t) * s;
  const int j = (axis + 1) % 3, k = (axis + 2) % 3;
  const double pj = pi[j], pk = pi[k];
  pi[j] = c1 * pj + s1 * pk;
  pi[k] = c1 * pk - s1 * pj;
  Quatd r{1, 0, 0, 0};
  (axis == 0 ? r.x : axis == 1 ? r.y : r.z) = t;
  q = q * r;  // normalised once at the end: the factor sqrt(1 + t²) drops out there
}
}  // namespace detail

// Orientation after h at angular momentum L (world), principal inertia (all > 0).
inline Quatd rotated_freely(const Quatd& orientation, const Vec3d& momentum, const Vec3d& inertia, double h) {
  Quatd q = orientation;
  Vec3d pi = shapes::transposed_times(shapes::rotation_matrix(q), momentum);
  detail::turn_about(0, 0.5 * h * pi.x / inertia.x, q, pi);
  detail::turn_about(1, 0.5 * h * pi.y / inertia.y, q, pi);
  detail::turn_about(2, h * pi.z / inertia.z, q, pi);
  detail::turn_about(1, 0.5 * h * pi.y / inertia.y, q, pi);
  detail::turn_about(0, 0.5 * h * pi.x / inertia.x, q, pi);
  return shapes::normalized(q);
}

// The same for a body of equal moments: one rotation about ω, also by the Cayley map.
inline Quatd rotated_uniformly(const Quatd& q, const Vec3d& spin, double h) {
  const Vec3d t = spin * (0.5 * h);
  return shapes::normalized(Quatd{1, t.x, t.y, t.z} * q);
}

// ω = R I⁻¹ Rᵀ L
inline Vec3d spin_of(const Quatd& orientation, const Vec3d& momentum, const Vec3d& inertia) {
  const shapes::Mat3d r = shapes::rotation_matrix(orientation);
  const Vec3d pi = shapes::transposed_times(r, momentum);
  return r * Vec3d{pi.x / inertia.x, pi.y / inertia.y, pi.z / inertia.z};
}

}  // namespace dem
