#include <algorithm>

#include "bench/pairs/entries.h"

namespace pairs {

void ask(const Set& set, contact::ChunkQuery query, const contact::Options& options, bool next, std::size_t count,
         std::size_t chunk, contact::Cache* cache, Kept* kept) {
  static thread_local Body a[largest_chunk], b[largest_chunk];
  static thread_local Vec3d offset[largest_chunk];
  static thread_local contact::Contact out[largest_chunk];
  for (std::size_t first = 0; first < count; first += chunk) {
    const std::size_t n = std::min(chunk, count - first);
    for (std::size_t i = 0; i < n; ++i) {
      const Pair& p = set.list[first + i];
      a[i] = set.bodies[p.a];
      b[i] = set.bodies[next ? p.next_b : p.b];
      offset[i] = next ? p.next_offset : p.offset;
    }
    query(n, a, b, offset, options, cache == nullptr ? nullptr : cache + first, out);
    for (std::size_t i = 0; i < n; ++i) kept[first + i] = {out[i].normal, out[i].patch.centre, out[i].gap};
  }
}

}  // namespace pairs
