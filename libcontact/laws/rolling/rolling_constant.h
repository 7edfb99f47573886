// Rolling and twisting friction of constant moment, with a viscous ramp near rest (model A).
//   M = −μ_r R* F w/|w|        rolling    [N m]   (1)
//   M_n = −cap sign(ω_n)       twisting   [N m]   (2)   cap: μ_tw F a, or μ_tw F R* where the normal law has no a
// each below |M| = |w| I/(4 dt), I = 2/5 m* R*²: resistance.h, which says what that does near rest.
// A sphere that rolls on a plane slows down by (5/7) μ_r g, one that spins on it by (5/2) μ_tw g a/R². Nothing is
// stored. Source: Zhou, Wright, Yang, Xu & Yu, Physica A 269 (1999) 536; model A of Ai, Chen, Rotter & Ooi, Powder
// Technol. 206 (2011) 269. Valid while bodies move; what should stand still on a slope creeps (`spring` does not).
// Cost: two square roots. Test: tests/libcontact/laws_rolling_constant.cpp
#pragma once

#include "libcontact/laws/rolling/resistance.h"

namespace contact {

struct RollingConstant {
  static constexpr const char* name = "constant";
  static constexpr const char* parameters = "rolling_friction, twisting_friction";
  static constexpr const char* remark = "moment mu_r R* F against the rolling, viscous near rest";
  static constexpr const char* source = "Zhou et al. 1999; model A of Ai et al. 2011";
  template <class T>
  using State = NoState<T>;

  template <class T>
  static Moment<T> update(const PairOf<T>& p, const Kinematics<T>& k, const NormalForce<T>& f, const LawOptions&,
                          State<T>&) {
    const resistance::Spin<T> spin = resistance::split(k);
    const T per_rate = resistance::dry<T>(resistance::rolling_cap(p, k, f), dot(spin.rolling, spin.rolling), k);
    Moment<T> out;
    out.moment = resistance::dry_twist(p, k, f, spin.twist) - spin.rolling * per_rate;  // (1), (2)
    return out;
  }
};

}  // namespace contact
