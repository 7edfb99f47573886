// What became of the candidates, by pair of kinds: which of them needed a query, and what refused the others. Counted
// in every run, timed when asked for (`dem run --profile`).
//   candidates = refused by displacement + by bounding spheres + by an axis + apart after a query + touching
// A candidate is counted once a step. Cost: nothing that can be measured; two readings of a clock per chunk when timed.
#pragma once

#include <array>
#include <cstdint>

#include "shapes/list.h"

namespace dem {

struct Tally {
  std::uint64_t candidates = 0;
  std::uint64_t by_displacement = 0;  // known to be apart still
  std::uint64_t by_spheres = 0;       // bounding spheres, or bounding sphere and half-space
  std::uint64_t by_axis = 0;          // a proof along one axis, as a rule the one that proved it last
  std::uint64_t touching = 0, not_converged = 0, uncertified = 0;
  std::uint64_t handed_over = 0;  // of the touching: another method than the first answered
  double seconds = 0;             // of a thread, laws included

  Tally& operator+=(const Tally& t) {
    candidates += t.candidates;
    by_displacement += t.by_displacement;
    by_spheres += t.by_spheres;
    by_axis += t.by_axis;
    touching += t.touching;
    not_converged += t.not_converged;
    uncertified += t.uncertified;
    handed_over += t.handed_over;
    seconds += t.seconds;
    return *this;
  }
};

struct Profile {
  bool timed = false;
  std::array<std::array<Tally, shapes::kind_count>, shapes::kind_count> pairs{};  // [a][b], a <= b
  Tally parts{};                                                                  // bodies of parts with anything
};

}  // namespace dem
