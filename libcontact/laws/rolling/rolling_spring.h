// Rolling and twisting springs with a cap and a dashpot below it: elastic-plastic spring-dashpot (model C, EPSD).
//   kr  = 2.25 kn μ_r² R*²                               [N m/rad]   (1)   kn: dF/dδ of the normal law
//   M_k ← M_k · shrink − kr w Δt, shortened to |M_k| <= μ_r R* F     (2)   turned with the contact frame before
//   M   = M_k − 2 η sqrt(I kr) w   while |M_k| < μ_r R* F, else M_k  (3)   I = 7/5 m* R*²
//   k_tw = (16/3) a³/(1/G1 + 1/G2)                       [N m/rad]   (4)   half-spaces stuck over a circle, twisted;
//          2.25 kt μ_tw² R*² where the normal law has no a
//   twisting as (2), (3) with k_tw, the cap μ_tw F a (or μ_tw F R*) and I = 2/5 m* R*²                       (5)
//   U = |M_k|²/(2 kr) + M_n²/(2 k_tw)                    [J]
//   shrink = min(1, k/k_before) of either spring, with the option `rescale`, else 1: a spring that gets softer does
//   not give more than it was stretched for
// I of rolling is that of a sphere about its contact with a plane (exact there); two equal spheres that roll on each
// other turn with m R²/5, for which it stands 7/40 m R²: `rolling_damping` is then 0.94 of what is asked for. In twist
// it is exact on a plane, and half of what is asked for between equal spheres. Ai et al. take (Σ 1/(Iᵢ + mᵢ Rᵢ²))⁻¹.
// Source: Iwashita & Oda, J. Eng. Mech. 124 (1998) 285; (1), (3): Ai, Chen, Rotter & Ooi, Powder Technol. 206 (2011)
// 269; (4): Johnson, Contact Mechanics (1985), ch. 7. Valid while dt resolves sqrt(kr/I) = 1.27 μ_r sqrt(kn/m*). Cost:
// three square roots. Test: tests/libcontact/laws_rolling_spring.cpp
#pragma once

#include "libcontact/laws/rolling/resistance.h"

namespace contact {

struct RollingSpring {
  static constexpr const char* name = "spring";
  static constexpr const char* parameters = "rolling_friction, rolling_damping, twisting_friction";
  static constexpr const char* remark = "springs under the caps mu_r R* F and mu_tw a F, dashpots below them";
  static constexpr const char* source = "Iwashita & Oda 1998; model C of Ai et al. 2011";
  static constexpr int vectors = 1;
  template <class T>
  struct State {
    Vec3<T> rolling{};    // M_k, elastic, on a, N m
    T twist{};            // M_n, elastic, on a about n, N m
    T stiffness{};        // kr of the last step, N m/rad
    T stiffness_twist{};  // k_tw of the last step, N m/rad
  };

  template <class T>
  static Moment<T> update(const PairOf<T>& p, const Kinematics<T>& k, const NormalForce<T>& f, const LawOptions& o,
                          State<T>& s) {
    using std::sqrt;
    const resistance::Spin<T> spin = resistance::split(k);
    const T area = k.radius_eff * k.radius_eff, a = f.contact_radius, mu = p.rolling_friction, mt = p.twisting_friction;
    const T kr = T(2.25) * f.stiffness * (mu * mu) * area;  // (1)
    const T solid = T(16.0 / 3.0) * (a * a * a) * p.shear_twist, no_radius = T(2.25) * f.stiffness_t * (mt * mt) * area;
    const T kt = select(mt > T(0), select(a > T(0), solid, no_radius), T(0));  // (4)

    const T cap = resistance::rolling_cap(p, k, f);
    const Vec3<T> trial = s.rolling * shrink(kr, s.stiffness, o) - spin.rolling * (kr * k.dt_contact);
    const T square = dot(trial, trial);
    const auto rolls = !(square < cap * cap);
    const auto longer = square > cap * cap;
    s.rolling = shortened(trial, longer, square, cap);  // (2)
    const T inertia = resistance::solid_inertia(k);
    const T damping = select(rolls, T(0), T(2) * p.rolling_damping * sqrt(T(3.5) * inertia * kr));

    const T cap_twist = resistance::twisting_cap(p, k, f);
    const T turned = s.twist * shrink(kt, s.stiffness_twist, o) - spin.twist * (kt * k.dt_contact);
    const T size = larger(turned, -turned);
    s.twist = select(size > cap_twist, select(turned < T(0), -cap_twist, cap_twist), turned);  // (5)
    const T damping_twist = select(size < cap_twist, T(2) * p.rolling_damping * sqrt(inertia * kt), T(0));

    s.stiffness = kr;
    s.stiffness_twist = kt;
    Moment<T> out;
    out.moment = s.rolling - spin.rolling * damping + k.normal * (s.twist - spin.twist * damping_twist);  // (3)
    out.energy = stored(dot(s.rolling, s.rolling), kr) + stored(s.twist * s.twist, kt);
    return out;
  }

 private:
  template <class T>
  static T shrink(const T& now, const T& before, const LawOptions& o) {
    if (!o.rescale) return T(1);
    const auto softer = now < before;
    return select(softer, now / select(softer, before, T(1)), T(1));
  }
  template <class T>
  static T stored(const T& square, const T& stiffness) {
    const auto holds = stiffness > T(0);
    return select(holds, T(0.5) * square / select(holds, stiffness, T(1)), T(0));
  }
};

}  // namespace contact
