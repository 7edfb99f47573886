// Adhesive, elastic-plastic contact of spheres: JKR until it yields, and back along the JKR of a flattened sphere.
//   δ  = a²/R* − q/E*,   q = sqrt(2π W E* a)                  contact radius a            [m, N/m] (1)
//   Fe = F̂ − 2 q a                                                                        [N]      (2)
//   F̂  = 4E* a³/(3R*)                                         loading, a <= a_y: JKR      [N]      (3)
//   F̂  = π p_y a² + 2 q (a − a_y) + q_y a_y − (2/3) E* a_y³/R*        loading beyond      [N]      (4)
//   p_y = 2E* a_y/(πR*) − sqrt(2 W E*/(π a_y))                pressure in the middle      [Pa]     (5)
//   R_p = 4E* am³/(3F̂m),   δ_p = am² (1/R* − 1/R_p)           am, F̂m: at the largest overlap δm    (6)
//   below δm: JKR with R_p for R*, δ − δ_p for δ; it lets go at δ_p − (3/4)(π² W² R_p/E*²)^⅓       (7)
//   U: (2) of jkr.h, likewise;   kn = 2 E* a,   kt = 8 G* a;   friction multiplies Fe + 2 Fc, Fc = (3/2) π W R_p
// (4) is the integral of the paper's slope, with (1): dFe/dδ = (3π R* p_y √Fh − 2E* a_y √Fc)/(3√Fh − √Fc), Fh = (3); it
// begins as steep as JKR is at a_y. By (6) both curves have the same force and radius at the turn. Loading again runs
// along (7) up to δm, then along (4). F = Fe with the impulses of the jumps as in jkr.h, and no dashpot. p_y infinite:
// JKR. W = 0: thornton_ning.h. The gap never is wider than JKR's.
// The paper has one impact of hard spheres. Beyond it, two choices:
// - After letting go, the contact is made anew where the flattened surfaces touch, at δ >= δ_p, with JKR's jump.
// - At a_y the work lost is (16/15)(E* a_f⁵/R*³)(y¹⁰ − 5y⁷ + 4) dR_p, y² = a_y/a_f, a_f³ = π W R*²/(8E*): where it is
//   negative, in soft bodies, more is given back than was put in. Where y³ < 5 a_y is that of y³ = 5, and p_y there
//   (6/5) E* a_y/(π R*).
// Source: Thornton & Ning, Powder Technol. 99 (1998) 154. Valid a << R*. Accuracy of Fe: 1e-14 (1 + a/a_y)(Fm + Fc),
// near the end see jkr.h. Cost: 14 square roots, 35 divisions.
// Tests: tests/libcontact/laws_thornton_ning_adhesive.cpp
#pragma once

#include "libcontact/laws/normal/jkr.h"

namespace contact {

struct ThorntonNingAdhesive {
  static constexpr const char* name = "thornton_ning_adhesive";
  static constexpr const char* parameters = "young (Pa), poisson, yield_pressure (Pa), work_of_adhesion (J/m^2)";
  static constexpr const char* remark = "JKR, yielding at a pressure, unloading flattened; no dashpot; kt = 8 G* a";
  static constexpr const char* source = "Thornton & Ning 1998";
  static constexpr Loss loss = Loss::plastic;
  static constexpr bool adheres = true;
  static constexpr double damping_factor = 0;
  template <class T>
  struct State {
    T bonded{};
    T radius{};       // a of the last step, m
    T overlap_max{};  // δm, m
    T radius_max{};   // am, m
    T flattened{};    // R_p, m; 0: not touched yet
  };

  static double range(const PairParameters& p, double radius_eff) { return Jkr::range(p, radius_eff); }

  // a_y of (5): with g² = a_y/R*, g³ = π p_y/(2E*) g + sqrt(π W/(2E* R*)). NaN for an infinite p_y.
  template <class T>
  static T yield_radius(const PairOf<T>& p, const T& radius_eff) {
    using std::sqrt;
    constexpr double pi = 3.14159265358979323846;
    const T linear = T(0.5 * pi) * p.yield_pressure / p.young_eff;
    const T square = T(0.5 * pi) * p.work_of_adhesion / (p.young_eff * radius_eff);
    const T constant = sqrt(square);
    T g = sqrt(linear) + sqrt(shapes::cube_root(square));  // not less than the root
    for (int i = 0; i < 5; ++i) {
      const T f = (g * g - linear) * g - constant, slope = T(3) * g * g - linear;
      g = g - f * slope / (slope * slope - T(3) * g * f);
    }
    return radius_eff * g * g;
  }

  template <class T>
  static NormalForce<T> update(const PairOf<T>& p, const Kinematics<T>& k, const LawOptions& o, State<T>& s) {
    using std::sqrt;
    constexpr double pi = 3.14159265358979323846;
    const auto held = s.bonded > T(0), loads = k.overlap >= s.overlap_max;
    const auto unloads = !loads && s.flattened > T(0);
    const T before = select(unloads, s.flattened, k.radius_eff), am2 = s.radius_max * s.radius_max;
    const T residue = am2 / k.radius_eff - am2 / before;  // δ_p below δm, 0 on (3) and (4)
    const JkrRadius<T> c = jkr_radius(p.young_eff, p.work_of_adhesion, before, k.overlap - residue);
    const auto bonded = (held || k.overlap >= residue) && !(k.overlap - residue < c.release);
    const T a = select(bonded, c.a, T(0));
    const T soft = yield_radius(p, k.radius_eff), least = T(2.9240177382128659) * c.least;
    const auto softer = soft < least;  // not where p_y is infinite
    const T ay = select(softer, least, soft);
    const T flow = select(softer, T(1.2) * p.young_eff * (least / k.radius_eff), T(pi) * p.yield_pressure);  // π p_y
    const T we = T(2 * pi) * p.work_of_adhesion * p.young_eff;
    const T q = sqrt(we * a), qy = sqrt(we * ay);
    const T plastic =
        flow * a * a + T(2) * q * (a - ay) + qy * ay - T(2.0 / 3) * p.young_eff * ay * ay * (ay / k.radius_eff);  // (4)
    const auto yields = loads && a > ay;
    const T flattened =
        select(yields, T(4.0 / 3) * p.young_eff * a * a * (a / select(yields, plastic, T(1))), before);  // (6)
    s.radius_max = select(loads, a, s.radius_max);
    s.overlap_max = select(loads, k.overlap, s.overlap_max);
    s.flattened = flattened;
    const T h = a * a / flattened;
    const T depth = k.overlap - select(yields, a * a / k.radius_eff - h, residue);  // δ − δ_p
    const T kn = T(2) * p.young_eff * a;
    const T fe = select(yields, plastic - T(2) * q * a, kn * (depth - h * T(1.0 / 3)));  // (2)
    const T pull = T(1.5 * pi) * p.work_of_adhesion * flattened;                         // Fc
    const auto begins = bonded && !held && k.onset > T(0);
    const T made = select(begins, k.onset - T(0.5), T(0)) * (T(-8.0 / 9) * pull);
    const T left = k.overlap - residue - c.release, parting = (fe * k.dt / k.mass_eff - k.closing_speed) * k.dt;
    const auto ends = bonded && fe < T(0) && parting > left;
    const T lets_go = select(ends, left / select(ends, parting, T(1)) - T(0.5), T(0)) * fe;
    NormalForce<T> out;
    out.force = fe + made + lets_go;
    out.elastic = fe;
    out.stiffness = kn;
    out.damping = T(0);
    out.contact_radius = a;
    out.stiffness_t = T(8) * p.shear_eff * a;
    out.damping_t = T(0);
    out.holding = select(bonded, larger(fe + T(2) * pull, T(0)), T(0));
    const auto shrinks = s.radius > a;
    out.shrink = o.rescale ? select(shrinks, a / select(shrinks, s.radius, T(1)), T(1)) : T(1);
    const T wider = shapes::cube_root(flattened / before), rest = c.least * c.least / before;
    out.energy = select(bonded,
                        p.young_eff * (a * (T(0.5) * depth * depth + h * (depth * T(1.0 / 3) - T(0.3) * h)) -
                                       T(3.2) * c.least * rest * rest * (wider * wider) * (wider * wider)),
                        T(0));
    out.bond = select(bonded, T(1), T(0));
    s.bonded = out.bond;
    s.radius = a;
    return out;
  }
};

}  // namespace contact
