// Adhesive elastic contact after Johnson, Kendall & Roberts: made at first touch, held on across a gap, let go there.
//   δ  = a²/R* − sqrt(2π W a/E*)              contact radius a, the larger root      [m]     (9.13)
//   Fe = 4E* a³/(3R*) − sqrt(8π W E* a³) = 2 E* a (δ − a²/(3R*))                     [N]     (9.12), then with (9.13)
//   δf = −(3/4)(π² W² R*/E*²)^⅓,  Fe = −5/9 Fc   where it lets go                    [m]     (1)
//   Fc = (3/2) π W R*                         pull-off force, the least that Fe takes [N]    (8.106)
//   U  = ∫ Fe dδ from δf = E* a (δ²/2 + hδ/3 − (3/10)h²) − (16/5) E* af⁵/R*²,  h = a²/R*    [J]     (2)
//   F  = Fe + s w cn dδ/dt + (w₀ − 1)(−8/9 Fc) + (w₁ − 1) min(Fe, 0),   cn = 2 sqrt(5/6) β sqrt(m* 2E* a)    [N]
//   kt = 8 G* a  (9.16);  what friction multiplies: F + 2 Fc  (9.19)
// A contact is made at δ >= 0, where Fe jumps to −8/9 Fc, and not before: of 7.09 (W⁵ R*⁴/E*²)^⅓ that it costs to part
// the bodies, nothing comes back. w₀ = f + ½ in the step that makes it, of which the part f was spent in contact, and
// w₁ = g + ½ where it will let go after the part g of the next step, else 1: the impulses of the two jumps; the speed
// after an impact then misses at order dt^1.5. s, w: tsuji_dashpot of kinematics.h. When clipped the dashpot does not
// pull: F >= min(Fe, 0). (9.13) without iteration on a double root: with α = a/R*, D = δ/R*, x = π W/(4 E* R*),
// Ferrari's resolvent
//   ν³ + D ν = x,   r = sqrt(D + ν²),   α = r + sqrt(ν(2r − ν))                                                  (3)
// has one positive root, a simple one, for every D >= δf/R* = −3(x/2)^⅔: four steps of Halley.
// Accuracy: a and Fe are those of a δ that is within 1.5e-15 max(δ, |δf|) of the given one. Where δ >= 0 a is right to
// 5e-16 and Fe to 2e-15 max(Fe, Fc); at δf da/dδ is infinite, and rounding of δ alone moves a by 1e-8 of itself. W = 0:
// Hertz.
// Stiffness reported: 2 E* a, more than dFe/dδ (9.14) everywhere; |dFe/dδ| is more only for a³ < 2 af³, where Fe falls
// as δ grows: nothing oscillates there and no step is unstable, however steep it becomes.
// Source: Johnson, Kendall & Roberts, Proc. R. Soc. A 324 (1971) 301; Thornton & Yin, Powder Technol. 65 (1991) 153.
// Valid a << R*, Tabor's number > 5. Cost: 11 square roots, 18 divisions. Tests: tests/libcontact/laws_jkr.cpp
#pragma once

#include "libcontact/laws/state.h"
#include "shapes/math/cube_root.h"

namespace contact {

// The radius that (9.13) gives on the stable branch, and where it ends.
template <class T>
struct JkrRadius {
  T a;        // m
  T least;    // af: of the branch's end, m
  T pull;     // Fc, N
  T release;  // δf, m
};

template <class T>
JkrRadius<T> jkr_radius(const T& young_eff, const T& work_of_adhesion, const T& radius_eff, const T& overlap) {
  using std::sqrt;
  constexpr double pi = 3.14159265358979323846;
  const T x = T(pi / 4) * work_of_adhesion / (young_eff * radius_eff);
  const T fold = shapes::cube_root(T(0.5) * x);
  const T depth = overlap / radius_eff;
  const T d = larger(depth, T(-3) * fold * fold);
  const T root = T(1.2599210498948732) * fold;  // of x
  const auto gap = d < T(0);
  const T above = select(gap, root * root - T(0.31) * d, x);
  const T below = select(gap, root, d + root * root);
  T v = select(below > T(0), above / select(below > T(0), below, T(1)), T(0));
  for (int i = 0; i < 4; ++i) {  // Halley on (3)
    const T f = (v * v + d) * v - x, slope = T(3) * v * v + d;
    const T under = slope * slope - T(3) * v * f;
    const auto fine = under > T(0);
    v = v - select(fine, f * slope / select(fine, under, T(1)), T(0));
  }
  const T r = sqrt(larger(d + v * v, T(0)));
  return {radius_eff * (r + sqrt(v * larger(r + r - v, T(0)))), radius_eff * fold,
          T(1.5 * pi) * work_of_adhesion * radius_eff, T(-3) * radius_eff * fold * fold};
}

struct Jkr {
  static constexpr const char* name = "jkr";
  static constexpr const char* parameters = "young (Pa), poisson, restitution, work_of_adhesion (J/m^2)";
  static constexpr const char* remark = "adhesive Hertz: made at touch, let go across a gap; kt = 8 G* a";
  static constexpr const char* source = "Johnson, Kendall & Roberts 1971; Thornton & Yin 1991";
  static constexpr Loss loss = Loss::adhesive;
  static constexpr bool adheres = true;
  static constexpr double damping_factor = 1.8257418583505538;  // 2 sqrt(5/6)
  template <class T>
  struct State {
    T bonded{};
    T radius{};  // of the last step, m
  };

  static double range(const PairParameters& p, double radius_eff) {
    return -jkr_radius(p.young_eff, p.work_of_adhesion, radius_eff, 0.0).release;  // (1)
  }

  template <class T>
  static NormalForce<T> update(const PairOf<T>& p, const Kinematics<T>& k, const LawOptions& o, State<T>& s) {
    using std::sqrt;
    const auto held = s.bonded > T(0);
    const JkrRadius<T> c = jkr_radius(p.young_eff, p.work_of_adhesion, k.radius_eff, k.overlap);
    const auto bonded = (held || k.overlap >= T(0)) && !(k.overlap < c.release);
    const T a = select(bonded, c.a, T(0));
    const T kn = T(2) * p.young_eff * a, h = a * a / k.radius_eff;
    const T fe = kn * (k.overlap - h * T(1.0 / 3));  // (9.12)
    const Dashpot<T> d = tsuji_dashpot(T(damping_factor) * p.damping, kn, k);
    const T f = fe + d.weight * d.damping * k.closing_speed;
    const T clipped = o.clip ? larger(f, select(fe < T(0), fe, T(0))) : f;
    const T made = select(bonded && !held && k.onset > T(0), T(0.5) - k.onset, T(0));  // 1 − w₀
    const T left = k.overlap - c.release, parting = (clipped * k.dt / k.mass_eff - k.closing_speed) * k.dt;
    const auto ends = bonded && fe < T(0) && parting > left;
    const T lets_go = select(ends, left / select(ends, parting, T(1)) - T(0.5), T(0));  // w₁ − 1
    NormalForce<T> out;
    out.force = clipped + made * (T(8.0 / 9) * c.pull) + lets_go * fe;
    out.elastic = fe;
    out.stiffness = kn;
    out.damping = d.damping;
    out.contact_radius = a;
    out.stiffness_t = T(8) * p.shear_eff * a;  // (9.16)
    out.damping_t = T(damping_factor) * p.damping * sqrt(k.mass_eff * out.stiffness_t);
    out.holding = select(bonded, larger(clipped + T(2) * c.pull, T(0)), T(0));  // (9.19)
    const auto shrinks = s.radius > a;
    out.shrink = o.rescale ? select(shrinks, a / select(shrinks, s.radius, T(1)), T(1)) : T(1);
    const T least = c.least * c.least / k.radius_eff;
    out.energy =
        select(bonded,
               p.young_eff * (a * (T(0.5) * k.overlap * k.overlap + h * (k.overlap * T(1.0 / 3) - T(0.3) * h)) -
                              T(3.2) * c.least * least * least),
               T(0));  // (2)
    out.bond = select(bonded, T(1), T(0));
    s.bonded = out.bond;
    s.radius = a;
    return out;
  }
};

}  // namespace contact
