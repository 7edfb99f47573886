// Elastic–plastic contact of spheres: Hertz up to the pressure at which it yields, unloading of a flattened sphere.
//   a_y = π p_y R*/(2E*),   δ_y = a_y²/R*                    first yield of the contact area        [m]     (1)
//   F = 4/3 E* a δ,  a² = R* δ                               loading, δ <= δ_y                      [N]     (2)
//   F = F_y + π p_y R* (δ − δ_y) = π p_y R* (δ − δ_y/3)      loading beyond                         [N]     (3)
//   F = 4/3 E* sqrt(R_p) (δ − δ_p)^{3/2}                     below the largest overlap δm           [N]     (4)
//     = Fm z^{3/2},  a = am sqrt(z),  z = 1 − (δm − δ)/D
//   am² = R* δm,   D = δm − δ_p = 3Fm/(4E* am),   R_p = am²/D                                       [m]     (5)
//   U = (2/5) F D z                                          what it gives back                     [J]     (6)
//   kn = 2 E* a, the steeper of loading and unloading; kt = 8 G* a                                  [N/m]
// (5) is the paper's R_p = (4E*/(3Fm)) ((2Fm + F_y)/(2π p_y))^{3/2}: the bracket is am², by (3). Loading again runs
// along (4) up to δm. Between 0 and δ_p the force is zero, the memory stays. The rebound speed ratio:
//   e = sqrt(6√3/5) sqrt(1 − x²/6) (x/(x + 2 sqrt(6/5 − x²/5)))^¼,   x = V_y/V < 1, else 1
//   V_y = (π/(2E*))² sqrt(8π R*³/(15 m*)) p_y^{5/2}
// No dashpot: neither options.clip nor the onset matters. p_y infinite: Hertz, undamped. p_y is the peak of Hertz's
// pressure beyond which the contact's middle yields, at first 1.6 yield stresses.
// Source: Thornton, J. Appl. Mech. 64 (1997) 383; Thornton & Ning, Powder Technol. 99 (1998) 154. Valid a << R*.
// Cost: four square roots, five divisions. Accuracy: 4e-15 sqrt(1 + δm/δ_y) Fm.
// Tests: tests/libcontact/laws_thornton_ning.cpp
#pragma once

#include "libcontact/laws/state.h"

namespace contact {

struct ThorntonNing {
  static constexpr const char* name = "thornton_ning";
  static constexpr const char* parameters = "young (Pa), poisson, yield_pressure (Pa)";
  static constexpr const char* remark = "Hertz, yielding at a pressure, unloading flattened; no dashpot; kt = 8 G* a";
  static constexpr const char* source = "Thornton 1997; Thornton & Ning 1998";
  static constexpr Loss loss = Loss::plastic;
  static constexpr double damping_factor = 0;
  template <class T>
  struct State {
    T overlap_max{};  // δm, m
  };

  template <class T>
  static NormalForce<T> update(const PairOf<T>& p, const Kinematics<T>& k, const LawOptions& o, State<T>& s) {
    using std::sqrt;
    constexpr double pi = 3.14159265358979323846;
    s.overlap_max = larger(s.overlap_max, k.overlap);
    const T deepest = s.overlap_max, am = sqrt(k.radius_eff * deepest);
    const T ay = T(0.5 * pi) * (p.yield_pressure / p.young_eff) * k.radius_eff, yield = ay * ay / k.radius_eff;  // (1)
    const auto yielded = deepest > yield;
    const T slope = T(pi) * p.yield_pressure * k.radius_eff;
    const T fm = select(yielded, slope * (deepest - T(1.0 / 3) * yield),  // (3)
                        T(4.0 / 3) * p.young_eff * am * deepest);         // (2)
    const auto some = deepest > T(0);
    const T deflection = select(yielded, T(0.75) * fm / (p.young_eff * select(some, am, T(1))), deepest);  // (5)
    const auto share = [&](const T& overlap) {
      const T z = T(1) - (deepest - overlap) / select(some, deflection, T(1));
      return select(yielded, larger(z, T(0)), overlap / select(some, deepest, T(1)));
    };
    const T z = share(k.overlap), root = sqrt(z), a = am * root;
    NormalForce<T> out;
    out.force = fm * z * root;  // (4)
    out.elastic = out.force;
    out.stiffness = T(2) * p.young_eff * a;
    out.damping = T(0);
    out.contact_radius = a;
    out.stiffness_t = T(8) * p.shear_eff * a;
    out.damping_t = T(0);
    out.holding = out.force;
    const T before = share(k.overlap_before);
    const auto shrinks = k.overlap < k.overlap_before && before > T(0);
    out.shrink = o.rescale ? select(shrinks, sqrt(z / select(shrinks, before, T(1))), T(1)) : T(1);
    out.energy = T(0.4) * out.force * deflection * z;  // (6)
    return out;
  }
};

}  // namespace contact
