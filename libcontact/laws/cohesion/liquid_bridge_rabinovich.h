// Liquid bridge of two spheres in closed form, a cylinder of liquid between parabolas. R, H, H_r, F0: bridge.h.
//   q = 2V/(π R)                                                  [m²]
//   P = F0 [1 − 1/sqrt(1 + q/H²)] = F0 g/sqrt(H² + q)             [N]    (1)   g(H) = q/(H + sqrt(H² + q))
//   U = −∫P dH from H to H_r = −F0 (g(H) − g(H_r))                [J]    (2)   −F0 δ more where bodies overlap
// (1) for a sphere on a plane, R twice its radius R1, is 4π R1 γ cos θ/(1 + H/d), d = −H + sqrt(H² + V/(π R1)).
// Left out: the pull of the surface along the line of contact, 2π R γ sin α sin(θ + α), α the half-filling angle; the
// viscous force. Source: Pitois, Moucheront & Chateau, J. Colloid Interface Sci. 231 (2000) 26; Rabinovich, Esayanur &
// Moudgil, Langmuir 21 (2005) 10992. Valid for V << R³. Cost: six square roots, a dozen divisions. Test:
// tests/libcontact/laws_cohesion.cpp
#pragma once

#include "libcontact/laws/cohesion/bridge.h"

namespace contact {

struct LiquidBridgeRabinovich {
  static constexpr const char* name = "liquid_bridge_rabinovich";
  static constexpr const char* parameters = "contact_angle (rad)";
  static constexpr const char* remark = "forms on touch, ruptures at (1 + angle/2) V^(1/3); closed form";
  static constexpr const char* source = "Pitois et al. 2000; Rabinovich et al. 2005; rupture: Lian et al. 1993";
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
    const bridge::Seen<T> b = bridge::seen(p, k, o, s);
    const T q = T(2 / std::numbers::pi) * (T(o.bridge_volume) / b.radius);
    const T at = sqrt(b.gap * b.gap + q), end = sqrt(b.rupture * b.rupture + q);
    const T g = q / (b.gap + at), least = q / (b.rupture + end);
    // g(H) − g(H_r), without a difference of large numbers.
    const T fall = (b.rupture - b.gap) * ((g + least) / (at + end));
    return bridge::pull(k, s, b, b.most * (g / at), b.most * fall);  // (1), (2)
  }
};

}  // namespace contact
