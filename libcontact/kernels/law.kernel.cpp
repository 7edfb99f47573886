// The law kernels over a chunk, compiled once per instruction set. Lanes run across contacts; lanes past `count` work
// on whatever numbers they hold and are never read.
#include <limits>

#include "libcontact/kernels/extreme_sets.h"
#include "libcontact/kernels/gather.h"
#include "libcontact/laws/normal/hertz.h"
#include "libcontact/laws/normal/linear.h"
#include "libcontact/laws/tangential/coulomb_spring.h"
#include "shapes/math/pack.h"

namespace contact::kernels {
inline namespace KERNEL_SET {
namespace {

using shapes::Pack;
using V = shapes::Vec3<Pack>;
using std::experimental::vector_aligned;

inline Pack load(const Lane& l, std::size_t i) { return Pack(&l.v[i], vector_aligned); }
inline V load(const Lane3& l, std::size_t i) { return {load(l.x, i), load(l.y, i), load(l.z, i)}; }
inline void store(Lane& l, std::size_t i, const Pack& p) { p.copy_to(&l.v[i], vector_aligned); }
inline void store(Lane3& l, std::size_t i, const V& p) {
  store(l.x, i, p.x);
  store(l.y, i, p.y);
  store(l.z, i, p.z);
}

struct HertzMindlin {
  static NormalForce<Pack> normal(const LawChunk& c, std::size_t i, const Kinematics<Pack>& k, const Pack& least) {
    return Hertz::update<Pack>({load(c.young_eff, i), load(c.damping, i), least}, k);
  }
  static Pack stiffness_t(const LawChunk& c, std::size_t i, const NormalForce<Pack>& f) {
    return Pack(8) * load(c.shear_eff, i) * f.contact_radius;  // (9.16)
  }
  using Normal = Hertz;
  static constexpr bool shrinks = true;
};

struct SpringDashpot {
  static NormalForce<Pack> normal(const LawChunk& c, std::size_t i, const Kinematics<Pack>& k, const Pack& least) {
    return Linear::update<Pack>({load(c.stiffness_n, i), load(c.damping, i), least}, k);
  }
  static Pack stiffness_t(const LawChunk& c, std::size_t i, const NormalForce<Pack>&) { return load(c.stiffness_t, i); }
  using Normal = Linear;
  static constexpr bool shrinks = false;
};

// The moments that a patch adds to its resultant: rolling and twisting are resisted by the same springs and dashpots as
// the centre, spread over the patch as its depth is (second moment S about the centre).
//   rolling damping  M = cn n × (S (n × ω))                  the normal dashpots, summed over the patch
//   twist            kt tr S per radian, ct tr S, cap μ F sqrt(tr S)
// The rolling moment is bounded by F sqrt(tr S): the resultant stays within the patch. `pressing` is max(F, 0),
// `holding` is μ times it.
inline V patch_couple(LawChunk& c, std::size_t i, const V& n, const NormalForce<Pack>& f, const Pack& pressing,
                      const Pack& holding, const Pack& kt, const Pack& ct, const Pack& dt_contact,
                      const Pack& fresh_factor) {
  using std::sqrt;
  const V w = load(c.relative_spin, i);
  const Pack xx = load(c.spread_xx, i), yy = load(c.spread_yy, i), zz = load(c.spread_zz, i), xy = load(c.spread_xy, i),
             xz = load(c.spread_xz, i), yz = load(c.spread_yz, i);
  const Pack trace = xx + yy + zz, arm = sqrt(trace);
  const V u = cross(n, w);
  const V su = {xx * u.x + xy * u.y + xz * u.z, xy * u.x + yy * u.y + yz * u.z, xz * u.x + yz * u.y + zz * u.z};
  V rolling = cross(n, su) * f.damping;
  const Pack cap_r = pressing * arm, size2 = dot(rolling, rolling);
  const auto beyond = size2 > cap_r * cap_r;
  rolling = rolling * select(beyond, cap_r / sqrt(select(beyond, size2, Pack(1))), Pack(1));
  const Pack rate = dot(w, n);
  Pack elastic = load(c.history_twist, i) * fresh_factor + kt * trace * rate * dt_contact;
  Pack moment = elastic + ct * trace * rate;
  const Pack cap = holding * arm;
  const auto slides = moment * moment > cap * cap;
  moment = select(slides, select(moment < Pack(0), -cap, cap), moment);
  elastic = select(slides, moment, elastic);
  store(c.history_twist, i, elastic);
  return rolling - n * moment;
}

template <class Law, bool patch>
__attribute__((flatten)) void law_kernel(LawChunk& c, std::size_t count, double dt_scalar, const LawOptions& options) {
  using std::sqrt;
  const Pack dt(dt_scalar), zero(0), one(1);
  const Pack least(options.clip ? 0 : -std::numeric_limits<double>::infinity());
  for (std::size_t i = 0; i < count; i += Pack::size()) {
    const V n = load(c.normal, i), v = load(c.velocity, i);
    const Pack depth = larger(load(c.overlap, i), zero), before = load(c.history_overlap, i);
    const Pack vn = dot(v, n);
    // First contact: only the part of the step since δ = 0 counts.
    const auto fresh = before == zero;
    const Pack travelled = vn * dt;
    const Pack part = select(travelled > depth, depth / select(travelled > depth, travelled, one), one);
    const Pack dt_contact = select(fresh, part * dt, dt);
    Pack onset = select(fresh && travelled > zero, part, zero);
    if (!options.clip) {  // a dashpot that pulls does so as long as there is overlap, no longer
      const auto ends = -travelled > depth;
      onset = select(ends, depth / select(ends, -travelled, one), onset);
    }
    const Kinematics<Pack> k{depth, n, vn, v - n * vn, load(c.radius_eff, i), load(c.mass_eff, i), dt, onset};
    const NormalForce<Pack> f = Law::normal(c, i, k, least);
    const Pack pressing = larger(f.force, zero);
    // Not μ F where μ is infinite and F is not there.
    const Pack holding = select(pressing > zero, load(c.friction, i) * pressing, zero);
    Pack shrink = one;
    if (Law::shrinks && options.rescale) {
      const auto unloading = depth < before;
      shrink = select(unloading, sqrt(depth / select(unloading, before, one)), one);
    }
    V elastic = carried(load(c.history_force, i), load(c.history_normal, i), n, load(c.turn, i) * dt) * shrink;
    const Pack kt = Law::stiffness_t(c, i, f);
    const Pack ct = Pack(Law::Normal::damping_factor) * load(c.damping, i) * sqrt(k.mass_eff * kt);
    const V ft = CoulombSpring::update(kt, ct, holding, k.slip, dt_contact, elastic);
    store(c.force, i, -(n * f.force + ft));
    if constexpr (patch) store(c.couple, i, patch_couple(c, i, n, f, pressing, holding, kt, ct, dt_contact, shrink));
    store(c.history_force, i, elastic);
    store(c.history_normal, i, n);
    store(c.history_overlap, i, depth);
  }
}

// Overlap, normal and contact-point velocity of sphere pairs; the contact point is midway in the overlap.
bool spheres(const SphereChunk& s, LawChunk& c, std::size_t count) {
  using std::sqrt;
  typename Pack::mask_type turned(false);
  for (std::size_t i = 0; i < count; i += Pack::size()) {
    const V d = load(s.offset, i);
    const Pack ra = load(s.radius_a, i), rb = load(s.radius_b, i);
    const Pack square = dot(d, d), distance = sqrt(square);
    const V n = d * (Pack(1) / distance);
    const Pack overlap = (ra + rb) - distance, half = Pack(0.5) * overlap;
    const V wa = load(s.spin_a, i), wb = load(s.spin_b, i);
    const V lever = wa * (ra - half) + wb * (rb - half);
    store(c.overlap, i, overlap);
    store(c.normal, i, n);
    store(c.velocity, i, load(c.velocity, i) + cross(lever, n));
    store(c.turn, i, Pack(0.5) * dot(wa + wb, n));
    store(c.radius_eff, i, ra * rb / (ra + rb));
    turned = turned || dot(load(c.history_normal, i), n) < Pack(0);
  }
  return any_of(turned);
}

void sphere_torques(const SphereChunk& s, LawChunk& c, std::size_t count) {
  for (std::size_t i = 0; i < count; i += Pack::size()) {
    const V n = load(c.normal, i), nf = cross(n, load(c.force, i));
    const Pack half = Pack(0.5) * load(c.overlap, i);
    store(c.couple, i, nf * (load(s.radius_a, i) - half));
    store(c.couple_b, i, nf * (load(s.radius_b, i) - half));
  }
}

}  // namespace

const KernelSet& kernel_set() {
#define KERNEL_NAME_(x) #x
#define KERNEL_NAME(x) KERNEL_NAME_(x)
  static constexpr KernelSet set{KERNEL_NAME(KERNEL_SET),
                                 spheres,
                                 sphere_torques,
                                 law_kernel<HertzMindlin, false>,
                                 law_kernel<SpringDashpot, false>,
                                 law_kernel<HertzMindlin, true>,
                                 law_kernel<SpringDashpot, true>,
                                 sphere_clearance,
                                 gather_spheres,
                                 periodic_clearance,
                                 periodic_gather,
                                 load_history,
                                 store_history,
                                 store_slots,
                                 sum_slots,
                                 {ellipsoid_proofs, ellipsoid_search},
                                 {lowest, lowest_two}};
  return set;
}

}  // namespace KERNEL_SET
}  // namespace contact::kernels
