// Linear spring and dashpot, clipped at zero force or not at all.
//   Fe = kn δ                 [N]      (9.20)
//   cn = 2 β sqrt(m* kn)      [N s/m]  (9.26) with m* for the m in print
//   F  = max(least, Fe + s w cn dδ/dt) (9.24)   s: lagging_dashpot of kinematics.h
//   kt = kn / κ               [N/m]    (9.23);  ct = 2 β sqrt(m* kt)  (9.27)
//   least = 0 when clipped, else −∞
//   w  = f + ½ in the first step of a contact, of which the part f was spent in contact, else 1: the step's force
//        stands for the time f dt + dt/2; unclipped also in the last one
// Source: Seville & Wu (2016), ch. 9; Cundall & Strack, Géotechnique 29 (1979) 47. β from damping_of(e);
// it is hit within 0.15 % at dt = contact time/50. Cost: three square roots. Tests: tests/libcontact/laws_*.cpp,
// tests/libdem/two_bodies_*.cpp
#pragma once

#include "libcontact/laws/state.h"

namespace contact {

struct Linear {
  static constexpr const char* name = "linear";
  static constexpr const char* parameters = "stiffness (N/m), poisson, restitution";
  static constexpr const char* remark = "F = kn d + cn v, clipped at zero or not; kt = kn 2(1-nu)/(2-nu)";
  static constexpr const char* source = "Cundall & Strack 1979; end of contact at F = 0, or at d = 0";
  static constexpr Loss loss = Loss::none;
  static constexpr double damping_factor = 2;  // c = factor · β sqrt(m* k)
  template <class T>
  using State = NoState<T>;

  template <class T>
  static NormalForce<T> update(const PairOf<T>& p, const Kinematics<T>& k, const LawOptions& o, State<T>&) {
    using std::sqrt;
    const T fe = p.stiffness_n * k.overlap;                                                             // (9.20)
    const T cn = lagging_dashpot(T(damping_factor) * p.damping, p.stiffness_n, k.mass_eff, k.dt, 1.0);  // (9.26)
    const T w = select(k.onset > T(0), k.onset + T(0.5), T(1));
    const T f = fe + w * cn * k.closing_speed;  // (9.24)
    NormalForce<T> out;
    out.force = o.clip ? larger(f, T(0)) : f;
    out.elastic = fe;
    out.stiffness = p.stiffness_n;
    out.damping = cn;
    out.stiffness_t = p.stiffness_t;
    out.damping_t = T(damping_factor) * p.damping * sqrt(k.mass_eff * p.stiffness_t);
    out.holding = larger(f, T(0));
    out.shrink = T(1);
    out.energy = T(0.5) * fe * k.overlap;
    return out;
  }
};

}  // namespace contact
