// Partial slip of a Hertz contact with nothing forgotten: Mindlin & Deresiewicz's solution for every path of normal and
// tangential motion, as a diagram over the depth z of Hertz (0 … overlap), in vectors.
//   Ft = μ F Σ_k D_k (x_k^1.5 − x_{k−1}^1.5), x = z/overlap, |D| <= 1, F the elastic normal force      [N]   (1)
//   slip held = κ μ Σ_k D_k (z_k − z_{k−1}), κ = E*/(4 G*)                                             [m]   (2)
//   stored = 3/2 F κ μ² z ∫ sqrt(x) U·D dx, U(x) = ∫_x^1 D dx                                          [J]   (3)
// A step to the overlap z, with the slip d:
//   z fell: layers above it are cut off, the need is n = d/(κ μ) + the ∫ D dz that they held                 (4)
//   z grew by h and |d| <= κ μ h: a new layer sticks, D = d/(κ μ h)                                          (5)
//   else the annulus slips in to the depth q at which |n + ∫_q^z D dz| = z − q, and is one layer with
//   D = (n + ∫_q^z D dz)/(z − q); in a layer, from its top, that is (1 − D²) t² + 2 (s − N·D) t = N² − s²    (6)
//   nowhere: all slips, D is the direction of n + ∫_0^z D dz
// The contact is as springs side by side, one for every depth ζ at which it once began: each is stretched by
// κ μ ∫_ζ^z D dz, at most by κ μ (z − ζ), and slips against its own force; (3) is their energy, and no step stores more
// than the work that its end force does. In one dimension a step is exact at any size if it is straight in overlap and
// slip. In two, the annulus slips in one direction.
// When a 13th layer is there, the neighbours whose fusion changes the force least are made one (memory_layers.h); no
// energy comes from it. `merges` counts them. Only a contact that sticks as it grows asks for many layers.
// Dashpots: where the normal one has brought the pressing force below F, the D shrink with the cap. Where all slips the
// force is μ · pressing force; elsewhere the tangential dashpot is added, no part of the memory, up to that cap.
// μ = 0: no force. μ >= 2^20, or infinite: no slip, Ft ← Ft · a/a_old (where the contact shrinks) + 8 G* a d.
// Needs a contact of Hertz. Sources: Mindlin & Deresiewicz, J. Appl. Mech. 20 (1953) 327; layers: Jäger, Arch. Appl.
// Mech. 65 (1995) 478. Accuracy: rounding where nothing was merged; an impact that sticks for long (s' of 0.06 μ vn)
// misses s' by 0.003 μ vn. Cost: 14 square roots, 0.3 µs.
// Tests: tests/libcontact/laws_memory_diagram.cpp, laws_oblique.cpp
#pragma once

#include "libcontact/laws/state.h"
#include "libcontact/laws/tangential/memory_layers.h"

namespace contact {

struct MemoryDiagram {
  static constexpr const char* name = "memory_diagram";
  static constexpr const char* parameters = "friction";
  static constexpr const char* remark = "micro-slip of a Hertz contact, exact for any path; a diagram of 12 layers";
  static constexpr const char* source = "Mindlin & Deresiewicz 1953, as a memory diagram (Jäger 1995)";
  static constexpr int layers = 12, vectors = 1 + layers;
  template <class T>
  struct State {
    Vec3<T> force{};          // elastic, on b, N
    Vec3<T> share[layers]{};  // D_k, of the part of μ F that acts, –
    T depth[layers]{};        // z_k, m, rising; those not in use: the overlap
    T merges{};               // how often two layers were made one
  };

  template <class T>
  static TangentialForce<T> update(const PairOf<T>& p, const Kinematics<T>& k, const NormalForce<T>& f,
                                   const LawOptions&, State<T>& s) {
    using std::sqrt;
    const auto slipless = p.friction >= T(0x1p20), rubs = p.friction > T(0) && p.friction < T(0x1p20);
    const T z = larger(k.overlap, T(0)), before = s.depth[layers - 1], zero(0);
    const T mu = select(rubs, p.friction, zero);
    const T kappa = p.young_eff / (T(4) * p.shear_eff);
    const Vec3<T> slip = k.slip * k.dt_contact;
    const auto grows = z > before;

    // (4)
    const Vec3<T> put = slip * select(rubs, T(1) / (kappa * select(rubs, mu, T(1))), zero);
    Vec3<T> need = put;
    for (int i = 0; i < layers; ++i)
      need += s.share[i] * larger(s.depth[i] - larger(i > 0 ? s.depth[i - 1] : zero, z), zero);
    const T grown = select(grows, z - before, zero);
    const auto sticks = grows && !(dot(need, need) > grown * grown);  // (5)

    // (6): inwards, layer by layer, to the one that does not slip as a whole.
    auto goes_on = !sticks;
    Vec3<T> n = need, held{};
    T gone = grown, top = zero, thick = zero;
    for (int i = layers - 1; i >= 0; --i) {
      const T high = lesser(s.depth[i], z), low = i > 0 ? lesser(s.depth[i - 1], z) : zero;
      const Vec3<T> below = n + s.share[i] * (high - low);
      const T gone_below = gone + (high - low);
      const auto stops = goes_on && !(dot(below, below) > gone_below * gone_below);
      held = select(stops, s.share[i], held);
      top = select(stops, high, top);
      thick = select(stops, high - low, thick);
      goes_on = goes_on && !stops;
      n = select(goes_on, below, n);
      gone = select(goes_on, gone_below, gone);
    }
    const T a = T(1) - dot(held, held), b = gone - dot(n, held), c = larger(dot(n, n) - gone * gone, zero);
    const T root = sqrt(larger(b * b + a * c, zero));
    const auto steep = b > zero, flat = a > zero;
    const T t =
        select(steep, c / select(steep, b + root, T(1)), select(flat, (root - b) / select(flat, a, T(1)), thick));
    const auto all = goes_on;
    const T eaten = select(all, zero, lesser(t, thick));
    const T q = select(sticks, before, select(all, zero, top - eaten));
    n += held * eaten;
    const T length = select(sticks, grown, sqrt(dot(n, n)));
    const auto moved = length > zero;
    const Vec3<T> fresh = select(moved, n * (T(1) / select(moved, length, T(1))), Vec3<T>{zero, zero, zero});

    // What is left below q, and the new layer on top of it.
    T depth[layers + 1], used(0);
    Vec3<T> share[layers + 1];
    for (int i = 0; i < layers; ++i) {
      const auto stays = (i > 0 ? s.depth[i - 1] : zero) < q;
      depth[i] = select(stays, lesser(s.depth[i], q), z);
      share[i] = select(stays, s.share[i], Vec3<T>{zero, zero, zero});
      used = used + select(stays, T(1), zero);
    }
    depth[layers] = z;
    share[layers] = {zero, zero, zero};
    for (int i = 0; i <= layers; ++i) share[i] = select(used == T(i), fresh, share[i]);
    const auto touches = z > zero;
    const T per_depth = select(touches, T(1) / select(touches, z, T(1)), zero);
    T y[layers + 1];  // sqrt(x)
    for (int i = 0; i <= layers; ++i) y[i] = sqrt(depth[i] * per_depth);
    T shrink(1);
    const auto full = used == T(layers) && z > q;
    if (diagram::any(full)) diagram::fuse<layers>(full, put * (per_depth / T(1.5)), share, depth, y, shrink);
    s.merges = s.merges + select(full, T(1), zero);

    // Shrunk where the dashpot takes from the pressing force.
    Vec3<T> elastic = diagram::pull(share, y, layers) * (shrink * mu * f.elastic);  // (1)
    const T unloaded = select(z < before, z / select(z < before, before, T(1)), T(1));
    elastic = select(slipless, s.force * sqrt(unloaded) + slip * f.stiffness_t, elastic);
    const T cap = capped(p.friction, f.holding);
    const T square = dot(elastic, elastic);
    const auto eased = f.holding < f.elastic && square > cap * cap;
    const T ease = select(eased, cap / sqrt(select(eased, square, T(1))), T(1));
    shrink = shrink * ease;
    s.force = elastic * ease;
    for (int i = 0; i < layers; ++i) {
      s.share[i] = share[i] * shrink;
      s.depth[i] = depth[i];
    }

    TangentialForce<T> out;
    const auto slides = all && rubs;
    const Vec3<T> trial = s.force + k.slip * select(slides, zero, f.damping_t);
    const T size = dot(trial, trial);
    out.force = shortened(trial, (slides && size > zero) || size > cap * cap, size, cap);
    const auto springs = slipless && f.stiffness_t > zero;
    out.energy = select(springs, T(0.5) * dot(s.force, s.force) / select(springs, f.stiffness_t, T(1)),
                        T(1.5) * kappa * mu * mu * f.elastic * z * diagram::stored(s.share, y, layers));
    return out;
  }
};

}  // namespace contact
