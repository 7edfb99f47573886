// Liquid bridge of two spheres, Willett's fit of solutions of Young and Laplace's equation. R, H, H_r, F0: bridge.h.
//   s = H sqrt(R/V),  s_r = H_r sqrt(R/V)
//   P = F0/(1 + 1.05 s + 2.5 s²)                                                            [N]   (1)
//   U = −∫P dH from H to H_r = −F0 sqrt(V/R) (2/Δ) atan(t),  Δ² = 10 − 1.05²,               [J]   (2)
//       t = (5 (s_r − s)/Δ)/(1 + (5 s + 1.05)(5 s_r + 1.05)/Δ²);  −F0 δ more where bodies overlap
// The bridge is quasi-static; no viscous force. At rupture the pull ends with a jump, the energy does not.
// Source: Willett, Adams, Johnson & Seville, Langmuir 16 (2000) 9396; (1) in the form of Herminghaus, Adv. Phys. 54
// (2005) 221. Valid for V << R³ (1e-3 and less) and θ below 50°; unlike spheres by Derjaguin's approximation.
// Cost: eight square roots, a dozen divisions. Accuracy of (2): 4e-15. Test: tests/libcontact/laws_cohesion.cpp
#pragma once

#include "libcontact/laws/cohesion/bridge.h"
#include "shapes/math/arc_tangent.h"

namespace contact {

struct LiquidBridge {
  static constexpr const char* name = "liquid_bridge";
  static constexpr const char* parameters = "contact_angle (rad)";
  static constexpr const char* remark = "forms on touch, ruptures at (1 + angle/2) V^(1/3); Willett's fit";
  static constexpr const char* source = "Willett et al. 2000; rupture: Lian, Thornton & Adams 1993";
  template <class T>
  using State = BridgeState<T>;
  static double range(const PairParameters& p, const LawOptions& o, double radius_eff) {
    return bridge::range(p, o, radius_eff);
  }

  template <class T>
  static Pull<T> update(const PairOf<T>& p, const Kinematics<T>& k, const NormalForce<T>&, const LawOptions& o,
                        State<T>& s) {
    using std::sqrt;
    if (!(o.bridge_volume > 0)) return {};
    const double delta = 2.9828677476549308;  // Δ
    const bridge::Seen<T> b = bridge::seen(p, k, o, s);
    const T unit = sqrt(T(o.bridge_volume) / b.radius);              // m
    const T at = b.gap / unit, end = b.rupture / unit;               // s, s_r
    const T force = b.most / (T(1) + at * (T(1.05) + T(2.5) * at));  // (1)
    const T t = (T(5 / delta) * ((b.rupture - b.gap) / unit)) /
                (T(1) + (T(5) * at + T(1.05)) * (T(5) * end + T(1.05)) * T(1 / (delta * delta)));
    const T work = b.most * unit * (T(2 / delta) * shapes::arc_tangent(t));  // (2)
    return bridge::pull(k, s, b, force, work);
  }
};

}  // namespace contact
