#include "libdem/forces_smooth.h"

#include <algorithm>

namespace dem {
SmoothPass::SmoothPass(World& world, double dt)
    : ForcePass(world, dt), bodies_{p_.motion.data(), p_.orientation.data(), p_.size.data(), p_.inertia.data()} {}

// A quarter of what the chunk from `first` on reads and writes: all at once would wait for one another.
[[gnu::always_inline]] inline void SmoothPass::fetch_ahead(const Met& met, std::size_t first,
                                                           std::size_t quarter) const {
  constexpr std::size_t step = chunk_size / 4;
  const std::size_t last = std::min(first + (quarter + 1) * step, met.count);
  for (std::size_t i = first + quarter * step; i < last; ++i) {
    prefetch_body(met.b[i]);
    const Slot* slot = &c_.slot[c_.first_slot(met.seat[i])];
    __builtin_prefetch(&c_.history[met.seat[i]], 1);
    __builtin_prefetch(slot, 1);
    __builtin_prefetch(slot + 1, 1);
  }
}

// What laws in stages want beside the rest, and maps, of the good lanes: those of them for which it is there. The
// others get no overlap: nothing is booked of them.
std::uint32_t SmoothPass::prepare_stages(const std::uint32_t* record, std::size_t n, std::uint32_t good,
                                         Scratch& s) const {
  std::copy_n(record, n, s.record);
  s.gained = false;
  for (std::size_t i = 0; i < n; ++i) {
    if (map_ != LawMap::automatic) {
      const double radius = c_.memory[record[i] * c_.words + world_.law.words];
      s.law.radius_eff[i] = radius;
      if (!(radius > 0)) good &= ~(std::uint32_t(1) << i);
    }
    s.arm_a[i] = get(s.smooth.a.arm, i);
    s.arm_b[i] = get(s.smooth.b.arm, i);
    if ((good >> i & 1) == 0) s.law.overlap[i] = s.law.history_overlap[i] = 0;
  }
  return good;
}

std::size_t SmoothPass::answer_smooth(const Bin& bin, std::size_t chunk, std::uint32_t* rest, Scratch& s,
                                      Tally& t) const {
  const Met& met = bin.met;
  const std::size_t first = chunk * chunk_size, n = std::min(chunk_size, met.count - first);
  const std::uint32_t *record = &met.record[first], *a = &met.a[first], *b = &met.b[first], *seat = &met.seat[first];
  LawChunk& l = s.law;
  contact::kernels::SmoothChunk& pairs = s.smooth;
  const contact::kernels::SmoothKernels& smooth =
      bin.a == shapes::Kind::ellipse ? set_.smooth->ellipses : set_.smooth->ellipsoids;
  std::uint32_t good = 0;  // bit i: lane i touched
  for (std::size_t i = 0; i < n; ++i) {
    good |= static_cast<std::uint32_t>(c_.touching[record[i]]) << i;
    load_pair(i, met.pair[first + i], s);
  }
  set_.load_history(c_.history.data(), seat, n, l);
  smooth.gather(bodies_, a, b, n, lattice_, pairs, l);
  fetch_ahead(met, first + chunk_size, 0);
  const contact::kernels::SmoothMeetings now = smooth.meet(pairs, l, n, wanted_.tolerance);
  good &= now.overlapping;
  const std::uint32_t all = lanes_below(n);
  double memory[chunk_size][contact::kernels::memory_words + 2];  // of lanes that are not good: laws, map, energy
  if (staged_) {
    good = prepare_stages(record, n, good, s);
    each_bit(all & ~good, [&](std::size_t i) { std::copy_n(&c_.memory[record[i] * c_.words], c_.words, memory[i]); });
  }
  if (now.turned)
    for (std::size_t i = 0; i < n; ++i)
      if ((good >> i & 1) != 0 && dot(get(l.history_normal, i), get(l.normal, i)) < -0.9)
        s.through.push_back(record[i]);
  fetch_ahead(met, first + chunk_size, 1);
  run_law(n, false, s);
  fetch_ahead(met, first + chunk_size, 2);
  smooth.torques(pairs, l, n, staged_);
  std::size_t left = 0;
  each_bit(all & ~good, [&](std::size_t i) {  // as they were, without force
    const contact::History& h = c_.history[seat[i]];
    put(l.history_force, i, h.force_t);
    put(l.history_normal, i, h.normal);
    l.history_overlap[i] = h.overlap;
    l.history_twist[i] = h.twist;
    for (Lane3* lane : {&l.force, &l.couple, &l.couple_b}) put(*lane, i, {});
    if (staged_) std::copy_n(memory[i], c_.words, &c_.memory[record[i] * c_.words]);
    rest[left++] = met.place[first + i];
  });
  fetch_ahead(met, first + chunk_size, 3);
  store_double(seat, n, s);
  t.candidates += n - left;
  t.touching += n - left;
  return left;
}

}  // namespace dem
