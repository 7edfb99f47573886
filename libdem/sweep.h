// The way of a step through the round pairs that have met and through the bodies: chunk after chunk, and as soon as all
// pairs of a block of bodies are answered its sums, kicks and drift, while what they read and write is near. Pairs that
// have met since the list was made stand at the end of theirs, out of place: they are answered before the others.
// With several threads each goes through a range of chunks; blocks whose pairs lie in two of them come after all pairs.
// So the bits are those of doing one thing after the other.
#pragma once

#include <algorithm>

#include "libdem/integrators/bodies.h"
#include "libdem/world.h"

namespace dem {

inline constexpr std::size_t bodies_at_once = 32;
inline constexpr std::size_t chunks_at_once = 8;

// After the seats have been given, at a rebuild of the list of candidates.
void plan_sweep(World& world);
// After round pairs have met: where most of them have done so since the plan was made, as at the start of a run.
void plan_sweep_again(World& world);

// The chunks of a thread among `threads`.
struct ChunkRange {
  std::size_t first, last;
  ChunkRange(std::size_t chunks, std::size_t thread, std::size_t threads)
      : first(chunks * thread / threads), last(chunks * (thread + 1) / threads) {}
  bool holds(const Sweep& s, std::size_t block) const { return s.first[block] >= first && s.last[block] < last; }
};
// Whether some thread's range holds all pairs of a block that a sweep comes by; one that has none is in no range.
inline bool in_one_range(const Sweep& s, std::size_t block, std::size_t threads) {
  if (s.last[block] == none) return false;
  return ChunkRange(s.chunks, ((s.last[block] + std::size_t(1)) * threads - 1) / s.chunks, threads).holds(s, block);
}

// Of a step whose contacts nobody looks at: a thread's slots in few places, which stay near; else there is none.
SlotRing ring_of(const World& world, std::size_t thread, std::size_t threads);

// As in BodyStep: bit k of the kind k.
constexpr std::uint64_t kinds_that(bool (*are)(shapes::Kind)) {
  std::uint64_t kinds = 0;
  for (std::size_t k = 0; k < shapes::kind_count; ++k)
    kinds |= static_cast<std::uint64_t>(are(static_cast<shapes::Kind>(k)) ? 1 : 0) << k;
  return kinds;
}

// The bodies' part of a step.
class BodyPass {
 public:
  BodyPass(World& world, const BodyStep& step);
  // `ring` as ring_of(), of the thread that has answered all pairs of the block.
  void block(std::size_t number, BodyTally& tally, const SlotRing& ring = {}) const {
    const std::size_t first = number * bodies_at_once;
    SumLists lists = lists_;
    lists.ring = ring;
    kernel_(arrays_, lists, step_, first, std::min(count_, first + bodies_at_once), tally);
  }
  // What a block's bodies read beside their motions and slots, ahead of its turn.
  [[gnu::always_inline]] void fetch(std::size_t number) const {
    const std::size_t first = number * bodies_at_once, n = std::min(bodies_at_once, count_ - first);
    const auto lines = [n](const auto* array) {
      const char* from = reinterpret_cast<const char*>(array);
      for (std::size_t at = 0; at < n * sizeof *array; at += 64) __builtin_prefetch(from + at, 1);
    };
    lines(arrays_.angular_momentum + first);
    if (step_.still == 0) {
      lines(arrays_.orientation + first);
      lines(arrays_.rotation + first);
    }
    lines(arrays_.inertia + first);
    const std::uint32_t* entry = lists_.active + lists_.start[first];
    const std::uint32_t* last = lists_.active + lists_.start[first + n - 1] + lists_.count[first + n - 1];
    for (; entry < last; entry += 16) __builtin_prefetch(entry);
  }
  bool keeps() const { return step_.keep; }
  std::size_t blocks() const { return (count_ + bodies_at_once - 1) / bodies_at_once; }

 private:
  BodyArrays arrays_;
  SumLists lists_{};
  BodyStep step_;
  BodyKernel kernel_;
  std::size_t count_;
};

// All bodies, contacts left alone.
BodyTally move_bodies(World& world, int threads, const BodyStep& step);
inline void add(BodyTally& sum, const BodyTally& t) {
  sum.farthest = std::max(sum.farthest, t.farthest);
  sum.bad = std::min(sum.bad, t.bad);
}

}  // namespace dem
