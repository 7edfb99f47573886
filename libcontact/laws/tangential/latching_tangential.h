// The tangential spring that goes with a latching normal one: it softens towards Coulomb's force and, after each
// reversal, begins anew. k0 = kt of the normal law, Ft* the force at the last reversal, F the pressing force.
//   kt = k0 (1 − (Ft − Ft*)/(μ F − Ft*))^⅓   while Ft grows                               [N/m]  (9.33)
//   kt = k0 (1 − (Ft* − Ft)/(μ F + Ft*))^⅓   while it falls                               [N/m]  (9.34)
// In vectors: e the direction of Ft − Ft*, or of the slip just after a reversal: along e both are kt = k0 (1 − r)^⅓,
// r = |Ft − Ft*|/L, L the way from Ft* along e to the circle |Ft| = μ F; across e, k0. A step that uses up
// the way has k0 in all directions, and the circle cuts it.
//   L = sqrt((μ F)² − Ft*² + (Ft*·e)²) − Ft*·e                                            [N]    (1)
// A slip against e is a reversal: Ft* ← Ft. As F changes, Ft* ← Ft* F/F_old; Ft stays within μ F, and shrinks with the
// contact radius of a normal law that has one. At constant F the softening is integrated over the step:
//   Ft = Ft* + L (1 − (1 − 2 k0 x/(3 L))^1.5),   x the slip since the reversal            [N]    (2)
// First loading at constant F is Mindlin's curve for k0 = 8 G* a; after a reversal at less than μ F it is softer than
// Mindlin & Deresiewicz's. |Ft| <= μ F. Where all slips the force is μ F; elsewhere a dashpot, no part of the spring,
// is added up to μ F. Energy: what comes back at this F when the slip reverses,
//   0.3 (Ft²/k0) (2 + 4c + 6c² + 3c³)/(1 + c + c²)²,   c³ = μ F/(μ F + |Ft|)              [J]    (3)
// With a normal law of Hertz no energy is created in random closed loops of overlap and slip; with one of constant kt
// up to 0.06 of the most that was stored, as what was loaded under a large F comes back softer under a small one.
// Source: Walton & Braun, J. Rheol. 30 (1986) 949; Seville & Wu (2016), (9.33), (9.34). Cost: two cube roots, six
// square roots. Tests: tests/libcontact/laws_latching_tangential.cpp
#pragma once

#include "libcontact/laws/state.h"
#include "shapes/math/cube_root.h"

namespace contact {

struct LatchingTangential {
  static constexpr const char* name = "latching_tangential";
  static constexpr const char* parameters = "friction";
  static constexpr const char* remark =
      "softens towards the cap, anew after each reversal; goes with a latching spring";
  static constexpr const char* source = "Walton & Braun 1986";
  static constexpr int vectors = 2;
  template <class T>
  struct State {
    Vec3<T> force{};   // elastic, on b, N
    Vec3<T> turned{};  // Ft*, N
    T pressing{};      // F of the last step, N
  };

  template <class T>
  static TangentialForce<T> update(const PairOf<T>& p, const Kinematics<T>& k, const NormalForce<T>& f,
                                   const LawOptions&, State<T>& s) {
    using shapes::cube_root;
    using std::sqrt;
    const T zero(0), one(1), fn = f.holding, k0 = f.stiffness_t;
    const T cap = capped(p.friction, fn);
    const auto pressed = s.pressing > zero;
    s.turned = s.turned * select(pressed, fn / select(pressed, s.pressing, one), zero);
    s.force = s.force * f.shrink;
    s.pressing = fn;

    const Vec3<T> slip = k.slip * k.dt_contact;
    const T distance = sqrt(dot(slip, slip));
    const Vec3<T> since = s.force - s.turned;
    const T apart = dot(since, since);
    const auto reverses = dot(slip, since) < zero || !(apart > T(0x1p-80) * dot(s.force, s.force));  // beyond rounding
    s.turned = select(reverses, s.force, s.turned);
    const T gone = select(reverses, zero, sqrt(apart));
    const auto left = gone > zero, slips = distance > zero;
    const Vec3<T> e = select(left, since * (one / select(left, gone, one)),
                             slip * select(slips, one / select(slips, distance, one), zero));

    const T along = dot(s.turned, e);
    const T way = sqrt(larger(cap * cap - dot(s.turned, s.turned) + along * along, zero)) - along;  // (1)
    const auto some = way > zero;
    const T per_way = select(some, one / select(some, way, one), zero);
    const T w = cube_root(larger(one - gone * per_way, zero));  // (1 − r)^⅓
    const T d = dot(slip, e);
    const T square = w * w - T(2.0 / 3.0) * k0 * d * per_way;
    const auto slides = !(some && square > zero);  // all along e: the circle turns the force towards the slip
    const T v = sqrt(larger(square, zero)), sum = w + v;
    const auto softens = sum > zero;
    const T mean = k0 * T(2.0 / 3.0) * select(softens, (w * w + w * v + v * v) / select(softens, sum, one), zero);
    s.force += slip * k0 + e * (d * (select(slides, k0, mean) - k0));  // (2)

    const T size = dot(s.force, s.force);
    const auto over = size > cap * cap;
    s.force = shortened(s.force, over, size, cap);

    TangentialForce<T> out;
    const auto all = slides || over;
    const Vec3<T> trial = s.force + k.slip * select(all, zero, f.damping_t);
    const T total = dot(trial, trial);
    out.force = shortened(trial, total > cap * cap, total, cap);
    const auto holds = k0 > zero, bounded = cap > zero;
    const T force = sqrt(dot(s.force, s.force));
    const T c = cube_root(one / (one + force * select(bounded, one / select(bounded, cap, one), zero)));
    out.energy = partial_slip_energy(force, select(holds, one / select(holds, k0, one), zero), c);  // (3)
    return out;
  }
};

}  // namespace contact
