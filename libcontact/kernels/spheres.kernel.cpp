// Sphere pairs, lanes across pairs, compiled once per instruction set.
#include <limits>

#include "libcontact/kernels/gather.h"
#include "libcontact/kernels/rows.h"
#include "shapes/math/pack.h"

namespace contact::kernels {
inline namespace KERNEL_SET {
namespace {

using shapes::Pack;
using V = shapes::Vec3<Pack>;
using std::experimental::element_aligned;
using std::experimental::vector_aligned;

inline constexpr std::size_t block = chunk_size;
inline constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

struct Gathered {
  Lane3 offset;
  Lane radius_a, radius_b;
};

[[gnu::always_inline]] inline void put(Lane& lane, std::size_t i, const Row& row) {
  *reinterpret_cast<Row*>(&lane.v[i]) = row;
}

// A block whole, before any arithmetic: packs wider than a row then find its stores retired.
[[gnu::always_inline]] inline void gather(const SphereRow* spheres, const Index* a, const Index* b, Gathered& g) {
  for (std::size_t i = 0; i < block; i += 4) {
    const Rows p = Rows::load(spheres, sizeof(SphereRow), a + i, 0).turned();
    const Rows q = Rows::load(spheres, sizeof(SphereRow), b + i, 0).turned();
    put(g.offset.x, i, q.a - p.a);
    put(g.offset.y, i, q.b - p.b);
    put(g.offset.z, i, q.c - p.c);
    put(g.radius_a, i, p.d);
    put(g.radius_b, i, q.d);
  }
}

inline void store3(double* const out[3], std::size_t i, const V& v) {
  v.x.copy_to(out[0] + i, element_aligned);
  v.y.copy_to(out[1] + i, element_aligned);
  v.z.copy_to(out[2] + i, element_aligned);
}

// Each operation in the order of Analytic::query.
[[gnu::always_inline]] inline bool solve(const Gathered& g, const SphereAnswers& out, std::size_t first) {
  using std::sqrt;
  typename Pack::mask_type all(true);
  for (std::size_t i = 0; i < block; i += Pack::size()) {
    const auto load = [i](const Lane& l) { return Pack(&l.v[i], vector_aligned); };
    const V d{load(g.offset.x), load(g.offset.y), load(g.offset.z)};
    const Pack ra = load(g.radius_a), rb = load(g.radius_b);
    const Pack square = dot(d, d), distance = sqrt(square), reach = ra + rb;
    const V n = d * (Pack(1) / distance);
    // The square as in length_and_direction of scale.h; with these radii the extent is in range as well.
    const auto plain = square > Pack(0x1p-900) && square < Pack(0x1p900) && ra > Pack(0) && rb > Pack(0) &&
                       ra < Pack(0x1p900) && rb < Pack(0x1p900);
    all = all && plain;
    const Pack gap = shapes::select(plain, distance - reach, Pack(no_number));
    gap.copy_to(out.gap + first + i, element_aligned);
    store3(out.normal, first + i, n);
    store3(out.point, first + i, Pack(0.5) * (ra * n + (d - rb * n)));
  }
  return all_of(all);
}

}  // namespace

bool sphere_pairs(const SphereRow* spheres, const Index* a, const Index* b, std::size_t count,
                  const SphereAnswers& out) {
  Gathered g;
  bool plain = true;
  std::size_t first = 0;
  for (; first + block <= count; first += block) {
    gather(spheres, a + first, b + first, g);
    plain = solve(g, out, first) && plain;
  }
  if (first == count) return plain;
  // What is left, filled up with its last pair, into a block of its own.
  const std::size_t left = count - first;
  Index last_a[block], last_b[block];
  for (std::size_t i = 0; i < block; ++i) {
    const std::size_t from = first + (i < left ? i : left - 1);
    last_a[i] = a[from];
    last_b[i] = b[from];
  }
  Lane gap;
  Lane3 normal, point;
  gather(spheres, last_a, last_b, g);
  const SphereAnswers own{gap.v, {normal.x.v, normal.y.v, normal.z.v}, {point.x.v, point.y.v, point.z.v}};
  plain = solve(g, own, 0) && plain;
  for (std::size_t i = 0; i < left; ++i) {  // no library function: its code would be that of any instruction set
    out.gap[first + i] = own.gap[i];
    for (int k = 0; k < 3; ++k) {
      out.normal[k][first + i] = own.normal[k][i];
      out.point[k][first + i] = own.point[k][i];
    }
  }
  return plain;
}

}  // namespace KERNEL_SET
}  // namespace contact::kernels
