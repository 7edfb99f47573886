// Hertz contact of smooth elastic bodies with Tsuji's dashpot, clipped at zero force or not at all.
//   a  = sqrt(R* δ)                      contact radius     [m]     (8.12)
//   Fe = 4/3 E* a δ                      elastic force      [N]     (9.6)
//   kn = dFe/dδ = 2 E* a                 tangent stiffness  [N/m]   (9.7)
//   cn = 2 sqrt(5/6) β sqrt(m* kn)       dashpot            [N s/m] (9.26) with the factor that Hertz needs
//   F  = max(least, Fe + s w cn dδ/dt)                      [N]     s: lag_factor of kinematics.h
//   least = 0 when clipped, else −∞
//   w  = (4/5)(f + ½) ((f + ½)/f)^¼ in the first step of a contact, of which the part f was spent in contact, else 1:
//        the step's force stands for the time f dt + dt/2, in which the dashpot's grows as t^¼; unclipped also in the
//        last one
// Source: Seville & Wu, Particle Technology and Engineering (2016), ch. 9; Tsuji, Tanaka, Ishida, Powder Technol. 71
// (1992) 239. Valid a << R*. With β from damping_of(e) the rebound speed ratio is e at every impact speed, within
// 0.2 % at dt = contact time/50. Cost: five square roots. Tests: tests/libcontact/laws_*.cpp,
// tests/libdem/two_bodies_*.cpp
#pragma once

#include "libcontact/laws/kinematics.h"

namespace contact {

struct Hertz {
  static constexpr const char* name = "hertz";
  static constexpr double damping_factor = 1.8257418583505538;  // 2 sqrt(5/6): c = factor · β sqrt(m* k)
  template <class T>
  struct Pair {
    T young_eff, damping;  // E*, β
    T least = T(0);        // N, of the force: 0 or −∞
  };
  template <class T>
  static NormalForce<T> update(const Pair<T>& p, const Kinematics<T>& k) {
    using std::sqrt;
    const T a = sqrt(k.radius_eff * k.overlap);  // (8.12)
    const T kn = T(2) * p.young_eff * a;         // (9.7)
    const T fe = T(2.0 / 3.0) * kn * k.overlap;  // (9.6)
    const T c0 = T(damping_factor) * p.damping * sqrt(k.mass_eff * kn);
    const T cn = c0 * lag_factor(c0, k.mass_eff, k.dt, 10.0 / 11.0);
    const auto begins = k.onset > T(0);
    const T x = select(begins, k.onset, T(1)), since = x + T(0.5);
    const T w = select(begins, T(0.8) * since * sqrt(sqrt(since / x)), T(1));
    const T f = larger(fe + w * cn * k.closing_speed, p.least);
    return {f, fe, kn, cn, a};
  }
};

}  // namespace contact
