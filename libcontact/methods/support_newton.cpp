#include "libcontact/methods/support_newton.h"

#include <algorithm>
#include <cmath>
#include <new>

#include "libcontact/dispatch.h"
#include "libcontact/kernels/pair_chunks.h"
#include "libcontact/methods/ellipsoid_climb.h"
#include "libcontact/scale.h"

namespace contact {

namespace {

using Answer = EllipsoidAnswer<double>;

// What places an answer back: the pair was seen from one of its bodies, in units of a power of two.
struct View {
  double down, up;
  bool swapped;
  double sign() const { return swapped ? -1 : 1; }
};

double greatest(const Vec3d& v) { return std::max(v.x, std::max(v.y, v.z)); }
double greatest_abs(const Vec3d& v) { return greatest({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

// False for a pair that is refused. What is not a number fails one of the comparisons.
[[gnu::always_inline]] inline bool view_of(const Vec3d& axes_a, const Vec3d& axes_b, const Vec3d& offset, View& view) {
  const double size = greatest_abs(offset) + (greatest(axes_a) + greatest(axes_b)), limit = smallest_ratio * size;
  const double least =
      std::min(std::min(std::min(axes_a.x, axes_a.y), std::min(axes_a.z, axes_b.x)), std::min(axes_b.y, axes_b.z));
  const double sum =
      (offset.x + offset.y + offset.z) + (axes_a.x + axes_a.y + axes_a.z) + (axes_b.x + axes_b.y + axes_b.z);
  if (!(extent_in_range(size) && least >= limit && std::abs(sum) <= 9 * size)) return false;
  const Scale scale = scale_of(size);
  view = {scale.down, scale.up, seen_from_b(offset)};
  return true;
}

// The cached axis as a direction in the order of the pair; zero: none.
Vec3d axis_of(const Mat3d& rotation_a, const Options& options, const Cache* cache, const View& view) {
  Vec3d axis;
  if (!(options.overlap_only || options.warm_start) || !cached_direction(cache, axis)) return {};
  return view.sign() * (rotation_a * axis);
}

[[gnu::always_inline]] inline Contact proof(double lower, const Vec3d& n, const View& view, double iterations = 0) {
  // The rounding is taken off already.
  return separation_proof(lower, 0, view.sign() * n, view.up, static_cast<int>(iterations));
}

// Support points of A lie along n from its centre, those of B against n; seen from B the roles are exchanged.
[[gnu::always_inline]] inline Contact contact_of(const Answer& r, const Vec3d& d, const View& view) {
  const double sign = view.sign();
  const Vec3d &first = view.swapped ? r.inner_b : r.inner_a, &second = view.swapped ? r.inner_a : r.inner_b;
  return smooth_contact(r.gap, r.lower, r.upper, sign * r.normal, sign * first, sign * (d - second), view.up,
                        static_cast<int>(r.iterations));
}

Contact climbed(const EllipsoidPair<double>& pair, const View& view, const Answer& found, const Options& options) {
  Certainty certainty{};
  Answer r = climb_ellipsoids(pair, found.normal, options.overlap_only, certainty);
  if (certainty == Certainty::none) return refused();
  r.iterations += found.iterations;
  if (r.outcome == Answer::proven) return proof(r.lower, r.normal, view, r.iterations);
  Contact c = contact_of(r, pair.d, view);
  c.certified = certainty != Certainty::best_known;
  if (certainty == Certainty::not_converged) c.status = Status::not_converged;
  return c;
}

void leave_axis(const Mat3d& rotation_a, const Options& options, const Contact& c, Cache& cache) {
  const bool kept = c.status == Status::separated || (options.warm_start && c.status != Status::refused);
  cache.axis = kept ? transposed_times(rotation_a, c.normal) : Vec3d{};
}

}  // namespace

Contact SupportNewton::query(const Placed<shapes::Ellipsoid>& a, const Placed<shapes::Ellipsoid>& b,
                             const Vec3d& offset, const Options& options, Cache* cache) {
  View view;
  if (!view_of(a.semi_axes, b.semi_axes, offset, view)) return refused();
  const Placed<shapes::Ellipsoid>&first = view.swapped ? b : a, &second = view.swapped ? a : b;
  const EllipsoidPair<double> pair{first.semi_axes * view.down, second.semi_axes * view.down, first.rotation,
                                   second.rotation, offset * (view.sign() * view.down)};
  const EllipsoidSearch<double> search(pair);
  const Vec3d axis = axis_of(a.rotation, options, cache, view);
  if (options.overlap_only) {
    const double f = search.separation(axis);
    if (f > search.margin()) return proof(f - search.allowance(), axis, view);
  }
  const Answer r = search.solve(options.warm_start ? axis : Vec3d{}, options.overlap_only, options.tolerance);
  Contact c = r.outcome == Answer::solved   ? contact_of(r, pair.d, view)
              : r.outcome == Answer::proven ? proof(r.lower, r.normal, view, r.iterations)
                                            : climbed(pair, view, r, options);
  if (cache != nullptr) leave_axis(a.rotation, options, c, *cache);
  return c;
}

namespace {

using kernels::EllipsoidChunk;

void put(EllipsoidChunk::Lane* lane, std::size_t i, const Vec3d& v) {
  lane[0][i] = v.x;
  lane[1][i] = v.y;
  lane[2][i] = v.z;
}
Vec3d get(const EllipsoidChunk::Lane* lane, std::size_t i) { return {lane[0][i], lane[1][i], lane[2][i]}; }

[[gnu::always_inline]] inline void put_pair(EllipsoidChunk& c, std::size_t i, const Body& a, const Body& b,
                                            const Vec3d& offset, const Vec3d& axis, const View& view) {
  const Body &first = view.swapped ? b : a, &second = view.swapped ? a : b;
  put(c.in, i, first.size * view.down);
  put(c.in + 3, i, second.size * view.down);
  for (int k = 0; k < 3; ++k) {
    put(c.in + 6 + 3 * k, i, first.rotation.row[k]);
    put(c.in + 15 + 3 * k, i, second.rotation.row[k]);
  }
  put(c.in + 24, i, offset * (view.sign() * view.down));
  put(c.in + 27, i, axis);
}
EllipsoidPair<double> pair_of(const EllipsoidChunk& c, std::size_t i) {
  return {get(c.in, i),
          get(c.in + 3, i),
          {{get(c.in + 6, i), get(c.in + 9, i), get(c.in + 12, i)}},
          {{get(c.in + 15, i), get(c.in + 18, i), get(c.in + 21, i)}},
          get(c.in + 24, i)};
}
void copy_lane(EllipsoidChunk& c, std::size_t from, std::size_t to) {
  for (EllipsoidChunk::Lane& lane : c.in) lane[to] = lane[from];
}
void pad(EllipsoidChunk& c, std::size_t count) {
  for (std::size_t i = count; i % EllipsoidChunk::widest != 0; ++i) copy_lane(c, count - 1, i);
}

struct Lanes {  // which pair a lane holds
  EllipsoidChunk chunk;
  std::size_t pair[EllipsoidChunk::size];
  View view[EllipsoidChunk::size];
};

// Ends the pairs that their cached axis keeps apart; the others move up. Returns how many those are.
std::size_t end_at_axis(Lanes& l, std::size_t count, Contact* out) {
  EllipsoidChunk& c = l.chunk;
  kernels::pair_kernels().ellipsoid_proofs(c, count);
  std::size_t left = 0;
  for (std::size_t i = 0; i < count; ++i) {
    if (c.outcome[i] == Answer::proven) {
      ::new (static_cast<void*>(out + l.pair[i])) Contact(proof(c.lower[i], get(c.in + 27, i), l.view[i]));
      continue;
    }
    if (left != i) {
      copy_lane(c, i, left);
      l.pair[left] = l.pair[i];
      l.view[left] = l.view[i];
    }
    ++left;
  }
  return left;
}

// Constructed in place: an answer is 240 bytes.
void answer(const Lanes& l, std::size_t i, const Options& options, Contact* out) {
  const EllipsoidChunk& c = l.chunk;
  const Answer r{c.outcome[i], c.iterations[i],  c.gap[i],          c.lower[i],
                 c.upper[i],   get(c.normal, i), get(c.inner_a, i), get(c.inner_b, i)};
  if (r.outcome == Answer::solved)
    ::new (static_cast<void*>(out)) Contact(contact_of(r, get(c.in + 24, i), l.view[i]));
  else if (r.outcome == Answer::proven)
    ::new (static_cast<void*>(out)) Contact(proof(r.lower, r.normal, l.view[i], r.iterations));
  else
    ::new (static_cast<void*>(out)) Contact(climbed(pair_of(c, i), l.view[i], r, options));
}

}  // namespace

void SupportNewton::query_chunk(KindPair<shapes::Ellipsoid, shapes::Ellipsoid>, std::size_t n, const Body* a,
                                const Body* b, const Vec3d* offset, const Options& options, Cache* cache,
                                Contact* out) {
  Lanes l;
  for (std::size_t first = 0; first < n; first += EllipsoidChunk::size) {
    const std::size_t last = std::min(n, first + EllipsoidChunk::size);
    std::size_t count = 0;
    bool axes = false;
    for (std::size_t i = first; i < last; ++i) {
      View& view = l.view[count];
      if (!view_of(a[i].size, b[i].size, offset[i], view)) {
        out[i] = refused();
        continue;
      }
      const Vec3d axis = axis_of(a[i].rotation, options, cache == nullptr ? nullptr : cache + i, view);
      axes = axes || dot(axis, axis) > 0;
      put_pair(l.chunk, count, a[i], b[i], offset[i], axis, view);
      l.pair[count++] = i;
    }
    if (count == 0) continue;
    pad(l.chunk, count);
    if (options.overlap_only && axes) {
      count = end_at_axis(l, count, out);
      if (count == 0) continue;
      pad(l.chunk, count);
    }
    if (!options.warm_start)
      for (int k = 27; k < 30; ++k) std::fill(std::begin(l.chunk.in[k].v), std::end(l.chunk.in[k].v), 0);
    kernels::pair_kernels().ellipsoid_search(l.chunk, count, options.overlap_only, options.tolerance);
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t k = l.pair[i];
      answer(l, i, options, out + k);
      if (cache != nullptr) leave_axis(a[k].rotation, options, out[k], cache[k]);
    }
  }
}

}  // namespace contact
