// Pairs of ellipses in lanes, with the bits of Planar::query: what the lanes do not solve goes there.
#include <algorithm>
#include <cmath>
#include <new>
#include <utility>

#include "libcontact/dispatch.h"
#include "libcontact/kernels/pair_chunks.h"
#include "libcontact/methods/planar.h"
#include "libcontact/methods/planar_apart.h"
#include "libcontact/methods/planar_ellipse.h"
#include "libcontact/scale.h"

namespace contact {

namespace {

using kernels::EllipseChunk;

struct Lanes {
  EllipseChunk chunk;
  std::size_t pair[EllipseChunk::size];  // that a lane holds
  double up[EllipseChunk::size];
};

void put(EllipseChunk::Lane* lane, std::size_t i, const Body& b, double down) {
  lane[0][i] = b.size.x * down;
  lane[1][i] = b.size.y * down;
  lane[2][i] = b.rotation.row[0].x;
  lane[3][i] = b.rotation.row[1].x;
}

// False for a pair that is refused, or that is apart by a rule that lanes do not have.
bool put_pair(Lanes& l, std::size_t i, const Body& a, const Body& b, const Vec3d& offset) {
  const double radii = std::max(a.size.x, a.size.y) + std::max(b.size.x, b.size.y), extent = max_abs(offset) + radii;
  const double least = std::min(std::min(a.size.x, a.size.y), std::min(b.size.x, b.size.y));
  if (!(extent_in_range(extent) && extent_in_range(2 * extent) && least >= smallest_ratio * extent && offset.z == 0))
    return false;
  const Scale unit = scale_of(extent);
  l.up[i] = unit.up;
  EllipseChunk& c = l.chunk;
  put(c.a, i, a, unit.down);
  put(c.b, i, b, unit.down);
  c.d[0][i] = offset.x * unit.down;
  c.d[1][i] = offset.y * unit.down;
  return true;
}

// The cached axis as still_apart takes it, in the frame of the caller's A; zero: none.
Vec3d axis_of(const Cache& cache) {
  Vec3d n = cache.axis;
  if (n.z != 0 || (n.x == 0 && n.y == 0)) return {};
  if (!(std::abs(dot(n, n) - 1) <= 16 * epsilon) && !cached_direction(&cache, n)) return {};
  return n;
}

void copy_lane(Lanes& l, std::size_t from, std::size_t to) {
  EllipseChunk& c = l.chunk;
  for (int k = 0; k < 4; ++k) {
    c.a[k][to] = c.a[k][from];
    c.b[k][to] = c.b[k][from];
  }
  for (int k = 0; k < 2; ++k) {
    c.d[k][to] = c.d[k][from];
    c.start[k][to] = c.start[k][from];
  }
  l.pair[to] = l.pair[from];
  l.up[to] = l.up[from];
}
void pad(Lanes& l, std::size_t count) {
  for (std::size_t i = count; i % EllipseChunk::widest != 0; ++i) copy_lane(l, count - 1, i);
}

// Ends the pairs that their cached axis keeps apart; the others move up. Returns how many those are.
std::size_t end_at_axis(Lanes& l, std::size_t count, Contact* out) {
  EllipseChunk& c = l.chunk;
  kernels::pair_kernels().ellipse_proofs(c, count);
  std::size_t left = 0;
  for (std::size_t i = 0; i < count; ++i) {
    if (c.outcome[i] == 0) {
      if (left != i) copy_lane(l, i, left);
      ++left;
      continue;
    }
    // The rounding is taken off already.
    ::new (static_cast<void*>(out + l.pair[i]))
        Contact(separation_proof(c.lower[i], 0, {c.normal[0][i], c.normal[1][i], 0}, l.up[i]));
  }
  return left;
}

// As seen from the other body.
void exchange_lane(EllipseChunk& c, std::size_t i) {
  for (int k = 0; k < 4; ++k) std::swap(c.a[k][i], c.b[k][i]);
  for (EllipseChunk::Lane& d : c.d) d[i] = -d[i];
}

Contact answer(const Lanes& l, std::size_t i) {
  const EllipseChunk& c = l.chunk;
  const auto at = [i](const EllipseChunk::Lane* v) { return Flat<double>{v[0][i], v[1][i]}; };
  return ellipse_contact(
      {c.outcome[i], c.iterations[i], c.gap[i], c.lower[i], c.upper[i], at(c.normal), at(c.inner_a), at(c.inner_b)},
      {c.d[0][i], c.d[1][i], 0}, l.up[i]);
}

}  // namespace

void Planar::query_chunk(KindPair<shapes::Ellipse, shapes::Ellipse>, std::size_t n, const Body* a, const Body* b,
                         const Vec3d* offset, const Options& options, Cache* cache, Contact* out) {
  const auto one = [&](std::size_t k) {
    ::new (static_cast<void*>(out + k)) Contact(query(placed<shapes::Ellipse>(a[k]), placed<shapes::Ellipse>(b[k]),
                                                      offset[k], options, cache == nullptr ? nullptr : cache + k));
  };
  Lanes l;
  EllipseChunk& c = l.chunk;
  for (std::size_t first = 0; first < n; first += EllipseChunk::size) {
    const std::size_t last = std::min(n, first + EllipseChunk::size);
    std::size_t count = 0;
    bool axes = false;
    for (std::size_t k = first; k < last; ++k) {
      if (!put_pair(l, count, a[k], b[k], offset[k])) {
        one(k);
        continue;
      }
      Vec3d axis{};
      if (options.overlap_only && cache != nullptr) axis = axis_of(cache[k]);
      if (axis.x != 0 || axis.y != 0) {
        axes = true;
        cache[k].axis = axis;
      }
      c.start[0][count] = axis.x;
      c.start[1][count] = axis.y;
      l.pair[count++] = k;
    }
    if (count > 0 && axes) {
      pad(l, count);
      count = end_at_axis(l, count, out);
    }
    if (count == 0) continue;
    for (std::size_t i = 0; i < count; ++i) {
      c.start[0][i] = c.start[1][i] = 0;
      if (seen_from_b(offset[l.pair[i]])) exchange_lane(c, i);
    }
    pad(l, count);
    kernels::pair_kernels().ellipse_search(c, count, options.tolerance);
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t k = l.pair[i];
      if (c.outcome[i] == 0) {
        one(k);
        continue;
      }
      ::new (static_cast<void*>(out + k)) Contact(answer(l, i));
      if (seen_from_b(offset[k])) exchange(out[k], offset[k]);
      if (cache != nullptr) keep_apart(placed<shapes::Ellipse>(a[k]), out[k], cache + k);
    }
  }
}

}  // namespace contact
