// Hertz contact of smooth elastic bodies with Tsuji's dashpot, clipped at zero force.
//   a  = sqrt(R* δ)                      contact radius     [m]     (8.12)
//   Fe = 4/3 E* a δ                      elastic force      [N]     (9.6)
//   kn = dFe/dδ = 2 E* a                 tangent stiffness  [N/m]   (9.7)
//   cn = 2 sqrt(5/6) β sqrt(m* kn)       dashpot            [N s/m] (9.26) with the factor that Hertz needs
//   F  = max(0, Fe + cn dδ/dt)                              [N]
// Source: Seville & Wu, Particle Technology and Engineering (2016), ch. 9; Tsuji, Tanaka, Ishida, Powder Technol. 71
// (1992) 239. Valid a << R*. With β from clipped_damping(e) the rebound speed ratio is e at every impact speed. Cost:
// two square roots. Tests: tests/libcontact/laws.cpp, tests/libdem/two_bodies.cpp
#pragma once

#include "libcontact/laws/kinematics.h"

namespace contact {

struct Hertz {
  static constexpr const char* name = "hertz";
  template <class T>
  struct Pair {
    T young_eff, damping;  // E*, β
  };
  template <class T>
  static NormalForce<T> update(const Pair<T>& p, const Kinematics<T>& k) {
    using std::sqrt;
    const T a = sqrt(k.radius_eff * k.overlap);                              // (8.12)
    const T kn = T(2) * p.young_eff * a;                                     // (9.7)
    const T fe = T(2.0 / 3.0) * kn * k.overlap;                              // (9.6)
    const T cn = T(1.8257418583505538) * p.damping * sqrt(k.mass_eff * kn);  // 2 sqrt(5/6)
    const T f = larger(fe + cn * k.closing_speed, T(0));
    return {f, fe, kn, cn, a};
  }
};

}  // namespace contact
