// Rolling resistance in proportion to the rate (model B), twisting friction as that of `constant`.
//   M = −min(η_r R*² F, I/(4 dt)) w     rolling    [N m]   (1)   η_r: s/m
//   M_n = −cap sign(ω_n)                twisting   [N m]   (2)   cap, ramp, I = 2/5 m* R*²: resistance.h
// The second limit of (1) acts only where the step would not follow the decay: bodies never turn back. A sphere that
// rolls on a plane without slip slows down as exp(−(5/7) η_r F t/m). Nothing is stored. Source: Brilliantov & Pöschel,
// Europhys. Lett. 42 (1998) 511; model B of Ai, Chen, Rotter & Ooi, Powder Technol. 206 (2011) 269. Valid where no
// resistance at rest is wanted. Cost: one square root. Test: tests/libcontact/laws_rolling_viscous.cpp
#pragma once

#include "libcontact/laws/rolling/resistance.h"

namespace contact {

struct RollingViscous {
  static constexpr const char* name = "viscous";
  static constexpr const char* parameters = "rolling_viscosity (s/m), twisting_friction";
  static constexpr const char* remark = "moment eta_r R*^2 F times the rate of rolling";
  static constexpr const char* source = "Brilliantov & Poschel 1998; model B of Ai et al. 2011";
  template <class T>
  using State = NoState<T>;

  template <class T>
  static Moment<T> update(const PairOf<T>& p, const Kinematics<T>& k, const NormalForce<T>& f, const LawOptions&,
                          State<T>&) {
    const resistance::Spin<T> spin = resistance::split(k);
    const T asked = capped<T>(p.rolling_viscosity * (k.radius_eff * k.radius_eff), f.holding);
    Moment<T> out;
    out.moment =
        resistance::dry_twist(p, k, f, spin.twist) - spin.rolling * resistance::within_the_step(asked, k);  // (1), (2)
    return out;
  }
};

}  // namespace contact
