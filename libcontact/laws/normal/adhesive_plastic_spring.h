// Luding's adhesive, elasto-plastic springs: a soft line of loading, a stiffer one of unloading, a line that pulls.
//   F  = k1 δ                              loading, δ = δm < δp                              [N]     (1)
//   F  = k1 δm − k2 (δm − δ)               between, = k2 (δ − δ0), δ0 = (1 − k1/k2) δm       [N]     (2)
//   F  = −kc δ                             where (2) is less; there δm falls until (2) is as much    (3)
//   k2 = k1 + (kp − k1) δm/δp,   δm <= δp = kp/(kp − k1) φf 2R*                              [N/m]   (4)
//   δm = min(δm, δ/2 + sqrt(δ²/4 + (k1 + kc) δ δp/(kp − k1)))       (3) solved for δm by (4)  [m]     (5)
//   F ← F + s w c dδ/dt,   c = 2 β sqrt(m* k1)                                               [N]     s, w: linear.h
//   U  = F²/(2 k2)                         what it gives back without dashpots               [J]     (6)
//   kt = k1/κ,   ct = 2 β sqrt(m* kt);   what friction multiplies: max(0, F + kc δ)
// Beyond δp all is elastic along kp: φf 2R* is the largest δ0, the flattened depth at which F = 0. After (3), loading
// again runs along the k2 of the smaller δm. Where δ falls to zero F does, and the memory is lost. When clipped the
// dashpot does not pull: F >= min(F of (1)-(3), 0). kp <= k1: a linear spring; kc = 0: no pull. Without dashpot an
// impact that reaches δm < δp ends with
//   e² = k1/k2 − (kc/k1)(k2 − k1)²/(k2 (k2 + kc)),     <= 0: it sticks.
// which is the ratio of the areas under (2), less (3), and (1). Source: Luding, Granular Matter 10 (2008) 235. Valid k1
// < kp, kc < kp. Cost: four square roots, four divisions. Accuracy: rounding of k2 δm. Tests:
// tests/libcontact/laws_adhesive_plastic_spring.cpp
#pragma once

#include "libcontact/laws/state.h"

namespace contact {

struct AdhesivePlasticSpring {
  static constexpr const char* name = "adhesive_plastic_spring";
  static constexpr const char* parameters =
      "stiffness (N/m), poisson, restitution, plastic_stiffness (N/m), adhesive_stiffness (N/m), plastic_depth";
  static constexpr const char* remark = "k1 d, k2(d_max) (d - d0), -kc d; dashpot; kt = k1 2(1-nu)/(2-nu)";
  static constexpr const char* source = "Luding 2008";
  static constexpr Loss loss = Loss::plastic;
  static constexpr double damping_factor = 2;  // c = factor · β sqrt(m* k)
  template <class T>
  struct State {
    T overlap_max{};  // δm, m
  };

  template <class T>
  static NormalForce<T> update(const PairOf<T>& p, const Kinematics<T>& k, const LawOptions& o, State<T>& s) {
    using std::sqrt;
    const T k1 = p.stiffness_n, rise = p.plastic_stiffness - k1;
    const auto hardens = rise > T(0);
    const T some_rise = select(hardens, rise, T(1));
    const T limit = p.plastic_stiffness / some_rise * p.plastic_depth * T(2) * k.radius_eff;  // δp
    const T half = T(0.5) * k.overlap;
    const T most = half + sqrt(half * half + (k1 + p.adhesive_stiffness) / some_rise * limit * k.overlap);  // (5)
    const T reached = larger(s.overlap_max, k.overlap), flat = select(reached < limit, reached, limit);
    const T m = select(hardens, select(flat < most, flat, most), k.overlap);
    const auto some = limit > T(0);
    const T k2 = select(hardens, k1 + rise * select(some, m / select(some, limit, T(1)), T(1)), k1);  // (4)
    const T fe = k1 * m - k2 * (m - k.overlap);
    s.overlap_max = m;
    const T c = lagging_dashpot(T(damping_factor) * p.damping, k1, k.mass_eff, k.dt, 1.0);
    const T w = select(k.onset > T(0), k.onset + T(0.5), T(1));
    const T f = fe + w * c * k.closing_speed;
    NormalForce<T> out;
    out.force = o.clip ? larger(f, select(fe < T(0), fe, T(0))) : f;
    out.elastic = fe;
    out.stiffness = k2;
    out.damping = c;
    out.stiffness_t = p.stiffness_t;
    out.damping_t = T(damping_factor) * p.damping * sqrt(k.mass_eff * p.stiffness_t);
    out.holding = larger(out.force + p.adhesive_stiffness * k.overlap, T(0));
    out.shrink = T(1);
    out.energy = T(0.5) * fe * (fe / k2);  // (6)
    return out;
  }
};

}  // namespace contact
