// A force law over a chunk of contacts, lanes across contacts, in one pass: a normal law without memory, then the
// tangential spring under its cap. Laws that remember more, and every other combination, go through stages (stages.h).
//
// Normal is a normal law (laws/state.h) whose State is empty. `law_kernel<Normal, patch>` is a LawKernel (chunk.h). The
// library compiles it once per instruction set (KERNEL_SET names the namespace); a host that includes this compiles it
// for its own, and gets the same bits.
//
// Cost: see bench; history as of laws/law.h. Tests: tests/libcontact/laws_*.cpp, tests/linkable (a law of a host)
#pragma once

#include "libcontact/kernels/chunk.h"
#include "libcontact/kernels/in_line.h"
#include "libcontact/laws/state.h"
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
inline PairOf<Pack> load(const PairOf<Lane>& lanes, std::size_t i) {
  PairOf<Pack> p;
  each_parameter(p, lanes, [i](Pack& x, const Lane& l) { x = load(l, i); });
  return p;
}
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
// The rolling moment is bounded by F sqrt(tr S): the resultant stays within the patch.
inline V patch_couple(LawChunk& c, std::size_t i, const V& n, const NormalForce<Pack>& f, const Pack& friction,
                      const Pack& dt_contact) {
  using std::sqrt;
  const V w = load(c.relative_spin, i);
  const Pack xx = load(c.spread_xx, i), yy = load(c.spread_yy, i), zz = load(c.spread_zz, i), xy = load(c.spread_xy, i),
             xz = load(c.spread_xz, i), yz = load(c.spread_yz, i);
  const Pack trace = xx + yy + zz, arm = sqrt(trace);
  const V u = cross(n, w);
  const V su = {xx * u.x + xy * u.y + xz * u.z, xy * u.x + yy * u.y + yz * u.z, xz * u.x + yz * u.y + zz * u.z};
  V rolling = cross(n, su) * f.damping;
  const Pack cap_r = f.holding * arm, size2 = dot(rolling, rolling);
  const auto beyond = size2 > cap_r * cap_r;
  rolling = shortened(rolling, beyond, size2, cap_r);
  const Pack rate = dot(w, n);
  Pack elastic = load(c.history_twist, i) * f.shrink + f.stiffness_t * trace * rate * dt_contact;
  Pack moment = elastic + f.damping_t * trace * rate;
  const Pack cap = capped(friction, f.holding) * arm;
  const auto slides = moment * moment > cap * cap;
  moment = select(slides, select(moment < Pack(0), -cap, cap), moment);
  elastic = select(slides, moment, elastic);
  store(c.history_twist, i, elastic);
  return rolling - n * moment;
}

// What the law sees of a contact, or of lanes of them; `fresh`: of one that begins in this step.
template <class T, class Mask>
Kinematics<T> kinematics(const shapes::Vec3<T>& normal, const shapes::Vec3<T>& velocity, const T& depth,
                         const T& depth_before, const Mask& fresh, const T& dt, bool clip) {
  const T zero(0), one(1);
  Kinematics<T> k;
  k.normal = normal;
  k.overlap = depth;
  k.overlap_before = depth_before;
  k.closing_speed = dot(velocity, k.normal);
  k.slip = velocity - k.normal * k.closing_speed;
  k.dt = dt;
  // First contact: only the part of the step since δ = 0 counts.
  const T travelled = k.closing_speed * dt;
  const T part = select(travelled > depth, depth / select(travelled > depth, travelled, one), one);
  k.dt_contact = select(fresh, part * dt, dt);
  k.onset = select(fresh && travelled > zero, part, zero);
  if (!clip) {  // a dashpot that pulls does so as long as there is overlap, no longer
    const auto ends = -travelled > depth;
    k.onset = select(ends, depth / select(ends, -travelled, one), k.onset);
  }
  return k;
}
template <class Mask>
Kinematics<Pack> kinematics(const LawChunk& c, std::size_t i, const Pack& depth, const Mask& fresh, const Pack& dt,
                            bool clip) {
  Kinematics<Pack> k =
      kinematics(load(c.normal, i), load(c.velocity, i), depth, load(c.history_overlap, i), fresh, dt, clip);
  k.radius_eff = load(c.radius_eff, i);
  k.mass_eff = load(c.mass_eff, i);
  return k;
}

template <class Normal, bool patch>
KERNEL_IN_LINE void law_kernel(LawChunk& c, std::size_t count, double dt, const LawOptions& options) {
  typename Normal::template State<Pack> none{};
  for (std::size_t i = 0; i < count; i += Pack::size()) {
    const Pack depth = larger(load(c.overlap, i), Pack(0));
    const Kinematics<Pack> k = kinematics(c, i, depth, load(c.history_overlap, i) == Pack(0), Pack(dt), options.clip);
    const PairOf<Pack> p = load(c.pair, i);
    const NormalForce<Pack> f = Normal::update(p, k, options, none);
    CoulombSpring::State<Pack> s{
        carried(load(c.history_force, i), load(c.history_normal, i), k.normal, load(c.turn, i) * k.dt)};
    const V ft = CoulombSpring::update(p, k, f, options, s).force;
    store(c.force, i, -(k.normal * f.force + ft));
    if constexpr (patch) store(c.couple, i, patch_couple(c, i, k.normal, f, p.friction, k.dt_contact));
    store(c.history_force, i, s.force);
    store(c.history_normal, i, k.normal);
    store(c.history_overlap, i, depth);
  }
}

}  // namespace KERNEL_SET
}  // namespace contact::kernels
