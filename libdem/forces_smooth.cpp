#include "libdem/forces_smooth.h"

#include <bit>

namespace dem {

SmoothPass::SmoothPass(World& world, double dt)
    : ForcePass(world, dt), bodies_{p_.motion.data(), p_.orientation.data(), p_.size.data(), p_.inertia.data()} {}

std::size_t SmoothPass::answer_smooth(const Bin& bin, const std::uint32_t* places, std::size_t count,
                                      std::uint32_t* rest, Scratch& s, Tally& t) const {
  std::size_t n = 0, left = 0;
  const auto flush = [&] {
    for (std::uint32_t bad = answer_lanes(bin, n, s); bad != 0; bad &= bad - 1) {
      rest[left++] = s.entry[std::countr_zero(bad)];
      --t.touching;
    }
    t.candidates += n;
    t.touching += n;
    n = 0;
  };
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint32_t r = places[i], k = bin.records[r];
    if (c_.touching[k] == 0) {
      rest[left++] = r;
      continue;
    }
    const std::uint32_t seat = c_.seat[k];
    __builtin_prefetch(&c_.history[seat], 1);
    const Slot* slot = &c_.slot[c_.first_slot(seat)];
    __builtin_prefetch(slot, 1);
    __builtin_prefetch(slot + 1, 1);
    s.entry[n] = r;
    s.record[n] = k;
    s.seat[n] = seat;
    s.index_a[n] = bin.a_index[r];
    s.index_b[n] = bin.b_index[r];
    load_pair(n, bin.pair[r], s);
    if (++n == chunk_size) flush();
  }
  if (n > 0) flush();
  return left;
}

// The pairs in lanes 0 … n−1. Bit i: the one in lane i was not solved, or overlaps no more, and is as it was.
std::uint32_t SmoothPass::answer_lanes(const Bin& bin, std::size_t n, Scratch& s) const {
  LawChunk& l = s.law;
  contact::kernels::SmoothChunk& pairs = s.smooth;
  const contact::kernels::SmoothSet& smooth = *set_.smooth;
  for (std::uint32_t* list : {s.seat, s.index_a, s.index_b}) pad(list, n);
  set_.load_history(c_.history.data(), s.seat, n, l);
  smooth.gather(bodies_, s.index_a, s.index_b, n, lattice_, pairs, l);
  const auto meet = bin.a == shapes::Kind::ellipse ? smooth.ellipses : smooth.ellipsoids;
  const contact::kernels::SmoothMeetings now = meet(pairs, l, n, wanted_.tolerance);
  const std::uint32_t all = n < chunk_size ? (std::uint32_t(1) << n) - 1 : ~std::uint32_t(0);
  const std::uint32_t bad = all & ~now.overlapping;
  if (now.turned)
    for (std::size_t i = 0; i < n; ++i)
      if ((bad >> i & 1) == 0 && dot(get(l.history_normal, i), get(l.normal, i)) < -0.9)
        s.through.push_back(s.record[i]);
  contact::History kept[chunk_size];
  for (std::uint32_t left = bad; left != 0; left &= left - 1) {
    const auto i = static_cast<std::size_t>(std::countr_zero(left));
    kept[i] = c_.history[s.seat[i]];
  }
  run_law(n, false, s);
  smooth.torques(pairs, l, n);
  store_double(s.seat, n, s);
  for (std::size_t i = 0; i < n; ++i) c_.centre[s.record[i]] = get(pairs.a.arm, i);
  for (std::uint32_t left = bad; left != 0; left &= left - 1) {
    const auto i = static_cast<std::size_t>(std::countr_zero(left));
    c_.history[s.seat[i]] = kept[i];
  }
  return bad;
}

}  // namespace dem
