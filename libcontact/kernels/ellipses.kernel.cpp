// Pairs of ellipses, lanes across pairs, compiled once per instruction set.
#include "libcontact/kernels/ellipse_search.h"
#include "libcontact/kernels/gather.h"
#include "libcontact/kernels/in_line.h"
#include "libcontact/kernels/pair_lanes.h"

namespace contact::kernels {
inline namespace KERNEL_SET {
namespace {

using shapes::Pack;
using V = Flat<Pack>;
using Lane = EllipseChunk::Lane;

inline V load2(const Lane* l, std::size_t i) { return {load(l[0], i), load(l[1], i)}; }
inline FlatEllipse<Pack> load_body(const Lane* l, std::size_t i) {
  return {load(l[0], i), load(l[1], i), load(l[2], i), load(l[3], i)};
}
inline void store2(Lane* l, std::size_t i, const V& v) {
  store(l[0], i, v.x);
  store(l[1], i, v.y);
}
inline Pack magnitude(const Pack& x) { return select(x < Pack(0), -x, x); }
inline Pack height(const Pack& a, const Pack& b, const V& n) {  // n in the body's frame
  using std::sqrt;
  const Pack u = a * n.x, v = b * n.y;
  return sqrt(u * u + v * v);
}

}  // namespace

// Each operation in the order of still_apart (planar_apart.h).
KERNEL_IN_LINE void ellipse_proofs(EllipseChunk& c, std::size_t count) {
  for (std::size_t i = 0; i < count; i += Pack::size()) {
    const FlatEllipse<Pack> a = load_body(c.a, i), b = load_body(c.b, i);
    const V n = load2(c.start, i), d = load2(c.d, i);
    const V world{a.cosine * n.x - a.sine * n.y, a.cosine * n.y + a.sine * n.x};
    const V back{b.cosine * world.x + b.sine * world.y, b.cosine * world.y - b.sine * world.x};
    const Pack value = dot(world, d) - height(a.a, a.b, n) - height(b.a, b.b, back);
    const Pack size = magnitude(d.x) + magnitude(d.y) + (larger(a.a, a.b) + larger(b.a, b.b));
    const auto given = n.x != Pack(0) || n.y != Pack(0);
    store(c.outcome, i, select(given && value > Pack(0x1p-46) * size, Pack(1), Pack(0)));
    store(c.lower, i, value - Pack(0x1p-48) * size);
    store2(c.normal, i, world);
  }
}

KERNEL_IN_LINE void ellipse_search(EllipseChunk& c, std::size_t count, double tolerance) {
  for (std::size_t i = 0; i < count; i += Pack::size()) {
    const EllipseSearch<Pack> search(load_body(c.a, i), load_body(c.b, i), load2(c.d, i));
    const EllipseAnswer<Pack> r = search.solve(load2(c.start, i), tolerance);
    store(c.outcome, i, r.solved);
    store(c.iterations, i, r.iterations);
    store(c.gap, i, r.gap);
    store(c.lower, i, r.lower);
    store(c.upper, i, r.upper);
    store2(c.normal, i, r.normal);
    store2(c.inner_a, i, r.inner_a);
    store2(c.inner_b, i, r.inner_b);
  }
}

}  // namespace KERNEL_SET
}  // namespace contact::kernels
