// Hertz contact of smooth elastic bodies with Tsuji's dashpot, clipped at zero force or not at all.
//   a  = sqrt(R* δ)                      contact radius     [m]     (8.12)
//   Fe = 4/3 E* a δ                      elastic force      [N]     (9.6)
//   kn = dFe/dδ = 2 E* a                 tangent stiffness  [N/m]   (9.7)
//   cn = 2 sqrt(5/6) β sqrt(m* kn)       dashpot            [N s/m] (9.26) with the factor that Hertz needs
//   F  = max(least, Fe + s w cn dδ/dt)                      [N]     s, w: tsuji_dashpot of kinematics.h
//   kt = 8 G* a                          no micro-slip      [N/m]   (9.16);  ct as cn with kt
//   least = 0 when clipped, else −∞
// Source: Seville & Wu, Particle Technology and Engineering (2016), ch. 9; Tsuji, Tanaka, Ishida, Powder Technol. 71
// (1992) 239. Valid a << R*. With β from damping_of(e) the rebound speed ratio is e at every impact speed, within
// 0.2 % at dt = contact time/50. Cost: six square roots. Tests: tests/libcontact/laws_*.cpp,
// tests/libdem/two_bodies_*.cpp
#pragma once

#include "libcontact/laws/state.h"

namespace contact {

struct Hertz {
  static constexpr const char* name = "hertz";
  static constexpr const char* parameters = "young (Pa), poisson, restitution";
  static constexpr const char* remark = "F = 4/3 E* sqrt(R*) d^1.5 + Tsuji's dashpot, clipped or not; kt = 8 G* a";
  static constexpr const char* source = "Hertz 1881; Tsuji, Tanaka & Ishida 1992";
  static constexpr Loss loss = Loss::none;
  static constexpr double damping_factor = 1.8257418583505538;  // 2 sqrt(5/6): c = factor · β sqrt(m* k)
  template <class T>
  using State = NoState<T>;

  template <class T>
  static NormalForce<T> update(const PairOf<T>& p, const Kinematics<T>& k, const LawOptions& o, State<T>&) {
    using std::sqrt;
    const T a = sqrt(k.radius_eff * k.overlap);  // (8.12)
    const T kn = T(2) * p.young_eff * a;         // (9.7)
    const T fe = T(2.0 / 3.0) * kn * k.overlap;  // (9.6)
    const Dashpot<T> d = tsuji_dashpot(T(damping_factor) * p.damping, kn, k);
    const T f = fe + d.weight * d.damping * k.closing_speed;
    NormalForce<T> out;
    out.force = o.clip ? larger(f, T(0)) : f;
    out.elastic = fe;
    out.stiffness = kn;
    out.damping = d.damping;
    out.contact_radius = a;
    out.stiffness_t = T(8) * p.shear_eff * a;  // (9.16)
    out.damping_t = T(damping_factor) * p.damping * sqrt(k.mass_eff * out.stiffness_t);
    out.holding = larger(f, T(0));
    out.shrink = root_shrink(k, o.rescale);
    out.energy = T(0.4) * fe * k.overlap;
    return out;
  }
};

}  // namespace contact
