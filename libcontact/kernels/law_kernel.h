// A force law over a chunk of contacts, lanes across contacts: a normal law, then the tangential spring under its cap.
//
// Law, a struct without state:
//   Normal       its normal law (laws/normal), of which damping_factor is read
//   normal       static NormalForce<Pack> (const LawChunk&, std::size_t i, const Kinematics<Pack>&, const Pack& least),
//                of the lanes from i on; `least` is the force that it is cut at: 0 when clipped, else −∞
//   stiffness_t  static Pack (const LawChunk&, std::size_t i, const NormalForce<Pack>&): kt, N/m
//   shrinks      does the tangential spring shorten with the contact radius?
// `law_kernel<Law, patch>` is a LawKernel (chunk.h). The library compiles it once per instruction set (KERNEL_SET names
// the namespace); a host that includes this compiles it for its own, and gets the same bits.
//
// Cost: see bench; history as of laws/law.h. Tests: tests/libcontact/laws_*.cpp, tests/linkable (a law of a host)
#pragma once

#include <limits>

#include "libcontact/kernels/chunk.h"
#include "libcontact/laws/kinematics.h"
#include "libcontact/laws/law.h"
#include "libcontact/laws/tangential/coulomb_spring.h"
#include "shapes/math/pack.h"

#ifndef KERNEL_SET
#define KERNEL_SET host
#endif

namespace contact::kernels {
inline namespace KERNEL_SET {

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

}  // namespace KERNEL_SET
}  // namespace contact::kernels
