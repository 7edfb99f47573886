// Partial slip of a Hertz contact by the incremental rule of Box 9.1: Mindlin & Deresiewicz's loading, unloading and
// reloading, with the two turning points as its memory. F the elastic normal force, Ft along an axis t.
//   ΔFt = 8 G* a θ d + s μ (1 − θ) ΔF,   s = −1 when unloading, else 1                           [N]  (9.8), (9.9)
//   θ = 1 while ΔF > 0 and |slip| < μ ΔF/(8 G* a), else θ³, within 0 … 1, is
//     loading     1 − (Ft + μ ΔF)/(μ F)                                                               (9.10a)
//     unloading   1 − (Ft* − Ft + 2 μ ΔF)/(2 μ F)                                                     (9.10b)
//     reloading   1 − (Ft − Ft** + 2 μ ΔF)/(2 μ F)                                                    (9.10c)
//   then Ft* += μ ΔF, Ft** −= μ ΔF                                                                    (9.11)
// F and a are the new ones; Ft, Ft* and Ft** those before the step. t is the direction of Ft while loading and stays
// from the turn until the load is as large again, or reverses, or all slips; across t, ΔFt = 8 G* a θ d.
// The printed rule forgets how far a step with θ = 1 stayed behind the slip it might have made: too soft afterwards.
// options.deficit remembers it from the first tangential force on, A += μ ΔF/(8 G* a) − |slip| >= 0, and keeps θ = 1
// while A > 0; a turn clears it.
// Accuracy, against memory_diagram (exact): of first order in the step where no step sticks; printed −6 % after a
// growth that sticks, and up to −13 %; with the deficit +3 %. Where overlap and slip change together it creates energy,
// with the deficit or without: in random closed loops up to 1.2 times the most that was stored. Use memory_diagram.
// Energy: what would come back at this F from a first loading (an estimate after turns),
//   0.3 (Ft²/kt) (2 + 4c + 6c² + 3c³)/(1 + c + c²)²,   c³ = 1 − Ft/(2 μ F)                             [J]  (1)
// |Ft| <= μ F; a dashpot that lowers the pressing force lowers it too. Where all slips the force is μ · pressing force;
// elsewhere the tangential dashpot is added, no part of the memory, up to that cap.
// μ >= 2^20, or infinite: no slip, Ft ← Ft · shrink + 8 G* a d.
// Source: Seville & Wu (2016), Box 9.1, read as the project's equation sheet does; Thornton & Yin, Powder Technol. 65
// (1991) 153; Mindlin & Deresiewicz, J. Appl. Mech. 20 (1953) 327. Needs a contact of Hertz. Cost: two cube roots, 5
// square roots. Tests: tests/libcontact/laws_mindlin_deresiewicz.cpp, laws_oblique.cpp
#pragma once

#include "libcontact/laws/state.h"
#include "shapes/math/cube_root.h"

namespace contact {

struct MindlinDeresiewicz {
  static constexpr const char* name = "mindlin_deresiewicz";
  static constexpr const char* parameters = "friction";
  static constexpr const char* remark =
      "micro-slip of a Hertz contact in steps; literal: a closed path may create 0.4 % of what was stored, "
      "with deficit 4.7 %; safe: memory_diagram";
  static constexpr const char* source = "Mindlin & Deresiewicz 1953; Box 9.1 of Seville & Wu 2016";
  static constexpr int vectors = 2;
  template <class T>
  struct State {
    Vec3<T> force{};  // elastic, on b, N
    Vec3<T> axis{};   // t
    T turned{};       // 0 loading, 1 unloading, 2 reloading
    T high{}, low{};  // Ft*, Ft**, N
    T pressing{};     // F of the last step, N
    T deficit{};      // A, m
  };

  template <class T>
  static TangentialForce<T> update(const PairOf<T>& p, const Kinematics<T>& k, const NormalForce<T>& f,
                                   const LawOptions& o, State<T>& s) {
    using shapes::cube_root;
    using std::sqrt;
    const T zero(0), one(1), fn = f.elastic, kt = f.stiffness_t;
    const auto slipless = p.friction >= T(0x1p20);
    const T mu = select(slipless, zero, p.friction), limit = mu * fn, grown = mu * (fn - s.pressing);
    const auto bounded = limit > zero, stiff = kt > zero;
    const T per_limit = select(bounded, one / select(bounded, limit, one), zero);
    const T compliance = select(stiff, one / select(stiff, kt, one), zero);

    const Vec3<T> slip = k.slip * k.dt_contact;
    const T distance = sqrt(dot(slip, slip));
    const auto begun = dot(s.axis, s.axis) > zero, moves = distance > zero;
    const Vec3<T> t = select(begun, s.axis, slip * select(moves, one / select(moves, distance, one), zero));
    const T ft = dot(s.force, t), d = dot(slip, t);

    // Which branch: a turn is a slip against it, beyond rounding of the step's slip and of that to gross slip.
    const T rounding = T(0x1p-40) * larger(distance, limit * compliance);
    const auto back = d<-rounding, forth = d> rounding, was_unloading = s.turned == one;
    const auto first_turn = s.turned == zero && back, second_turn = was_unloading && forth;
    const auto unloads = back || (was_unloading && !forth), reloads = (s.turned == T(2) && !back) || second_turn;
    s.high = select(first_turn, ft, s.high);
    s.low = select(second_turn, ft, s.low);

    const T lag = select(back != was_unloading && (back || forth), zero, o.deficit ? s.deficit : zero);
    const T behind = lag + grown * compliance - distance;
    const auto sticks = behind > zero;
    const T below =
        select(unloads, T(0.5) * (s.high - ft) + grown, select(reloads, T(0.5) * (ft - s.low) + grown, ft + grown));
    const T cube = larger(one - larger(below * per_limit, zero), zero);  // (9.10)
    const T theta = select(sticks, one, cube_root(cube));
    s.deficit = select(sticks && begun, behind, zero);
    const T slid = (one - theta) * grown;
    Vec3<T> elastic = s.force + slip * (kt * theta) + t * select(unloads, -slid, slid);  // (9.9)
    const auto turned = unloads || reloads;
    s.high = select(turned, s.high + grown, zero);  // (9.11)
    s.low = select(turned, s.low - grown, zero);

    const T square = dot(elastic, elastic);
    const auto over = square > limit * limit, all = over || (cube < T(0x1p-40) && !sticks);
    elastic = shortened(elastic, over, square, limit);
    const T now = dot(elastic, t);
    const auto loads = all || !turned || (unloads && !(now > -s.high)) || (reloads && !(now < s.high));
    s.turned = select(loads, zero, select(unloads, one, T(2)));
    s.pressing = fn;

    elastic = select(slipless, s.force * f.shrink + slip * kt, elastic);
    const T cap = capped(p.friction, f.holding);
    const T strength = dot(elastic, elastic);
    const auto eased = strength > cap * cap;
    s.force = shortened(elastic, eased, strength, cap);
    const T size = sqrt(dot(s.force, s.force));
    const auto pulls = size > zero;
    const Vec3<T> along = s.force * select(pulls, one / select(pulls, size, one), zero);
    s.axis = select(loads, along, t);

    TangentialForce<T> out;
    const auto slides = all && !slipless;
    const Vec3<T> trial = s.force + k.slip * select(slides, zero, f.damping_t);
    const T total = dot(trial, trial);
    const auto beyond = (slides && total > zero) || total > cap * cap;
    out.force = shortened(trial, beyond, total, cap);
    const T c = cube_root(larger(one - T(0.5) * size * per_limit, T(0.5)));
    out.energy = partial_slip_energy(size, compliance, c);  // (1)
    return out;
  }
};

}  // namespace contact
