// Sides of polygons under a corner, lanes across contacts, compiled once per instruction set.
#include "libcontact/kernels/gather.h"
#include "libcontact/kernels/in_line.h"
#include "libcontact/kernels/polygon_side.h"
#include "libcontact/kernels/rows.h"
#include "shapes/math/pack.h"

namespace contact::kernels {
inline namespace KERNEL_SET {
namespace {

using shapes::Pack;
using std::experimental::vector_aligned;
using F = Flat<Pack>;
using PolygonLane = PolygonChunk::Lane;

template <class L>
[[gnu::always_inline]] inline Pack load(const L& l, std::size_t i) {
  return Pack(&l.v[i], vector_aligned);
}
template <class L>
[[gnu::always_inline]] inline F load2(const L* l, std::size_t i) {
  return {load(l[0], i), load(l[1], i)};
}
template <class L>
[[gnu::always_inline]] inline void store(L& l, std::size_t i, const Pack& p) {
  p.copy_to(&l.v[i], vector_aligned);
}
[[gnu::always_inline]] inline void store2(PolygonLane* l, std::size_t i, const F& v) {
  store(l[0], i, v.x);
  store(l[1], i, v.y);
}
[[gnu::always_inline]] inline void store2(Lane3& l, std::size_t i, const F& v) {
  store(l.x, i, v.x);
  store(l.y, i, v.y);
  store(l.z, i, Pack(0));
}
[[gnu::always_inline]] inline F choose(const Pack::mask_type& mask, const F& a, const F& b) {
  return {select(mask, a.x, b.x), select(mask, a.y, b.y)};
}

// Records, one after another or wherever they are, as lanes: row by row, four at a time.
[[gnu::always_inline]] inline void put(const Rows& rows, PolygonLane* lanes, std::size_t i) {
  const Rows r = rows.turned();
  const auto lane = [&](int k) -> Row& { return *reinterpret_cast<Row*>(&lanes[k].v[i]); };
  lane(0) = r.a;
  lane(1) = r.b;
  lane(2) = r.c;
  lane(3) = r.d;
}
[[gnu::always_inline]] inline Rows load_rows(const double* const* list, std::size_t k) {
  return {row_of(list[0], 0, 0, k), row_of(list[1], 0, 0, k), row_of(list[2], 0, 0, k), row_of(list[3], 0, 0, k)};
}
void gather_rows(PolygonChunk& c, const Motion* motion, std::size_t count) {
  const std::size_t whole = (count + PolygonChunk::widest - 1) / PolygonChunk::widest * PolygonChunk::widest;
  for (std::size_t i = 0; i < whole; i += 4) {
    for (std::size_t k = 0; k < 4; ++k) {
      put(load_rows(c.side + i, k), c.of_side + 4 * k, i);
      put(load_rows(c.corner + i, k), c.of_corner + 4 * k, i);
    }
    for (int b = 0; b < 2; ++b)
      for (std::size_t k = 0; k < 3; ++k)
        put(Rows::load(motion, sizeof(Motion), c.body[b] + i, k), c.of_motion[b] + 4 * k, i);
  }
}

[[gnu::always_inline]] inline PolygonSide<Pack> side_of(const PolygonChunk& c, std::size_t i) {
  const PolygonLane* l = c.of_side;
  return {load2(l, i),    load2(l + 2, i), load2(l + 4, i), load2(l + 6, i), load2(l + 8, i),
          load(l[10], i), load(l[11], i),  load(l[12], i),  load(l[13], i)};
}
[[gnu::always_inline]] inline PolygonCorner<Pack> corner_of(const PolygonChunk& c, std::size_t i) {
  const PolygonLane* l = c.of_corner;
  return {load2(l, i),      {load2(l + 2, i), load2(l + 4, i)}, {load2(l + 6, i), load2(l + 8, i)},
          load2(l + 10, i), {load(l[12], i), load(l[13], i)},   {load(l[14], i), load(l[15], i)}};
}

[[gnu::always_inline]] inline Pack to_nearest(const Pack& d, double inverse, double length) {
  const Pack big = Lattice::rounder;
  return d - ((d * inverse + big) - big) * length;
}

// Of v = ω × x in the plane.
[[gnu::always_inline]] inline F turned_by(const Pack& spin, const F& x) { return {-(spin * x.y), spin * x.x}; }

template <bool parts>
[[gnu::always_inline]] inline std::uint32_t answer(PolygonChunk& c, std::size_t i, const Lattice* lattice,
                                                   LawChunk& l) {
  const Pack zero = 0;
  const PolygonLane *a = c.of_motion[0], *b = c.of_motion[1];
  F offset = load2(b, i) - load2(a, i);
  if (lattice != nullptr)
    offset = {to_nearest(offset.x, lattice->inverse.x, lattice->length.x),
              to_nearest(offset.y, lattice->inverse.y, lattice->length.y)};
  // Solved from the body that seen_from_b says, whose origin is the other one's measure.
  const auto turned = offset.x < zero || (offset.x == zero && offset.y < zero);
  const auto self_is_b = load(c.self_is_b, i) > zero, self_first = turned == self_is_b;
  const F way = choose(turned, {-offset.x, -offset.y}, offset), none{zero, zero};
  FlatPlace<Pack> place[2];
  for (int k = 0; k < 2; ++k) {  // as rotation_matrix
    const Pack z = load(c.quat_z[k], i), z2 = z + z;
    place[k] = {load(c.scale[k], i), Pack(1) - z * z2, load(c.quat_w[k], i) * z2, none};
  }
  const auto pick = [&](const Pack& of_a, const Pack& of_b) { return select(self_is_b, of_b, of_a); };
  const FlatPlace<Pack> self{pick(place[0].scale, place[1].scale), pick(place[0].cosine, place[1].cosine),
                             pick(place[0].sine, place[1].sine), choose(self_first, none, way)};
  const FlatPlace<Pack> other{pick(place[1].scale, place[0].scale), pick(place[1].cosine, place[0].cosine),
                              pick(place[1].sine, place[0].sine), choose(self_first, way, none)};
  const Pack ra = load(a[3], i), rb = load(b[3], i);
  const auto size_of = [&](const Pack& x) { return select(x < zero, -x, x); };
  const Pack size = Pack(0x1.00001p1) * (shapes::larger(size_of(offset.x), size_of(offset.y)) + (ra + rb));
  SideMeeting<Pack> m;
  const auto found =
      m.solve<parts>(side_of(c, i), corner_of(c, i), self, other, size, shapes::lesser(ra, rb),
                     load(c.scale[0], i) * load(c.core[0], i) + load(c.scale[1], i) * load(c.core[1], i));

  const auto in_a = [&](const F& x) { return choose(turned, x + offset, x); };
  const auto from_a = [&](const F& n) { return choose(self_is_b, {-n.x, -n.y}, n); };
  const F point = in_a(m.point), normal = from_a(m.normal), arm_b = point - offset;
  store2(c.arm_a, i, point);
  store2(c.arm_b, i, arm_b);
  store2(c.centre, i, in_a(m.centre));
  store2(c.outward, i, from_a(m.out));
  store(c.gain, i, m.gain);
  store(l.overlap, i, m.depth);
  store2(l.normal, i, normal);
  const Pack level = select(self_is_b, -m.level, m.level);
  store(l.normal.z, i, level);
  // As ForcePass::gather.
  const Pack spin_a = load(a[10], i), spin_b = load(b[10], i);
  F velocity = load2(a + 4, i) + turned_by(spin_a, point);
  velocity = velocity - (load2(b + 4, i) + turned_by(spin_b, arm_b));
  if (lattice != nullptr) velocity = velocity - F{lattice->rate.x * offset.x, lattice->rate.y * offset.y};
  store2(l.velocity, i, velocity);
  const auto spin_sum = [&](int k) { return load(a[8 + k], i) + load(b[8 + k], i); };
  store(l.turn, i, Pack(0.5) * (spin_sum(0) * normal.x + spin_sum(1) * normal.y + spin_sum(2) * level));
  const Pack ea = load(a[11], i), eb = load(b[11], i);
  store(l.radius_eff, i, ea * eb / (ea + eb));
  const auto inverse_mass = [&](const Pack& inverse, const F& arm, const Pack& inertia) {
    const Pack t = arm.x * normal.y - arm.y * normal.x;
    return inverse + t * t / inertia;
  };
  const Pack w = inverse_mass(load(a[7], i), point, load(c.inertia[0], i)) +
                 inverse_mass(load(b[7], i), arm_b, load(c.inertia[1], i));
  store(l.mass_eff, i, Pack(1) / w);
  store(l.relative_spin.x, i, zero);
  store(l.relative_spin.y, i, zero);
  store(l.relative_spin.z, i, spin_a - spin_b);
  const F along{-m.out.y, m.out.x};
  store(l.spread_xx, i, m.spread * along.x * along.x);
  store(l.spread_yy, i, m.spread * along.y * along.y);
  store(l.spread_xy, i, m.spread * along.x * along.y);
  for (Lane* none_of : {&l.spread_zz, &l.spread_xz, &l.spread_yz}) store(*none_of, i, zero);
  std::uint32_t bits = 0;
  for (std::size_t k = 0; k < Pack::size(); ++k) bits |= found[k] ? std::uint32_t(1) << (i + k) : 0;
  return bits;
}

}  // namespace

KERNEL_IN_LINE std::uint32_t polygon_sides(const Motion* motion, const Lattice* lattice, PolygonChunk& c,
                                           std::size_t count, bool parts, LawChunk& law) {
  gather_rows(c, motion, count);
  std::uint32_t bits = 0;
  for (std::size_t i = 0; i < count; i += Pack::size())
    bits |= parts ? answer<true>(c, i, lattice, law) : answer<false>(c, i, lattice, law);
  return count < PolygonChunk::size ? bits & ((std::uint32_t(1) << count) - 1) : bits;
}

}  // namespace KERNEL_SET
}  // namespace contact::kernels
