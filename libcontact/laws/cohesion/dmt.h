// Adhesion of stiff small bodies: the attraction of the surfaces outside the contact, which does not deform them.
//   P = 2π W R*   while δ > 0, else 0   [N]   (1)   W: work of adhesion, 2γ of like surfaces
//   U = −P δ                            [J]   (2)
// With Hertz's force F = 4/3 E* sqrt(R*) δ^(3/2) − 2π W R*; the bodies part at δ = 0, with the pull-off force 2π W R*.
// Source: Derjaguin, Muller & Toporov, J. Colloid Interface Sci. 53 (1975) 314, in the form of Maugis, J. Colloid
// Interface Sci. 150 (1992) 243. Valid for Tabor's number (R* W²/(E*² z0³))^(1/3) < 0.1, z0 the distance of atoms;
// above 5 JKR holds. Cost: one comparison. Test: tests/libcontact/laws_cohesion.cpp
#pragma once

#include <numbers>

#include "libcontact/laws/state.h"

namespace contact {

struct Dmt {
  static constexpr const char* name = "dmt";
  static constexpr const char* parameters = "work_of_adhesion (J/m^2)";
  static constexpr const char* remark = "2 pi W R* while the bodies overlap";
  static constexpr const char* source = "Derjaguin, Muller & Toporov 1975; Maugis 1992";
  template <class T>
  using State = NoState<T>;
  static double range(const PairParameters&, const LawOptions&, double) { return 0; }

  template <class T>
  static Pull<T> update(const PairOf<T>& p, const Kinematics<T>& k, const NormalForce<T>&, const LawOptions&,
                        State<T>&) {
    const T pull = T(2 * std::numbers::pi) * p.work_of_adhesion * k.radius_eff;
    Pull<T> out;
    out.force = select(k.overlap > T(0), pull, T(0));                  // (1)
    out.energy = select(k.overlap > T(0), -(pull * k.overlap), T(0));  // (2)
    return out;
  }
};

}  // namespace contact
