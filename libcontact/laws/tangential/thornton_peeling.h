// Tangential force of an adhesive contact: the contact peels, and when it has, it slips as without adhesion under a
// larger pressing force. F the elastic normal force (JKR), Fc = (3/2) π W R*, κ = E*/(4 G*).
//   peeling:  a³ = (3R*/(4E*)) (F + 2Fc + sqrt(4 F Fc + 4 Fc² − κ Ft²)), at most the radius without Ft   [m³]  (9.15)
//     Ft ← Ft · a/a_old (where a fell, by F or by Ft itself) + 8 G* a d: Ft = 8 G* a x as long as a falls [N]   (9.16)
//     ends at |Ft| >= 4 sqrt((G*/E*)(F Fc + Fc²)), where the root in (9.15) is 0                          [N]   (9.17)
//   peeled, until the contact ends:  a³ = (3R*/(4E*)) (F + 2Fc)                                           [m³]  (9.18)
//     Box 9.1 (mindlin_deresiewicz.h) with this a and H in place of F; |Ft| <= μ H:
//     H = F + 2Fc;  F < −0.3 Fc:  H = Fh (1 − (Fh − F)/(3 Fh))^1.5,  Fh = F + 2Fc + 2 sqrt(F Fc + Fc²)    [N]   (9.19)
// A contact whose friction is below (9.17) drops to μ H at once; until then adhesion holds it beyond μ H, at μ = 0 too.
// H has a step of 0.9 % at −0.3 Fc, as the source has. W = 0: Box 9.1 from the start. Dashpots: that of the normal law
// adds to H; the tangential one is added where not all slips, up to the larger of (9.17) and μ H.
// (9.15) and (9.16) hold at the end of the step, whatever its size: peeling.h (1).
// Energy: Ft²/(16 G* a) while it peels, then that of Box 9.1                                              [J]
// μ >= 2^20, or infinite: never slips.
// Source: Thornton, J. Phys. D 24 (1991) 1942; Savkoor & Briggs, Proc. R. Soc. A 356 (1977) 103; Thornton & Yin, Powder
// Technol. 65 (1991) 153. For JKR. Cost: that of Box 9.1, three cube roots, 5 square roots.
// Tests: tests/libcontact/laws_thornton_peeling.cpp
#pragma once

#include "libcontact/laws/state.h"
#include "libcontact/laws/tangential/mindlin_deresiewicz.h"
#include "libcontact/laws/tangential/peeling.h"

namespace contact {

struct ThorntonPeeling {
  static constexpr const char* name = "thornton_peeling";
  static constexpr const char* parameters = "friction, work_of_adhesion (J/m^2)";
  static constexpr const char* remark =
      "an adhesive contact peels, then slips as of mindlin_deresiewicz; a closed path may create 2.5 % of what "
      "was stored; safe: coulomb_spring";
  static constexpr const char* source = "Thornton 1991; Savkoor & Briggs 1977";
  static constexpr int vectors = MindlinDeresiewicz::vectors;
  template <class T>
  struct State : MindlinDeresiewicz::State<T> {
    T peeled{};  // 1: nothing is left to peel
    T radius{};  // a of the last step, m
  };

  template <class T>
  static TangentialForce<T> update(const PairOf<T>& p, const Kinematics<T>& k, const NormalForce<T>& f,
                                   const LawOptions& o, State<T>& s) {
    using std::sqrt;
    const T zero(0), one(1);
    const auto touches = f.contact_radius > zero;
    const T h = select(touches, peeling::pressing(p, k.radius_eff, f.elastic), zero);
    const T holding = larger(h + (f.holding - (f.elastic + T(2) * peeling::pull_off(p, k.radius_eff))), zero);
    const T limit = select(touches, peeling::peel_force(p, k.radius_eff, f.elastic), zero);
    const T before = sqrt(dot(s.force, s.force));
    const auto peels = touches && !(s.peeled > zero) && before < limit;

    // Ft/a before the step and what the slip adds to it.
    const auto had = s.radius > zero;
    const Vec3<T> slip = k.slip * (T(8) * p.shear_eff * k.dt_contact);
    const Vec3<T> pull = s.force * select(had, one / select(had, s.radius, one), zero) + slip;
    T a = peeling::radius(p, k.radius_eff, f.elastic, limit + limit);  // (9.18)
    a = select(peels, a * peeling::growth(p, k.radius_eff, f.elastic, a * sqrt(dot(pull, pull))), a);
    a = select(a < f.contact_radius, a, f.contact_radius);
    const auto shrinks = a < s.radius;
    const T shrink = select(shrinks, a / select(shrinks, s.radius, one), one), kt = T(8) * p.shear_eff * a;

    // Peeled.
    NormalForce<T> pressed = f;
    pressed.elastic = h;
    pressed.holding = select(touches, holding, zero);
    pressed.stiffness_t = kt;
    pressed.shrink = shrink;
    typename MindlinDeresiewicz::State<T> slips = s;
    const TangentialForce<T> slipping = MindlinDeresiewicz::update(p, k, pressed, o, slips);

    // Peeling, or just peeled to the end.
    const Vec3<T> held = s.force * shrink + slip * a;
    const T size = sqrt(dot(held, held));
    const auto pulls = size > zero, ends = peels && !(size < limit);
    const T cap = capped(p.friction, h);
    const T most = select(ends && cap < size, cap, size);
    const T per_size = select(pulls, one / select(pulls, size, one), zero);
    const Vec3<T> along = held * per_size, kept = along * most;
    const T bound = larger(limit, capped(p.friction, holding));
    const Vec3<T> trial = kept + k.slip * select(ends, zero, f.damping_t);
    const T total = dot(trial, trial);
    const auto beyond = total > bound * bound;

    s.force = select(peels, kept, slips.force);
    s.axis = select(peels, along, slips.axis);
    s.turned = select(peels, zero, slips.turned);
    s.high = select(peels, zero, slips.high);
    s.low = select(peels, zero, slips.low);
    s.pressing = h;
    s.deficit = select(peels, zero, slips.deficit);
    s.peeled = select(touches && (ends || !peels), one, zero);
    s.radius = select(touches, a, zero);
    TangentialForce<T> out;
    out.force = select(peels, shortened(trial, beyond, total, bound), slipping.force);
    const auto stiff = kt > zero;
    out.energy = select(peels, T(0.5) * most * most / select(stiff, kt, one), slipping.energy);
    return out;
  }
};

}  // namespace contact
