// Contacts of ellipsoids and of ellipses, lanes across contacts, compiled once per instruction set.
#include "libcontact/kernels/smooth.h"

#include "libcontact/kernels/ellipse_search.h"
#include "libcontact/kernels/ellipsoid_search.h"
#include "libcontact/kernels/gather.h"
#include "libcontact/kernels/law_kernel.h"
#include "libcontact/kernels/rows.h"
#include "shapes/math/pack.h"

namespace contact::kernels {
inline namespace KERNEL_SET {
namespace {

using shapes::Mat3;
using shapes::Quatd;
using shapes::Vec3d;

[[gnu::always_inline]] inline Row& row_at(Lane& lane, std::size_t i) { return *reinterpret_cast<Row*>(&lane.v[i]); }
template <bool planar>
[[gnu::always_inline]] inline void put(Lane3& v, std::size_t i, const Rows& r) {
  row_at(v.x, i) = r.a;
  row_at(v.y, i) = r.b;
  if constexpr (!planar) row_at(v.z, i) = r.c;
}

// Rows that are not aligned, or short of their fourth number: z stands for it.
[[gnu::always_inline]] inline void load_row(const Quatd& q, Row& r) { __builtin_memcpy(&r, &q, sizeof(r)); }
[[gnu::always_inline]] inline void load_row(const Vec3d& v, Row& r) {
  using Two = double __attribute__((vector_size(16)));
  Two xy, yz;
  __builtin_memcpy(&xy, &v.x, sizeof(xy));
  __builtin_memcpy(&yz, &v.y, sizeof(yz));
  r = __builtin_shufflevector(xy, yz, 0, 1, 3, 3);
}
template <class T>
[[gnu::always_inline]] inline Rows lanes_of(const T* array, const Index* index) {
  Rows r;
  load_row(array[index[0]], r.a);
  load_row(array[index[1]], r.b);
  load_row(array[index[2]], r.c);
  load_row(array[index[3]], r.d);
  return r.turned();
}
template <bool planar>
[[gnu::always_inline]] inline void gather_body(const SmoothBodies& bodies, const Index* index, std::size_t i,
                                               SmoothChunk::Body& out) {
  const Rows q = lanes_of(bodies.orientation, index);
  row_at(out.turn[0], i) = q.a;
  row_at(out.turn[3], i) = q.d;
  put<planar>(out.size, i, lanes_of(bodies.size, index));
  if constexpr (planar) {
    for (std::size_t k = 0; k < 4; ++k) out.inertia.z[i + k] = bodies.inertia[index[k]].z;
  } else {
    row_at(out.turn[1], i) = q.b;
    row_at(out.turn[2], i) = q.c;
    put<planar>(out.inertia, i, lanes_of(bodies.inertia, index));
  }
}

template <bool planar, bool periodic>
[[gnu::always_inline]] inline void gather_pairs(const SmoothBodies& bodies, const Index* a, const Index* b,
                                                std::size_t count, [[maybe_unused]] const Lattice* lattice,
                                                SmoothChunk& s, LawChunk& c) {
  const Motion* motion = bodies.motion;
  for (std::size_t i = 0; i < count; i += 4) {
    const Rows xa = Rows::load(motion, sizeof(Motion), a + i, 0).turned();
    const Rows xb = Rows::load(motion, sizeof(Motion), b + i, 0).turned();
    Rows d{xb.a - xa.a, xb.b - xa.b, xb.c - xa.c, xb.d};
    const Rows va = Rows::load(motion, sizeof(Motion), a + i, 1).turned();
    const Rows vb = Rows::load(motion, sizeof(Motion), b + i, 1).turned();
    Rows v{va.a - vb.a, va.b - vb.b, va.c - vb.c, va.d + vb.d};
    if constexpr (periodic) {
      to_nearest(*lattice, d.a, d.b, d.c);
      leave_flow(*lattice, d.a, d.b, d.c, v.a, v.b, v.c);
    }
    put<planar>(s.offset, i, d);
    put<planar>(c.velocity, i, v);
    row_at(s.inverse_mass, i) = v.d;
    const Rows wa = Rows::load(motion, sizeof(Motion), a + i, 2).turned();
    const Rows wb = Rows::load(motion, sizeof(Motion), b + i, 2).turned();
    if constexpr (planar) {
      const Row zero{};
      row_at(s.a.spin.z, i) = wa.c;
      row_at(s.b.spin.z, i) = wb.c;
      put<false>(c.relative_spin, i, {zero, zero, wa.c - wb.c, zero});
    } else {
      put<false>(s.a.spin, i, wa);
      put<false>(s.b.spin, i, wb);
      put<false>(c.relative_spin, i, {wa.a - wb.a, wa.b - wb.b, wa.c - wb.c, wa.d});
    }
    row_at(c.radius_eff, i) = wa.d * wb.d / (wa.d + wb.d);
    gather_body<planar>(bodies, a + i, i, s.a);
    gather_body<planar>(bodies, b + i, i, s.b);
  }
}

template <bool planar>
void gather(const SmoothBodies& bodies, const Index* a, const Index* b, std::size_t count, const Lattice* lattice,
            SmoothChunk& s, LawChunk& c) {
  if (lattice != nullptr)
    gather_pairs<planar, true>(bodies, a, b, count, lattice, s, c);
  else
    gather_pairs<planar, false>(bodies, a, b, count, nullptr, s, c);
}

// The power of two near the extent of pairs (scale.h), and its inverse.
struct Units {
  Pack down, up;
};
inline Units units_of(const Pack& extent) {
  using Bits = std::uint64_t __attribute__((vector_size(sizeof(Pack)), may_alias));
  alignas(sizeof(Pack)) double x[Pack::size()], down[Pack::size()], up[Pack::size()];
  extent.copy_to(x, vector_aligned);
  const Bits exponent = *reinterpret_cast<const Bits*>(x) >> 52;
  *reinterpret_cast<Bits*>(down) = (2046 - exponent) << 52;
  *reinterpret_cast<Bits*>(up) = exponent << 52;
  return {Pack(down, vector_aligned), Pack(up, vector_aligned)};
}
inline Pack magnitude(const Pack& x) { return select(x < Pack(0), -x, x); }

struct Meeting {  // of one pack
  V normal;
  typename Pack::mask_type overlapping;
};

// Runs `meet`, of the pairs of one pack, over a chunk.
template <class Meet>
[[gnu::always_inline]] inline SmoothMeetings over_chunk(const LawChunk& c, std::size_t count, Meet meet) {
  typename Pack::mask_type turned(false);
  std::uint32_t overlapping = 0;
  const Pack bit([](std::size_t k) { return static_cast<double>(1U << k); });
  for (std::size_t i = 0; i < count; i += Pack::size()) {
    const V start = load(c.history_normal, i);
    const Meeting m = meet(i, start);
    turned = turned || dot(start, m.normal) < Pack(0);
    overlapping |= static_cast<std::uint32_t>(reduce(select(m.overlapping, bit, Pack(0)))) << i;
  }
  return {overlapping, any_of(turned)};
}

// Do solved pairs overlap? To a tolerance where that is proven, and their interval narrow.
[[gnu::always_inline]] inline auto overlaps(const Pack& gap, const Pack& lower, const Pack& upper, const Pack& reach,
                                            double tolerance) {
  return tolerance > 0 ? upper < Pack(0) && upper - lower <= Pack(tolerance) * reach : gap < Pack(0);
}

[[gnu::always_inline]] inline Pack largest(const V& v) { return larger(v.x, larger(v.y, v.z)); }
[[gnu::always_inline]] inline Mat3<Pack> rotation(const Lane* turn, std::size_t i) {
  return rotation_matrix(shapes::Quat<Pack>{load(turn[0], i), load(turn[1], i), load(turn[2], i), load(turn[3], i)});
}

KERNEL_IN_LINE SmoothMeetings ellipsoids(SmoothChunk& s, LawChunk& c, std::size_t count, double tolerance) {
  return over_chunk(c, count, [&](std::size_t i, const V& start) {
    const V offset = load(s.offset, i), size_a = load(s.a.size, i), size_b = load(s.b.size, i);
    const Pack reach_a = largest(size_a), reach_b = largest(size_b);
    const Units unit =
        units_of(larger(larger(magnitude(offset.x), magnitude(offset.y)), magnitude(offset.z)) + (reach_a + reach_b));
    const Mat3<Pack> ra = rotation(s.a.turn, i), rb = rotation(s.b.turn, i);
    const V d = offset * unit.down;
    const EllipsoidSearch<Pack> search({size_a * unit.down, size_b * unit.down, ra, rb, d});
    const EllipsoidAnswer<Pack> r = search.solve(start, true, tolerance);
    const V& n = r.normal;
    const V arm_a = Pack(0.5) * (unit.up * r.inner_a + unit.up * (d - r.inner_b)), arm_b = arm_a - offset;
    const V wa = load(s.a.spin, i), wb = load(s.b.spin, i);
    const auto inverse_mass = [&](const SmoothChunk::Body& body, const Mat3<Pack>& rotation, const V& arm) {
      const V t = transposed_times(rotation, cross(arm, n)), inertia = load(body.inertia, i);
      return t.x * t.x / inertia.x + t.y * t.y / inertia.y + t.z * t.z / inertia.z;
    };
    store(c.overlap, i, -(r.gap * unit.up));
    store(c.normal, i, n);
    store(c.velocity, i, load(c.velocity, i) + (cross(wa, arm_a) - cross(wb, arm_b)));
    store(c.turn, i, Pack(0.5) * dot(wa + wb, n));
    store(c.mass_eff, i,
          Pack(1) / (load(s.inverse_mass, i) + (inverse_mass(s.a, ra, arm_a) + inverse_mass(s.b, rb, arm_b))));
    store(s.a.arm, i, arm_a);
    store(s.b.arm, i, arm_b);
    return Meeting{n, r.outcome == Pack(r.solved) &&
                          overlaps(r.gap, r.lower, r.upper, lesser(reach_a, reach_b) * unit.down, tolerance)};
  });
}

KERNEL_IN_LINE SmoothMeetings ellipses(SmoothChunk& s, LawChunk& c, std::size_t count, double tolerance) {
  using V2 = Flat<Pack>;
  return over_chunk(c, count, [&](std::size_t i, const V& start) {
    const V2 offset{load(s.offset.x, i), load(s.offset.y, i)};
    const auto body = [i](const SmoothChunk::Body& e) {  // as rotation_matrix has it
      const Pack w = load(e.turn[0], i), z = load(e.turn[3], i), z2 = z + z;
      return FlatEllipse<Pack>{load(e.size.x, i), load(e.size.y, i), Pack(1) - z * z2, w * z2};
    };
    FlatEllipse<Pack> a = body(s.a), b = body(s.b);
    const Pack reach_a = larger(a.a, a.b), reach_b = larger(b.a, b.b), zero(0);
    const Units unit = units_of(larger(magnitude(offset.x), magnitude(offset.y)) + (reach_a + reach_b));
    for (FlatEllipse<Pack>* e : {&a, &b}) {
      e->a *= unit.down;
      e->b *= unit.down;
    }
    const V2 d = unit.down * offset;
    const EllipseAnswer<Pack> r = EllipseSearch<Pack>(a, b, d).solve({start.x, start.y}, tolerance);
    const V2& n = r.normal;
    const V2 arm_a = Pack(0.5) * (unit.up * r.inner_a + unit.up * (d - r.inner_b)), arm_b = arm_a - offset;
    const Pack wa = load(s.a.spin.z, i), wb = load(s.b.spin.z, i);
    const V2 slip = wa * arm_a.turned() - wb * arm_b.turned();
    const auto inverse_mass = [&](const SmoothChunk::Body& e, const V2& arm) {
      const Pack t = arm.x * n.y - arm.y * n.x;
      return t * t / load(e.inertia.z, i);
    };
    const V normal{n.x, n.y, zero};
    store(c.overlap, i, -(r.gap * unit.up));
    store(c.normal, i, normal);
    store(c.velocity, i, {load(c.velocity.x, i) + slip.x, load(c.velocity.y, i) + slip.y, zero});
    store(c.turn, i, zero);
    store(c.mass_eff, i, Pack(1) / (load(s.inverse_mass, i) + (inverse_mass(s.a, arm_a) + inverse_mass(s.b, arm_b))));
    store(s.a.arm, i, {arm_a.x, arm_a.y, zero});
    store(s.b.arm, i, {arm_b.x, arm_b.y, zero});
    return Meeting{
        normal, r.solved > zero && overlaps(r.gap, r.lower, r.upper, lesser(reach_a, reach_b) * unit.down, tolerance)};
  });
}

void torques(const SmoothChunk& s, LawChunk& c, std::size_t count, bool moment) {
  for (std::size_t i = 0; i < count; i += Pack::size()) {
    const V f = load(c.force, i);
    V on_a = cross(load(s.a.arm, i), f), on_b = cross(f, load(s.b.arm, i));
    if (moment) {
      const V couple = load(c.couple, i);
      on_a += couple;
      on_b -= couple;
    }
    store(c.couple, i, on_a);
    store(c.couple_b, i, on_b);
  }
}
void planar_torques(const SmoothChunk& s, LawChunk& c, std::size_t count, bool moment) {
  const Pack zero(0);
  for (std::size_t i = 0; i < count; i += Pack::size()) {
    const Pack x = load(c.force.x, i), y = load(c.force.y, i);
    Pack on_a = load(s.a.arm.x, i) * y - load(s.a.arm.y, i) * x, on_b = x * load(s.b.arm.y, i) - y * load(s.b.arm.x, i);
    if (moment) {
      const Pack couple = load(c.couple.z, i);
      on_a += couple;
      on_b -= couple;
    }
    store(c.couple, i, {zero, zero, on_a});
    store(c.couple_b, i, {zero, zero, on_b});
  }
}

}  // namespace

const SmoothSet& smooth_set() {
  static const SmoothSet set{{gather<false>, ellipsoids, torques}, {gather<true>, ellipses, planar_torques}};
  return set;
}

}  // namespace KERNEL_SET
}  // namespace contact::kernels
