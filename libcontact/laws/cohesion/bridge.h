// What the laws of liquid bridges share: a bridge forms on touch and holds until it ruptures.
//   R = 2 R* = 2 R1 R2/(R1 + R2)                        [m]   (1)   a sphere on a plane: twice its radius
//   H = max(−δ, 0)                                      [m]   (2)   the gap; where bodies overlap the pull is that at 0
//   wet once δ >= 0, dry again once H >= H_r = (1 + θ/2) V^(1/3)    (3)   θ: contact angle, V: volume of one bridge
//   F0 = 2π R γ max(cos θ, 0)                           [N]   (4)   the pull at H = 0; γ: surface tension
// A bridge has the same volume at every contact and forms anew at every touch: liquid is neither carried nor used up.
// Source: (1) Derjaguin's approximation; (3) Lian, Thornton & Adams, J. Colloid Interface Sci. 161 (1993) 138.
// Test: tests/libcontact/laws_cohesion.cpp
#pragma once

#include <numbers>

#include "libcontact/laws/state.h"
#include "shapes/math/cube_root.h"

namespace contact {

template <class T>
struct BridgeState {
  T wet{};  // 1: there is a bridge
};

namespace bridge {

// V^(1/3), m; the root is of V/R³, so that a change of units keeps the bits.
template <class T>
T side(const T& volume, const T& radius) {
  return radius * shapes::cube_root<T>(volume / (radius * radius * radius));
}

// What a law needs of its bridge, after the memory has been brought up to date. All finite in dry lanes too.
template <class T>
struct Seen {
  T radius{};   // R (1), m
  T gap{};      // H, at most H_r, m
  T rupture{};  // H_r, m
  T most{};     // F0 (4) where wet, else 0, N
};

template <class T>
Seen<T> seen(const PairOf<T>& p, const Kinematics<T>& k, const LawOptions& o, BridgeState<T>& s) {
  Seen<T> b;
  b.radius = T(2) * k.radius_eff;                                                      // (1)
  b.rupture = (T(1) + T(0.5) * p.contact_angle) * side(T(o.bridge_volume), b.radius);  // (3)
  const T gap = larger(-k.overlap, T(0));                                              // (2)
  const auto holds = gap < b.rupture;
  s.wet = select(k.overlap >= T(0), T(1), select(holds, s.wet, T(0)));  // (3)
  b.gap = select(holds, gap, b.rupture);
  b.most = s.wet * (T(2 * std::numbers::pi) * b.radius * T(o.surface_tension) * larger(p.wetting, T(0)));  // (4)
  return b;
}

inline double range(const PairParameters& p, const LawOptions& o, double radius_eff) {
  return o.bridge_volume > 0 ? (1 + 0.5 * p.contact_angle) * side(o.bridge_volume, 2 * radius_eff) : 0;
}

// The force at H and the work from H to rupture, of a bridge; below zero gap the pull stays and the work goes on.
template <class T>
Pull<T> pull(const Kinematics<T>& k, const BridgeState<T>& s, const Seen<T>& b, const T& force, const T& work) {
  Pull<T> out;
  out.force = force;
  out.energy = -(work + b.most * larger(k.overlap, T(0)));
  out.bond = s.wet;
  return out;
}

}  // namespace bridge
}  // namespace contact
