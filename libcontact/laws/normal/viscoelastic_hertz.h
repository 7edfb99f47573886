// Hertz contact of viscoelastic bodies (Kuwabara & Kono): the dashpot follows from the material and e falls with speed.
//   a  = sqrt(R* δ)                                       [m]
//   Fe = 4/3 E* a δ                                       [N]      (1)
//   F  = max(least, ρ (δ^{3/2} + 3/2 A sqrt(δ) dδ/dt)) = max(least, Fe + s w c dδ/dt),   ρ = 4/3 E* sqrt(R*)
//   kn = 2 E* a,   c = A kn                               [N s/m]  (2)
//   kt = 8 G* a,   ct = A kt                                       (3)
//   least = 0 when clipped, else −∞
//   w  = (2/3)(f + ½) sqrt((f + ½)/f) in the first step of a contact, of which the part f was spent in contact, else 1:
//        the step's force stands for the time f dt + dt/2, in which the dashpot's grows as sqrt(t); unclipped also in
//        the last one
//   s  = sqrt(1 + x²) − x,  x = ε/3,  ε = c dt/(2 m*)     lag_factor with p = 2/3                     (4)
// (4): a closing speed of half a step ago makes F = (Fe + c v)/(1 − ε), as if U were U (1 + 5ε/6). What decides the
// restitution is c/Fe ∝ 1/δ as a function of U ∝ δ^{5/2}: at given U it is more by (2/5)(5/6) ε = ε/3.
// e = 1 − C₁ α + (3/5) C₁² α² − …,  α = (3/2) A (ρ/m*)^⅖ V^⅕,  C₁ = Γ(3/5) sqrt(π)/(2^⅕ 5^⅖ Γ(21/10)) = 1.15345; V the
// speed of impact. (3) is a choice; the theory is that of a normal impact.
// Source: Kuwabara & Kono, Jpn. J. Appl. Phys. 26 (1987) 1230; Brilliantov, Spahn, Hertzsch & Pöschel, Phys. Rev. E 53
// (1996) 5382; the series: Ramírez, Pöschel, Brilliantov & Schwager, Phys. Rev. E 60 (1999) 4465. Valid a << R*, V far
// below the speed of sound. Cost: three square roots, two divisions. Accuracy: e is hit within 2e-4 at dt = contact
// time/50 for α <= 0.3, at an order of 1.5 to 2 in dt. Tests: tests/libcontact/laws_viscoelastic_hertz.cpp
#pragma once

#include "libcontact/laws/state.h"

namespace contact {

struct ViscoelasticHertz {
  static constexpr const char* name = "viscoelastic_hertz";
  static constexpr const char* parameters = "young (Pa), poisson, viscous_time (s)";
  static constexpr const char* remark = "Hertz + (3/2) A sqrt(d) v: e falls with speed; kt = 8 G* a";
  static constexpr const char* source = "Kuwabara & Kono 1987; Brilliantov et al. 1996";
  static constexpr Loss loss = Loss::none;
  static constexpr double damping_factor = 0;  // not of the form β sqrt(m* k)
  template <class T>
  using State = NoState<T>;

  template <class T>
  static NormalForce<T> update(const PairOf<T>& p, const Kinematics<T>& k, const LawOptions& o, State<T>&) {
    using std::sqrt;
    const T a = sqrt(k.radius_eff * k.overlap);
    const T kn = T(2) * p.young_eff * a;
    const T fe = T(2.0 / 3.0) * kn * k.overlap;  // (1)
    const T c0 = p.viscous_time * kn;            // (2)
    const T c = c0 * lag_factor(c0, k.mass_eff, k.dt, 2.0 / 3.0);
    const auto begins = k.onset > T(0);
    const T x = select(begins, k.onset, T(1)), since = x + T(0.5);
    const T w = select(begins, T(2.0 / 3.0) * since * sqrt(since / x), T(1));
    const T f = fe + w * c * k.closing_speed;
    NormalForce<T> out;
    out.force = o.clip ? larger(f, T(0)) : f;
    out.elastic = fe;
    out.stiffness = kn;
    out.damping = c;
    out.contact_radius = a;
    out.stiffness_t = T(8) * p.shear_eff * a;
    out.damping_t = p.viscous_time * out.stiffness_t;  // (3)
    out.holding = larger(f, T(0));
    out.shrink = root_shrink(k, o.rescale);
    out.energy = T(0.4) * fe * k.overlap;
    return out;
  }
};

}  // namespace contact
