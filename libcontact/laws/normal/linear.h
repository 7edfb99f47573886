// Linear spring and dashpot, clipped at zero force.
//   Fe = kn δ                 [N]      (9.20)
//   cn = 2 β sqrt(m* kn)      [N s/m]  (9.26) with m* for the m in print
//   F  = max(0, Fe + cn dδ/dt)         (9.24)
// Source: Seville & Wu (2016), ch. 9; Cundall & Strack, Géotechnique 29 (1979) 47. β from clipped_damping(e).
// Cost: one square root. Tests: tests/libcontact/laws.cpp, tests/libdem/two_bodies.cpp
#pragma once

#include "libcontact/laws/kinematics.h"

namespace contact {

struct Linear {
  static constexpr const char* name = "linear";
  template <class T>
  struct Pair {
    T stiffness_n, damping;  // kn, β
  };
  template <class T>
  static NormalForce<T> update(const Pair<T>& p, const Kinematics<T>& k) {
    using std::sqrt;
    const T fe = p.stiffness_n * k.overlap;                            // (9.20)
    const T cn = T(2) * p.damping * sqrt(k.mass_eff * p.stiffness_n);  // (9.26)
    const T f = larger(fe + cn * k.closing_speed, T(0));               // (9.24)
    return {f, fe, p.stiffness_n, cn, T(0)};
  }
};

}  // namespace contact
