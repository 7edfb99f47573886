// Spring that loads along one line and unloads along a steeper one: plasticity without a speed (Walton & Braun).
//   k1 = kn,   k2 = k1/e²                                                [N/m]   (9.31)
//   F  = k1 δ                                    loading, δ >= δmax      [N]     (9.29)
//   F  = max(0, k1 δmax − k2 (δmax − δ)) = max(0, k2 (δ − δ0))           [N]     (9.30), below the largest overlap
//   δ0 = (1 − e²) δmax                                                   [m]     (9.32)
//   U  = F²/(2 k2)                               what it gives back      [J]     (1)
//   kt = kn/κ                                                            [N/m]   (9.23), k0 of (9.33) and (9.34)
// e² = k1/k2 at every speed of impact. Loading again runs along k2 up to δmax, then along k1. Between 0 and δ0 the
// force is zero and the memory stays; it is lost where the bodies part (δ <= 0). e = 0: k2 is infinite, no step is
// stable. No dashpot: neither options.clip nor the onset matters. The factor of safety of a step is that of k2. Source:
// Walton & Braun, J. Rheol. 30 (1986) 949; Seville & Wu (2016), ch. 9. Valid for e > 0. Cost: one division. Accuracy:
// rounding of k2 δmax. Tests: tests/libcontact/laws_latching_spring.cpp
#pragma once

#include "libcontact/laws/state.h"

namespace contact {

struct LatchingSpring {
  static constexpr const char* name = "latching_spring";
  static constexpr const char* parameters = "stiffness (N/m), poisson, restitution";
  static constexpr const char* remark = "k1 d loading, k1/e^2 (d - d0) unloading; e at every speed, no dashpot";
  static constexpr const char* source = "Walton & Braun 1986";
  static constexpr Loss loss = Loss::plastic;
  static constexpr double damping_factor = 0;
  template <class T>
  struct State {
    T overlap_max{};  // m
  };

  template <class T>
  static NormalForce<T> update(const PairOf<T>& p, const Kinematics<T>& k, const LawOptions&, State<T>& s) {
    const T k1 = p.stiffness_n, k2 = k1 / p.loading_ratio;  // (9.31)
    const auto below = k.overlap < s.overlap_max;
    s.overlap_max = larger(s.overlap_max, k.overlap);
    const T f = select(below, larger(k1 * s.overlap_max - k2 * (s.overlap_max - k.overlap), T(0)), k1 * k.overlap);
    NormalForce<T> out;
    out.force = f;
    out.elastic = f;
    out.stiffness = k2;
    out.damping = T(0);
    out.stiffness_t = p.stiffness_t;
    out.damping_t = T(0);
    out.holding = f;
    out.shrink = T(1);
    out.energy = T(0.5) * f * (f / k2);  // (1)
    return out;
  }
};

}  // namespace contact
