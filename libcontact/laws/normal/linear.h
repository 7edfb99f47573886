// Linear spring and dashpot, clipped at zero force or not at all.
//   Fe = kn δ                 [N]      (9.20)
//   cn = 2 β sqrt(m* kn)      [N s/m]  (9.26) with m* for the m in print
//   F  = max(least, Fe + s w cn dδ/dt) (9.24)   s: lag_factor of kinematics.h
//   least = 0 when clipped, else −∞
//   w  = f + ½ in the first step of a contact, of which the part f was spent in contact, else 1: the step's force
//        stands for the time f dt + dt/2; unclipped also in the last one
// Source: Seville & Wu (2016), ch. 9; Cundall & Strack, Géotechnique 29 (1979) 47. β from damping_of(e);
// it is hit within 0.15 % at dt = contact time/50. Cost: two square roots. Tests: tests/libcontact/laws_*.cpp,
// tests/libdem/two_bodies_*.cpp
#pragma once

#include "libcontact/laws/kinematics.h"

namespace contact {

struct Linear {
  static constexpr const char* name = "linear";
  static constexpr double damping_factor = 2;  // c = factor · β sqrt(m* k)
  template <class T>
  struct Pair {
    T stiffness_n, damping;  // kn, β
    T least = T(0);          // N, of the force: 0 or −∞
  };
  template <class T>
  static NormalForce<T> update(const Pair<T>& p, const Kinematics<T>& k) {
    using std::sqrt;
    const T fe = p.stiffness_n * k.overlap;                                         // (9.20)
    const T c0 = T(damping_factor) * p.damping * sqrt(k.mass_eff * p.stiffness_n);  // (9.26)
    const T cn = c0 * lag_factor(c0, k.mass_eff, k.dt, 1.0);
    const T w = select(k.onset > T(0), k.onset + T(0.5), T(1));
    const T f = larger(fe + w * cn * k.closing_speed, p.least);  // (9.24)
    return {f, fe, p.stiffness_n, cn, T(0)};
  }
};

}  // namespace contact
