// Contacts of spheres from their bodies to their slots in one go: nothing of them stands in memory between. Lanes run
// across contacts; compiled once per instruction set. The bits are those of gather, `spheres`, law kernel and store
// (law.kernel.cpp), which serve laws in stages.
#include "libcontact/kernels/gather.h"
#include "libcontact/kernels/law_kernel.h"
#include "libcontact/kernels/rows.h"
#include "libcontact/kernels/sphere_meeting.h"
#include "libcontact/laws/normal/hertz.h"
#include "libcontact/laws/normal/linear.h"

namespace contact::kernels {
inline namespace KERNEL_SET {
namespace {

#ifdef __AVX512F__
inline constexpr int width = 8;
#else
inline constexpr int width = 4;
#endif
using W = Wide<width>;
using WRows = RowsOf<width>;
using V3 = shapes::Vec3<W>;

#define IN_LINE [[gnu::always_inline]] inline

IN_LINE W lanes_at(const Lane& l, std::size_t i) { return *reinterpret_cast<const W::Lanes*>(&l.v[i]); }
IN_LINE V3 vector_of(const WRows& r) { return {r.a, r.b, r.c}; }
IN_LINE void store(const V3& v, const W& fourth, void* base, std::size_t size, const Index* index, std::size_t row,
                   std::size_t count) {
  WRows{v.x.v, v.y.v, v.z.v, fourth.v}.turned().store(base, size, index, row, count);
}

template <class Normal>
struct Force {
  V3 on_b, spring;
};

// `begins`: some of the contacts may begin in this step, or end (kinematics()).
template <class Normal, bool begins>
IN_LINE Force<Normal> force_of(const SphereMeeting<W>& m, const W& depth, const W& before, const W& mass_eff,
                               const V3& carried_spring, const PairOf<W>& p, double dt, const LawOptions& options) {
  Kinematics<W> k = kinematics(m.normal, m.velocity, depth, before, before == W(0.0), W(dt), options.clip);
  k.radius_eff = m.radius_eff;
  k.mass_eff = mass_eff;
  if constexpr (!begins) {
    k.dt_contact = W(dt);
    k.onset = W(0.0);
  }
  typename Normal::template State<W> none{};
  const NormalForce<W> f = Normal::update(p, k, options, none);
  CoulombSpring::State<W> s{carried_spring};
  const V3 tangential = CoulombSpring::update(p, k, f, options, s).force;
  return {k.normal * f.force + tangential, s.force};
}

template <class Normal, bool periodic>
IN_LINE SphereMeetings contacts(const SphereContacts& c) {
  W touching(0.0), turned(0.0);  // as sums of powers of two
  W::Lanes bit;
  for (int i = 0; i < width; ++i) bit[i] = static_cast<double>(1U << i);
  W bits(bit);
  for (std::size_t i = 0; i < c.count; i += width, bits = bits * W(static_cast<double>(1U << width))) {
    const WRows xa = WRows::load(c.motion, sizeof(Motion), c.a + i, 0).turned(),
                xb = WRows::load(c.motion, sizeof(Motion), c.b + i, 0).turned();
    V3 offset = vector_of(xb) - vector_of(xa);
    if constexpr (periodic) {  // as Lattice::nearest
      const W big(Lattice::rounder);
      const shapes::Vec3d &l = c.lattice->length, &inverse = c.lattice->inverse;
      offset.x = offset.x - ((offset.x * W(inverse.x) + big) - big) * W(l.x);
      offset.y = offset.y - ((offset.y * W(inverse.y) + big) - big) * W(l.y);
      offset.z = offset.z - ((offset.z * W(inverse.z) + big) - big) * W(l.z);
    }
    const WRows va = WRows::load(c.motion, sizeof(Motion), c.a + i, 1).turned(),
                vb = WRows::load(c.motion, sizeof(Motion), c.b + i, 1).turned();
    V3 velocity = vector_of(va) - vector_of(vb);
    if constexpr (periodic) {  // as Lattice::flow
      const shapes::Vec3d& g = c.lattice->rate;
      velocity = velocity - V3{W(g.x) * offset.x, W(g.y) * offset.y, W(g.z) * offset.z};
    }
    const W mass_eff = W(1.0) / (W(va.d) + W(vb.d));
    const WRows wa = WRows::load(c.motion, sizeof(Motion), c.a + i, 2).turned(),
                wb = WRows::load(c.motion, sizeof(Motion), c.b + i, 2).turned();
    const SphereMeeting<W> m = meeting_of<W>(offset, xa.d, xb.d, velocity, vector_of(wa), vector_of(wb));
    const WRows spring = WRows::load(c.history, sizeof(History), c.seat + i, 0).turned(),
                last = WRows::load(c.history, sizeof(History), c.seat + i, 1).turned();
    const W before = spring.d, depth = larger(m.overlap, W(0.0));
    const V3 old_normal = vector_of(last);
    *reinterpret_cast<W::Lanes*>(&c.overlap_before->v[i]) = before.v;
    touching = touching + select(m.touch, bits, W(0.0));
    turned = turned + select(dot(old_normal, m.normal) < W(0.0), bits, W(0.0));
    const PairOf<Lane>& lanes = *c.pair;
    PairOf<W> p;
    each_parameter(p, lanes, [i](W& x, const Lane& l) { x = lanes_at(l, i); });
    const V3 carried_spring = carried(vector_of(spring), old_normal, m.normal, m.turn * W(c.dt));
    const bool begins = !c.options->clip || any_of(before == W(0.0));
    const Force<Normal> f = begins ? force_of<Normal, true>(m, depth, before, mass_eff, carried_spring, p, c.dt, *c.options)
                                   : force_of<Normal, false>(m, depth, before, mass_eff, carried_spring, p, c.dt, *c.options);
    const V3 on_a = -f.on_b;
    const std::size_t left = c.count - i;
    store(f.spring, depth, c.history, sizeof(History), c.seat + i, 0, left);
    store(m.normal, last.d, c.history, sizeof(History), c.seat + i, 1, left);
    store(on_a, m.arm_a, c.slot, sizeof(Slot), c.seat + i, 0, left);
    store(cross(m.normal, on_a), m.arm_b, c.slot, sizeof(Slot), c.seat + i, 1, left);
  }
  double sum = 0, sum_turned = 0;
  for (int i = 0; i < width; ++i) {
    sum += touching.v[i];
    sum_turned += turned.v[i];
  }
  return {static_cast<std::uint32_t>(sum), static_cast<std::uint32_t>(sum_turned)};
}

}  // namespace

KERNEL_IN_LINE SphereMeetings sphere_contacts_hertz(const SphereContacts& c) {
  return c.lattice != nullptr ? contacts<Hertz, true>(c) : contacts<Hertz, false>(c);
}
KERNEL_IN_LINE SphereMeetings sphere_contacts_linear(const SphereContacts& c) {
  return c.lattice != nullptr ? contacts<Linear, true>(c) : contacts<Linear, false>(c);
}

}  // namespace KERNEL_SET
}  // namespace contact::kernels
