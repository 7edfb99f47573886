// Answers compared bit by bit, and chunks of pairs with the same pairs one by one.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>
#include <vector>

#include "libcontact/dispatch.h"

namespace contact {

inline bool same_bits(double x, double y) { return std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y); }
inline bool same_bits(const Vec3d& x, const Vec3d& y) {
  return same_bits(x.x, y.x) && same_bits(x.y, y.y) && same_bits(x.z, y.z);
}
inline bool same(const Contact& x, const Contact& y) {
  return x.status == y.status && x.certified == y.certified && same_bits(x.gap, y.gap) &&
         same_bits(x.gap_lower, y.gap_lower) && same_bits(x.gap_upper, y.gap_upper) && same_bits(x.normal, y.normal) &&
         same_bits(x.point_a, y.point_a) && same_bits(x.point_b, y.point_b) &&
         same_bits(x.patch.centre, y.patch.centre) && x.iterations == y.iterations;
}

struct Pairs {
  std::vector<Body> a, b;
  std::vector<Vec3d> offset;
  std::size_t size() const { return a.size(); }
};

struct AnswersCounted {
  int solved = 0, proven = 0, uncertified = 0, none = 0;
};

// Expects of every pair, in chunks of all sizes, what it answers alone, cold and with what that left in the caches.
// prepare(i, alone, in_chunks) may change the caches of pair i beforehand.
template <class Prepare>
void expect_chunks_as_one_by_one(ChunkQuery query, const Pairs& p, const Options& o, Prepare prepare,
                                 AnswersCounted& n) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::vector<Cache> cache_one(p.size()), cache_all(p.size());
  for (int round = 0; round < 2; ++round) {  // the second with what the first left in the caches
    std::vector<Contact> one(p.size()), all(p.size());
    for (std::size_t i = 0; i < p.size(); ++i) {
      prepare(i, cache_one[i], cache_all[i]);
      query(1, &p.a[i], &p.b[i], &p.offset[i], o, &cache_one[i], &one[i]);
    }
    for (std::size_t first = 0, step = 1; first < p.size(); first += step, step = step % 70 + 1)  // chunks of all sizes
      query(std::min(step, p.size() - first), &p.a[first], &p.b[first], &p.offset[first], o, &cache_all[first],
            &all[first]);
    for (std::size_t i = 0; i < p.size(); ++i) {
      EXPECT_TRUE(same(one[i], all[i])) << i << " gap " << one[i].gap << " " << all[i].gap;
      EXPECT_TRUE(same_bits(cache_one[i].axis, cache_all[i].axis)) << i;
      n.none += one[i].status == Status::refused;
      n.uncertified += !one[i].certified && one[i].status != Status::refused;
      n.proven += one[i].gap_upper == infinity && one[i].status == Status::separated;
      n.solved += one[i].certified && one[i].gap_upper < infinity;
    }
  }
}

}  // namespace contact
