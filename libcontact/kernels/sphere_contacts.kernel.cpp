// Contacts of spheres from their bodies to their slots in one go: nothing of them stands in memory between. Lanes run
// across contacts; compiled once per instruction set. The bits are those of gather, `spheres`, law kernel and store
// (law.kernel.cpp), which serve laws in stages; and pairs that do not touch are left at rest.
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

// Which lanes touch, and which have turned, as sums of powers of two.
struct Found {
  W touching{0.0}, turned{0.0}, bits;
  IN_LINE Found() {
    for (int i = 0; i < width; ++i) bits.v[i] = static_cast<double>(1U << i);
  }
  IN_LINE void add(const W::Mask& touch, const W::Mask& turn) {
    touching = touching + select(touch, bits, W(0.0));
    turned = turned + select(turn, bits, W(0.0));
    bits = bits * W(static_cast<double>(1U << width));
  }
  IN_LINE SphereMeetings mask() const {
    double sum = 0, sum_turned = 0;
    for (int i = 0; i < width; ++i) {
      sum += touching.v[i];
      sum_turned += turned.v[i];
    }
    return {static_cast<std::uint32_t>(sum), static_cast<std::uint32_t>(sum_turned)};
  }
};

// Eight or four contacts on their way through the law; Contacts: SphereContacts or PlaneContacts.
template <class Normal>
struct Group {
  W overlap, radius_eff, mass_eff, turn;
  V3 normal, velocity;
  W before;
  V3 spring, old_normal;
  W::Mask touch;
  V3 on_a;  // N

  template <class Contacts>
  IN_LINE void load_history(const Contacts& c, std::size_t i) {
    const WRows first = WRows::load(c.history, sizeof(History), c.seat + i, 0).turned(),
                last = WRows::load(c.history, sizeof(History), c.seat + i, 1).turned();
    spring = vector_of(first);
    before = first.d;
    old_normal = vector_of(last);
    *reinterpret_cast<W::Lanes*>(&c.overlap_before->v[i]) = before.v;
  }

  // `begins`: some of the contacts may begin in this step, or end (kinematics()).
  template <bool begins>
  IN_LINE void act(const PairOf<W>& p, const W& depth, double dt, const LawOptions& options) {
    Kinematics<W> k = kinematics(normal, velocity, depth, before, before == W(0.0), W(dt), options.clip);
    k.radius_eff = radius_eff;
    k.mass_eff = mass_eff;
    if constexpr (!begins) {
      k.dt_contact = W(dt);
      k.onset = W(0.0);
    }
    typename Normal::template State<W> none{};
    const NormalForce<W> f = Normal::update(p, k, options, none);
    CoulombSpring::State<W> s{spring};
    const V3 tangential = CoulombSpring::update(p, k, f, options, s).force;
    on_a = -(k.normal * f.force + tangential);
    spring = s.force;
  }

  // Law, and the histories back. Nothing is remembered of those that do not touch, nothing acts.
  template <class Contacts>
  IN_LINE void answer(const Contacts& c, std::size_t i) {
    const W zero(0.0), depth = larger(overlap, zero);
    const V3 none{zero, zero, zero};
    PairOf<W> p;
    each_parameter(p, *c.pair, [i](W& x, const Lane& l) { x = lanes_at(l, i); });
    spring = carried(spring, old_normal, normal, turn * W(c.dt));
    if (!c.options->clip || any_of(before == zero))
      act<true>(p, depth, c.dt, *c.options);
    else
      act<false>(p, depth, c.dt, *c.options);
    on_a = select(touch, on_a, none);
    store(select(touch, spring, none), select(touch, depth, zero), c.history, sizeof(History), c.seat + i, 0,
          c.count - i);
    store(select(touch, normal, none), zero, c.history, sizeof(History), c.seat + i, 1, c.count - i);
  }
};

template <class Normal, bool periodic>
IN_LINE SphereMeetings spheres_with_spheres(const SphereContacts& c) {
  Found found;
  for (std::size_t i = 0; i < c.count; i += width) {
    const auto apart = [&c](const Index* from, const Index* to, std::size_t row) {
      return WRows::load_apart(c.motion, sizeof(Motion), from, to, row).turned();
    };
    const WRows x = apart(c.a + i, c.b + i, 0), v = apart(c.b + i, c.a + i, 1);
    V3 offset = vector_of(x), velocity = vector_of(v);
    if constexpr (periodic) {
      to_nearest(*c.lattice, offset.x.v, offset.y.v, offset.z.v);
      leave_flow(*c.lattice, offset.x.v, offset.y.v, offset.z.v, velocity.x.v, velocity.y.v, velocity.z.v);
    }
    const auto turning = [&c](const Index* body) { return WRows::load(c.motion, sizeof(Motion), body, 2).turned(); };
    const WRows wa = turning(c.a + i), wb = turning(c.b + i);
    const SphereMeeting<W> m = meeting_of<W>(offset, wa.d, wb.d, x.d, velocity, v.d, vector_of(wa), vector_of(wb));
    Group<Normal> g;
    g.overlap = m.overlap;
    g.radius_eff = m.radius_eff;
    g.mass_eff = m.mass_eff;
    g.turn = m.turn;
    g.normal = m.normal;
    g.velocity = m.velocity;
    g.touch = m.touch;
    g.load_history(c, i);
    found.add(m.touch, dot(g.old_normal, m.normal) < W(0.0));
    g.answer(c, i);
    store(g.on_a, m.arm_a, c.slot, sizeof(Slot), c.seat + i, 0, c.count - i);
    store(cross(m.normal, g.on_a), m.arm_b, c.slot, sizeof(Slot), c.seat + i, 1, c.count - i);
  }
  return found.mask();
}

template <class Normal>
IN_LINE SphereMeetings spheres_with_planes(const PlaneContacts& c) {
  const W zero(0.0), one(1.0);
  Found found;
  for (std::size_t i = 0; i < c.count; i += width) {
    const auto body = [&](std::size_t row) { return WRows::load(c.motion, sizeof(Motion), c.a + i, row).turned(); };
    const auto plane = [&](std::size_t row) {
      return vector_of(WRows::load(c.plane, sizeof(PlaneRows), c.b + i, row).turned());
    };
    const WRows x = body(0), v = body(1);
    const V3 position = vector_of(x), spin = vector_of(body(2)), origin = plane(0), outward = plane(3),
             turning = plane(2);
    const W radius = x.d;
    Group<Normal> g;
    g.overlap = radius - dot(outward, position - origin);
    g.normal = -outward;
    const V3 arm_a = g.normal * (radius - W(0.5) * g.overlap), arm_b = position + arm_a - origin;
    g.velocity = vector_of(v) + cross(spin, arm_a) - plane(1) - cross(turning, arm_b);
    g.turn = W(0.5) * dot(spin + turning, g.normal);
    g.radius_eff = radius;
    g.mass_eff = one / W(v.d);
    g.touch = g.overlap > zero;
    g.load_history(c, i);
    found.add(g.touch, W::Mask{});
    g.answer(c, i);
    const V3 none{zero, zero, zero};
    const auto slot = [&](const V3& what, const W& lever, std::size_t row) {
      store(what, lever, c.slot, 2 * sizeof(Slot), c.seat + i, row, c.count - i);
    };
    slot(g.on_a, one, 0);
    slot(cross(arm_a, g.on_a) + none, zero, 1);
    slot(g.on_a, zero, 2);
    slot(-cross(arm_b, g.on_a) - none, one, 3);
  }
  return found.mask();
}

}  // namespace

KERNEL_IN_LINE SphereMeetings sphere_contacts_hertz(const SphereContacts& c) {
  return c.lattice != nullptr ? spheres_with_spheres<Hertz, true>(c) : spheres_with_spheres<Hertz, false>(c);
}
KERNEL_IN_LINE SphereMeetings sphere_contacts_linear(const SphereContacts& c) {
  return c.lattice != nullptr ? spheres_with_spheres<Linear, true>(c) : spheres_with_spheres<Linear, false>(c);
}
KERNEL_IN_LINE SphereMeetings plane_contacts_hertz(const PlaneContacts& c) { return spheres_with_planes<Hertz>(c); }
KERNEL_IN_LINE SphereMeetings plane_contacts_linear(const PlaneContacts& c) { return spheres_with_planes<Linear>(c); }

}  // namespace KERNEL_SET
}  // namespace contact::kernels
