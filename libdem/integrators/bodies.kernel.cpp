// Bodies in lanes, four at a time; compiled once per instruction set.
#include "libdem/integrators/bodies.h"

#include "libcontact/kernels/in_line.h"
#include "libcontact/kernels/rows.h"
#include "libdem/integrators/rotation.h"

namespace dem {
inline namespace KERNEL_SET {
namespace {

using contact::Motion;
using contact::Slot;
using contact::kernels::Four;
using contact::kernels::Row;
using contact::kernels::Rows;
using V = shapes::Vec3<Four>;
using Q = shapes::Quat<Four>;
using LooseRow = double __attribute__((vector_size(32), may_alias, aligned(8)));

#define IN_LINE [[gnu::always_inline]] inline

IN_LINE const Row& row(const Motion& m, std::size_t k) { return contact::kernels::row_of(&m, 0, 0, k); }
IN_LINE Row& row(Motion& m, std::size_t k) { return contact::kernels::row_of(&m, 0, 0, k); }
IN_LINE Row without_fourth(const Row& r) { return __builtin_shufflevector(r, Row{}, 0, 1, 2, 4); }
IN_LINE Row row_of(const Vec3d& v, double fourth) { return Row{v.x, v.y, v.z, fourth}; }

// Four vectors that stand side by side, as rows (the fourth lanes hold anything), and back.
IN_LINE Rows load_rows(const Vec3d* v) {
  const double* from = &v->x;
  const Row p = *reinterpret_cast<const LooseRow*>(from), q = *reinterpret_cast<const LooseRow*>(from + 4),
            r = *reinterpret_cast<const LooseRow*>(from + 8);
  return {p, __builtin_shufflevector(p, q, 3, 4, 5, 5), __builtin_shufflevector(q, r, 2, 3, 4, 4),
          __builtin_shufflevector(r, r, 1, 2, 3, 3)};
}
IN_LINE void store_rows(Vec3d* v, const Rows& r) {
  double* to = &v->x;
  *reinterpret_cast<LooseRow*>(to) = __builtin_shufflevector(r.a, r.b, 0, 1, 2, 4);
  *reinterpret_cast<LooseRow*>(to + 4) = __builtin_shufflevector(r.b, r.c, 1, 2, 4, 5);
  *reinterpret_cast<LooseRow*>(to + 8) = __builtin_shufflevector(r.c, r.d, 2, 4, 5, 6);
}
IN_LINE V lanes(const Rows& rows) {
  const Rows t = rows.turned();
  return {t.a, t.b, t.c};
}
IN_LINE Rows rows(const V& v) { return Rows{v.x.v, v.y.v, v.z.v, v.z.v}.turned(); }
IN_LINE V load(const Vec3d* v) { return lanes(load_rows(v)); }

// The slots of one body. Whether it is a or b of a pair is as good as random: no branch on it.
IN_LINE void add_slots(const SumLists& lists, std::size_t i, Row& force, Row& torque) {
  static constexpr double sign[] = {1, -1};
  constexpr std::ptrdiff_t to_lever_b = 4;  // doubles after lever_a
  const std::uint32_t* list = lists.active + lists.start[i];
  Row f{}, t{};
  for (std::uint32_t e = 0; e < lists.count[i]; ++e) {
    const std::uint32_t is_b = list[e] & 1;
    const Slot& slot = lists.slot[lists.ring.place(list[e] >> 1)];
    const double lever = *(&slot.lever_a + to_lever_b * static_cast<std::ptrdiff_t>(is_b));
    f += contact::kernels::row_of(&slot, 0, 0, 0) * sign[is_b];
    t += contact::kernels::row_of(&slot, 0, 0, 1) * lever;
  }
  force = f;
  torque = t;
}

IN_LINE void fetch_slots(const SumLists& lists, std::size_t i) {
  const std::uint32_t* list = lists.active + lists.start[i];
  for (std::uint32_t e = 0; e < lists.count[i]; ++e) __builtin_prefetch(lists.slot + lists.ring.place(list[e] >> 1));
}

IN_LINE Row floored(const Row& x) {
  return Row{__builtin_floor(x[0]), __builtin_floor(x[1]), __builtin_floor(x[2]), __builtin_floor(x[3])};
}

// Which of four bodies are of some kinds.
struct Among {
  std::uint64_t first, second, third, fourth;
  IN_LINE Among(std::uint64_t kinds, const std::uint8_t* kind)
      : first(kinds >> kind[0] & 1),
        second(kinds >> kind[1] & 1),
        third(kinds >> kind[2] & 1),
        fourth(kinds >> kind[3] & 1) {}
  IN_LINE bool all() const { return (first & second & third & fourth) != 0; }
  IN_LINE bool none() const { return (first | second | third | fourth) == 0; }
  IN_LINE Four::Mask lanes() const {
    using Bits = Four::Bits;
    return {Bits{} - Bits{static_cast<std::int64_t>(first), static_cast<std::int64_t>(second),
                          static_cast<std::int64_t>(third), static_cast<std::int64_t>(fourth)}};
  }
};
IN_LINE Q select(const Four::Mask& m, const Q& a, const Q& b) {
  return {select(m, a.w, b.w), select(m, a.x, b.x), select(m, a.y, b.y), select(m, a.z, b.z)};
}

IN_LINE V spin_of_four(const Among& uniform, const Q& q, const V& momentum, const V& inertia) {
  const V about = momentum * (Four(1.0) / inertia.x);
  if (uniform.all()) return about;
  const V free = spin_of(q, momentum, inertia);
  return uniform.none() ? free : select(uniform.lanes(), about, free);
}

IN_LINE Q load(const Quatd* q) {
  const auto* row = reinterpret_cast<const LooseRow*>(q);
  const Rows r = Rows{row[0], row[1], row[2], row[3]}.turned();
  return {r.a, r.b, r.c, r.d};
}
IN_LINE void store(Quatd* to, const Q& q) {
  const Rows r = Rows{q.w.v, q.x.v, q.y.v, q.z.v}.turned();
  auto* row = reinterpret_cast<LooseRow*>(to);
  row[0] = r.a;
  row[1] = r.b;
  row[2] = r.c;
  row[3] = r.d;
}

// Turns four bodies by a step; their spins after it. What of their farthest points' ways comes of the turn goes to
// `way`.
IN_LINE V turn(const BodyArrays& p, const BodyStep& s, std::size_t i, const Among& uniform, const V& momentum,
               const V& inertia, const Four& radius, Four& way) {
  const V about = momentum * (Four(1.0) / inertia.x);
  const Among still(s.still, p.kind + i);
  if (still.all() && uniform.all()) return about;
  const Q before = load(p.orientation + i);
  V spin = about;
  Q q;
  if (uniform.all()) {
    q = rotated_uniformly(before, about, s.dt);
  } else {
    q = rotated_freely(before, momentum, inertia, s.dt);
    if (!uniform.none()) q = select(uniform.lanes(), rotated_uniformly(before, about, s.dt), q);
    spin = spin_of_four(uniform, q, momentum, inertia);
  }
  const V had = load(p.rotation + i);
  V has = had + spin * Four(s.dt);
  if (!still.none()) {
    q = select(still.lanes(), before, q);
    has = select(still.lanes(), had, has);
  }
  store(p.orientation + i, q);
  store_rows(p.rotation + i, rows(has));
  if (p.travel != nullptr) {  // travel_of (coherence.h)
    const Four w = q.w - before.w, x = q.x - before.x, y = q.y - before.y, z = q.z - before.z;
    way = way + Four(2.0) * radius * sqrt(w * w + x * x + y * y + z * z);
  }
  return spin;
}

// One body after the other; p points to the first of four.
struct Group {
  const BodyStep& s;
  Rows x, v, f, t;
  V momentum;

  IN_LINE static Row kicked(const Row& v, const Row& f, const Row& gravity, double h) {
    return v + (without_fourth(f) * v[3] + gravity) * h;  // the fourth lane, 1/m, stays
  }
  IN_LINE void kick() {
    const Row g = row_of(s.gravity, 0);
    const double h = 0.5 * s.dt;
    v = {kicked(v.a, f.a, g, h), kicked(v.b, f.b, g, h), kicked(v.c, f.c, g, h), kicked(v.d, f.d, g, h)};
    momentum += lanes(t) * Four(h);
  }
  IN_LINE void slow() {
    const Row by = row_of(s.flow.slowed, 1);
    v = {v.a * by, v.b * by, v.c * by, v.d * by};
  }
  // Drifts one position by its velocity; by how much, without the box.
  IN_LINE Row drift(Row& position, const Row& velocity) const {
    const Row before = position, moving{1, 1, 1, 0};
    if (s.deforms) {
      const Row centre = row_of(s.centre, 0), scale = row_of(s.flow.scale, 1);
      const Row way = velocity * (moving * (0.5 * s.dt));
      position = centre + (position + way - centre) * scale + way;
    } else {
      position = position + velocity * (moving * s.dt);
    }
    const Row moved = position - before;
    if (s.periodic) {
      const Row n = floored((position - row_of(s.lower, 0)) * row_of(s.lattice.inverse, 0));
      position = position - n * row_of(s.lattice.length, 0);
    }
    return moved;
  }
};

template <bool sums>
IN_LINE void four_bodies(const BodyArrays& p, const SumLists& lists, const BodyStep& s, std::size_t i,
                         std::size_t present, BodyTally& tally, Four& farthest) {
  Motion* m = p.motion + i;
  Group g{s,
          {row(m[0], 0), row(m[1], 0), row(m[2], 0), row(m[3], 0)},
          {row(m[0], 1), row(m[1], 1), row(m[2], 1), row(m[3], 1)},
          {},
          {},
          {}};
  if constexpr (sums) {
    add_slots(lists, i, g.f.a, g.t.a);
    add_slots(lists, i + 1, g.f.b, g.t.b);
    add_slots(lists, i + 2, g.f.c, g.t.c);
    add_slots(lists, i + 3, g.f.d, g.t.d);
    if (s.keep) {
      store_rows(p.force + i, g.f);
      store_rows(p.torque + i, g.t);
    }
    if (!s.end && !s.begin) return;
  } else {
    g.f = load_rows(p.force + i);
    g.t = load_rows(p.torque + i);
  }
  g.momentum = load(p.angular_momentum + i);
  const Among uniform(s.uniform, p.kind + i);
  const V inertia = load(p.inertia + i);
  if (s.end) {
    if (s.deforms) g.slow();
    g.kick();
  }
  V spin;
  if (s.begin) {
    g.kick();
    if (s.deforms) g.slow();
    const V moved = lanes({g.drift(g.x.a, g.v.a), g.drift(g.x.b, g.v.b), g.drift(g.x.c, g.v.c), g.drift(g.x.d, g.v.d)});
    Four way = dot(moved, moved);
    if (p.travel != nullptr) way = sqrt(way);
    spin = turn(p, s, i, uniform, g.momentum, inertia, Row{g.x.a[3], g.x.b[3], g.x.c[3], g.x.d[3]}, way);
    if (p.travel != nullptr) {
      LooseRow& travel = reinterpret_cast<LooseRow&>(p.travel[i]);
      travel = travel + way.v;
    }
    farthest = select(farthest < way, way, farthest);
    row(m[0], 0) = g.x.a;
    row(m[1], 0) = g.x.b;
    row(m[2], 0) = g.x.c;
    row(m[3], 0) = g.x.d;
  } else {
    spin = spin_of_four(uniform, load(p.orientation + i), g.momentum, inertia);
  }
  store_rows(p.angular_momentum + i, rows(g.momentum));
  row(m[0], 1) = g.v.a;
  row(m[1], 1) = g.v.b;
  row(m[2], 1) = g.v.c;
  row(m[3], 1) = g.v.d;
  const Row radii{m[0].equivalent_radius, m[1].equivalent_radius, m[2].equivalent_radius, m[3].equivalent_radius};
  const Rows w = Rows{spin.x.v, spin.y.v, spin.z.v, radii}.turned();
  row(m[0], 2) = w.a;
  row(m[1], 2) = w.b;
  row(m[2], 2) = w.c;
  row(m[3], 2) = w.d;
  if (!s.end) return;
  // A number less itself is zero, or no number where it was infinite or none.
  const auto nought = [](const Row& r) { return r - r; };
  const Row z = (nought(g.x.a) + nought(g.x.b)) + (nought(g.x.c) + nought(g.x.d)) +
                ((nought(g.v.a) + nought(g.v.b)) + (nought(g.v.c) + nought(g.v.d))) +
                ((nought(w.a) + nought(w.b)) + (nought(w.c) + nought(w.d)));
  if (z[0] + z[1] + z[2] + z[3] == 0) return;
  for (std::size_t k = 0; k < present && i + k < tally.bad; ++k) {
    const Row own = nought(row(m[k], 0)) + nought(row(m[k], 1)) + nought(row(m[k], 2));
    if (!(own[0] + own[1] + own[2] == 0)) tally.bad = i + k;
  }
}

// Four bodies of their own, for those that are left over: the last of them fill the places up.
struct LeftOver {
  std::uint8_t kind[4];
  Motion motion[4];
  Quatd orientation[4];
  Vec3d rotation[4], angular_momentum[4], inertia[4], force[4], torque[4];
  double travel[4];
  std::uint32_t start[4], count[4];
};

template <bool sums>
IN_LINE void left_over(const BodyArrays& p, const SumLists& lists, const BodyStep& s, std::size_t i,
                       std::size_t present, BodyTally& tally, Four& farthest) {
  LeftOver own;
  const auto each = [&](auto visit) {
    visit(own.motion, p.motion);
    visit(own.orientation, p.orientation);
    visit(own.rotation, p.rotation);
    visit(own.angular_momentum, p.angular_momentum);
    visit(own.force, p.force);
    visit(own.torque, p.torque);
    if (p.travel != nullptr) visit(own.travel, p.travel);
  };
  const auto in = [&](auto* to, const auto* from) {
    for (std::size_t k = 0; k < 4; ++k) to[k] = from[i + (k < present ? k : present - 1)];
  };
  each(in);
  in(own.kind, p.kind);
  in(own.inertia, p.inertia);
  if constexpr (sums) {
    in(own.start, lists.start);
    in(own.count, lists.count);
  }
  BodyTally found;
  four_bodies<sums>({own.kind, own.motion, own.orientation, own.rotation, own.angular_momentum, own.inertia, own.force,
                     own.torque, p.travel != nullptr ? own.travel : nullptr},
                    {lists.slot, lists.active, own.start, own.count, false, lists.ring}, s, 0, present, found,
                    farthest);
  each([&](const auto* from, auto* to) {
    for (std::size_t k = 0; k < present; ++k) to[i + k] = from[k];
  });
  if (found.bad < present && i + found.bad < tally.bad) tally.bad = i + found.bad;
}

template <bool sums>
IN_LINE void all_bodies(const BodyArrays& p, const SumLists& lists, const BodyStep& s, std::size_t first,
                        std::size_t last, BodyTally& tally) {
  constexpr std::size_t ahead = 8;  // bodies
  Four farthest(tally.farthest);
  std::size_t i = first;
  for (; i + 4 <= last; i += 4) {
    if (sums && lists.far)
      for (std::size_t k = i + ahead; k < i + ahead + 4 && k < last; ++k) fetch_slots(lists, k);
    four_bodies<sums>(p, lists, s, i, 4, tally, farthest);
  }
  if (i < last) left_over<sums>(p, lists, s, i, last - i, tally, farthest);
  for (int k = 0; k < 4; ++k)
    if (tally.farthest < farthest.v[k]) tally.farthest = farthest.v[k];
}

}  // namespace

KERNEL_IN_LINE void advance_bodies(const BodyArrays& p, const SumLists& lists, const BodyStep& s, std::size_t first,
                                   std::size_t last, BodyTally& tally) {
  if (s.sum)
    all_bodies<true>(p, lists, s, first, last, tally);
  else
    all_bodies<false>(p, lists, s, first, last, tally);
}

}  // namespace KERNEL_SET
}  // namespace dem
