// Ellipsoid pairs, lanes across pairs, compiled once per instruction set.
#include "libcontact/kernels/ellipsoid_search.h"
#include "libcontact/kernels/gather.h"
#include "libcontact/kernels/pair_lanes.h"

namespace contact::kernels {
inline namespace KERNEL_SET {
namespace {

using shapes::Pack;
using V = shapes::Vec3<Pack>;
using Lane = EllipsoidChunk::Lane;

inline V load3(const Lane* l, std::size_t i) { return {load(l[0], i), load(l[1], i), load(l[2], i)}; }
inline void store3(Lane* l, std::size_t i, const V& v) {
  store(l[0], i, v.x);
  store(l[1], i, v.y);
  store(l[2], i, v.z);
}
inline EllipsoidPair<Pack> load_pair(const EllipsoidChunk& c, std::size_t i) {
  return {load3(c.in, i),
          load3(c.in + 3, i),
          {{load3(c.in + 6, i), load3(c.in + 9, i), load3(c.in + 12, i)}},
          {{load3(c.in + 15, i), load3(c.in + 18, i), load3(c.in + 21, i)}},
          load3(c.in + 24, i)};
}

}  // namespace

__attribute__((flatten)) void ellipsoid_proofs(EllipsoidChunk& c, std::size_t count) {
  using Answer = EllipsoidAnswer<Pack>;
  for (std::size_t i = 0; i < count; i += Pack::size()) {
    const EllipsoidSearch<Pack> search(load_pair(c, i));
    const Pack f = search.separation(load3(c.in + 27, i));
    store(c.lower, i, f - search.allowance());
    store(c.outcome, i, select(f > search.margin(), Pack(Answer::proven), Pack(Answer::straggler)));
  }
}

__attribute__((flatten)) void ellipsoid_search(EllipsoidChunk& c, std::size_t count, bool stop_at_proof,
                                               double tolerance) {
  for (std::size_t i = 0; i < count; i += Pack::size()) {
    const EllipsoidSearch<Pack> search(load_pair(c, i));
    const EllipsoidAnswer<Pack> r = search.solve(load3(c.in + 27, i), stop_at_proof, tolerance);
    store(c.outcome, i, r.outcome);
    store(c.iterations, i, r.iterations);
    store(c.gap, i, r.gap);
    store(c.lower, i, r.lower);
    store(c.upper, i, r.upper);
    store3(c.normal, i, r.normal);
    store3(c.inner_a, i, r.inner_a);
    store3(c.inner_b, i, r.inner_b);
  }
}

}  // namespace KERNEL_SET
}  // namespace contact::kernels
