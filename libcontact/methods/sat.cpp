#include "libcontact/methods/sat.h"

#include <algorithm>
#include <cmath>

#include "libcontact/dispatch.h"
#include "libcontact/methods/expansion.h"
#include "libcontact/methods/face_patch.h"
#include "libcontact/methods/facet_depth.h"
#include "libcontact/methods/gjk.h"
#include "libcontact/methods/method.h"
#include "libcontact/methods/sat_search.h"
#include "libcontact/scale.h"

namespace contact {
namespace {

using Solid = Placed<shapes::Polyhedron>;
constexpr double infinity = std::numeric_limits<double>::infinity();

// What a cache holds, seen from the body that the pair is solved from. A facet is kept with its kind in the two upper
// bits; a separating axis with the two vertices that it is extreme at, from which a walk begins.
class Memory {
 public:
  // `turned`: solved from the caller's B; `turn` takes directions of that body to the caller's A.
  Memory(Cache* cache, bool turned, const Solid& first, const Solid& second)
      : cache_(cache), turned_(turned), first_(first), second_(second) {}

  DifferenceFacet facet() const {
    if (cache_ == nullptr) return {};
    return seen({static_cast<DifferenceFacet::Kind>(cache_->feature[0] >> 30), cache_->feature[0] & 0x3fffffffu,
                 cache_->feature[1]});
  }
  void keep(const DifferenceFacet& facet) const {
    if (cache_ == nullptr) return;
    cache_->axis = {};
    store(facet);
  }
  void keep(const Vec3d& axis, const Separation& at) const {
    if (cache_ == nullptr) return;
    cache_->axis = turned_ ? -transposed_times(second_.rotation, first_.rotation * axis) : axis;
    store({DifferenceFacet::none, at.on_self, at.on_other});
  }

 private:
  DifferenceFacet seen(const DifferenceFacet& f) const {
    if (!turned_) return f;
    const auto kind = f.kind == DifferenceFacet::face_of_a   ? DifferenceFacet::face_of_b
                      : f.kind == DifferenceFacet::face_of_b ? DifferenceFacet::face_of_a
                                                             : f.kind;
    return {kind, f.b, f.a};
  }
  void store(const DifferenceFacet& f) const {
    const DifferenceFacet kept = seen(f);
    const bool fits = kept.a < 0x40000000u;
    cache_->feature[0] = fits ? static_cast<std::uint32_t>(kept.kind) << 30 | kept.a : 0;
    cache_->feature[1] = fits ? kept.b : 0;
  }

  Cache* cache_;
  bool turned_;
  const Solid &first_, &second_;
};

// The bodies as they are placed, along world axes, in units.
struct Frame {
  const Mat3d &rotation_a, &rotation_b;
  Vec3d offset;
  double up;    // units -> metres
  double size;  // L

  // An answer in metres, written where it is wanted: to clear or to copy one would cost as much as a proof.
  void form(double gap, double lower, double upper, const Vec3d& normal, const Vec3d& on_a, const Vec3d& on_b,
            const Patch& patch, int iterations, Contact& out) const {
    const double low = lower - polyhedron_rounding * size, high = upper + polyhedron_rounding * size;
    out.status = low > 0 ? Status::separated : (high < 0 ? Status::overlapping : Status::touching);
    out.certified = true;
    out.handed_over = false;
    out.gap = gap * up;
    out.gap_lower = low * up;
    out.gap_upper = high * up;
    out.normal = out.method_normal = normal;
    out.point_a = up * on_a;
    out.point_b = up * on_b;
    out.patch.centre = up * patch.centre;
    for (int i = 0; i < 6; ++i) out.patch.spread[i] = patch.spread[i] * up * up;
    out.patch.weight = patch.weight * up * up * up;
    out.method_overlap = -gap * up;
    out.method_point = up * (0.5 * (on_a + on_b));
    out.measure = {};
    out.iterations = iterations;
  }
};

// `lower`, in metres, bounds the gap from below along a direction in world axes: nothing more is asked.
void stop_at(double lower, const Vec3d& normal, Contact& out) {
  out.status = Status::separated;
  out.certified = true;
  out.handed_over = false;
  out.gap = out.gap_lower = lower;
  out.gap_upper = infinity;
  out.normal = out.method_normal = normal;
  out.point_a = out.point_b = out.patch.centre = out.method_point = {};
  for (double& moment : out.patch.spread) moment = 0;
  out.patch.weight = 0;
  out.method_overlap = -lower;
  out.measure = {};
  out.iterations = 0;
}

// A lower bound of the separation along n of A's frame, `back` in B's the other way, in metres. On large bodies by
// walks from the vertices in `hint`, which are moved; both at once on small ones.
double bound_along(const Solid& a, const Solid& b, double between, const Vec3d& n, const Vec3d& back, double extent,
                   std::uint32_t* hint) {
  constexpr std::size_t small = 16;
  if (a.shape->vx.size() > small || b.shape->vx.size() > small) {
    const auto reach = [&](const Solid& s, const Vec3d& direction, std::uint32_t& from) {
      const Extreme found = climb(*s.shape, direction, from < s.shape->vertices.size() ? from : 0);
      from = found.index;
      return s.scale * found.value;
    };
    std::uint32_t on_a = hint[0], on_b = hint[1];
    const double value = between - reach(a, n, on_a) - reach(b, back, on_b);
    // What a walk may have missed is settled by looking at every vertex where it could matter.
    if (value > 0x1p-30 * extent) {
      hint[0] = on_a;
      hint[1] = on_b;
      return value;
    }
  }
  Extreme lowest[2];
  kernels::search_kernels().lowest_two(points_of(*a.shape), -n, points_of(*b.shape), -back, lowest);
  return between + a.scale * lowest[0].value + b.scale * lowest[1].value;
}

// Does the axis in the cache still separate the bodies? Then `lower` bounds their gap, `world` is the axis.
bool still_apart(const Solid& a, const Solid& b, const Vec3d& offset, Cache& cache, double& lower, Vec3d& world) {
  Vec3d n = cache.axis;
  const double square = dot(n, n);
  if (!(std::abs(square - 1) <= 16 * epsilon)) {
    if (!cached_direction(&cache, n)) return false;
  }
  const double extent = std::abs(offset.x) + std::abs(offset.y) + std::abs(offset.z) +
                        (a.scale * a.shape->circumradius + b.scale * b.shape->circumradius);
  if (!(a.scale > 0 && b.scale > 0 && extent_in_range(extent))) return false;
  world = a.rotation * n;
  const double value =
      bound_along(a, b, dot(world, offset), n, -transposed_times(b.rotation, world), extent, cache.feature);
  if (!(value > proof_margin(extent))) return false;
  cache.axis = n;
  lower = value - polyhedron_rounding * extent;
  return true;
}

// The nearest facet of the difference, with its proof: by a ray from inside, at once for a shallow overlap; else by an
// expansion. False: not found; `apart` is then a direction along which the bodies seem to be apart, if one was met.
bool find_nearest(const DifferencePair& pair, DifferenceFacet& facet, FacetAxis& axis, Vec3d& apart) {
  const Exit exit = leave(pair, pair.core);
  if (exit.kind == Exit::apart) apart = exit.normal;
  if (exit.kind == Exit::facet) return expand(pair, pair.core, exit.corner, facet, axis);
  facet = exit.face;
  axis = exit.axis;
  return exit.kind == Exit::nearest;
}

Vec3d world_normal(const DifferencePair& pair, const DifferenceFacet& facet, const FacetAxis& axis,
                   const Frame& frame) {
  return facet.kind == DifferenceFacet::face_of_b ? -(frame.rotation_b * pair.other->faces[facet.b].normal)
                                                  : frame.rotation_a * axis.normal;
}

// With the depth of the overlap, whose patch then serves for the contact: a face's witness points are its vertex and
// the foot of that within it. False: there is none, or the foot is not there.
bool measured(const DifferencePair& pair, const DifferenceFacet& facet, const FacetAxis& axis, const Frame& frame,
              Contact& out) {
  if (!(axis.value < 0) || (facet.kind != DifferenceFacet::edges && !(axis.reach > 0))) return false;
  const double smaller =
      std::min(pair.self_scale * pair.self->circumradius, pair.other_scale * pair.other->circumradius);
  OverlapDepth depth;
  Patch patch;
  if (!facet_depth(pair, facet, axis, {frame.rotation_a, frame.rotation_b, frame.offset, smaller}, depth, patch))
    return false;
  const Vec3d normal = world_normal(pair, facet, axis, frame);
  Vec3d on_a, on_b;
  if (facet.kind == DifferenceFacet::face_of_a) {
    on_b = frame.rotation_a * pair.other_vertex(facet.b);
    on_a = on_b - axis.value * normal;
  } else {
    on_a = frame.rotation_a * (facet.kind == DifferenceFacet::edges ? axis.on_a : pair.self_vertex(facet.a));
    on_b = on_a + axis.value * normal;
  }
  if (facet.kind == DifferenceFacet::edges) patch = {0.5 * (on_a + on_b), {}};
  frame.form(axis.value, axis.value, axis.value, normal, on_a, on_b, patch, 0, out);
  out.measure = depth;
  rescale(out.measure, frame.up);
  return true;
}

void overlap(const DifferencePair& pair, const DifferenceFacet& facet, const FacetAxis& axis, const Frame& frame,
             bool measure, Contact& out) {
  if (measure && measured(pair, facet, axis, frame, out)) return;
  const Vec3d normal = world_normal(pair, facet, axis, frame);
  Vec3d on_a, on_b;
  Patch patch;
  if (facet.kind == DifferenceFacet::face_of_a) {
    face_patch(pair, frame.rotation_a, {}, {facet.a, facet.b, axis.value, axis.reach}, on_a, on_b, patch);
  } else if (facet.kind == DifferenceFacet::face_of_b) {
    face_patch(pair.swapped(), frame.rotation_b, frame.offset, {facet.b, facet.a, axis.value, axis.reach}, on_b, on_a,
               patch);
  } else {
    on_a = frame.rotation_a * axis.on_a;
    on_b = frame.rotation_a * (axis.on_a + axis.value * axis.normal);
    patch.centre = 0.5 * (on_a + on_b);
  }
  frame.form(axis.value, axis.value, axis.value, normal, on_a, on_b, patch, 0, out);
}

// The distance, from a direction along which the bodies do not overlap.
void distance(const PolyhedronPair& pair, const Vec3d& direction, const Separation& at, const Frame& frame,
              const Memory& memory, Contact& out) {
  const PolyhedronDistance found = polyhedron_distance(pair, direction, at, frame.size);
  memory.keep(found.normal, found.at);
  const Vec3d on_a = frame.rotation_a * found.on_self, on_b = frame.rotation_a * found.on_other;
  Patch patch;
  patch.centre = 0.5 * (on_a + on_b);
  frame.form(0.5 * (found.lower + found.upper), found.lower, found.upper, frame.rotation_a * found.normal, on_a, on_b,
             patch, found.iterations, out);
}

void refuse(Contact& out) { out = refused(); }

void solve(const Solid& a, const Solid& b, const Vec3d& offset, const Options& options, const Memory& memory,
           Contact& out) {
  const double radius_a = a.scale * a.shape->circumradius, radius_b = b.scale * b.shape->circumradius;
  const double extent = max_abs(offset) + (radius_a + radius_b);
  if (!(a.scale > 0 && b.scale > 0 && extent_in_range(extent) && all_at_least(offset, -extent))) return refuse(out);
  const Scale unit = scale_of(extent);
  const Vec3d d_world = unit.down * offset;
  const double length = norm(d_world), reach = unit.down * (radius_a + radius_b);
  const Frame frame{a.rotation, b.rotation, d_world, unit.up, length + reach};
  const double enough = options.overlap_only ? proof_margin(frame.size) : infinity;
  const auto apart_along = [&](double value, const Vec3d& world) {
    stop_at((value - polyhedron_rounding * frame.size) * unit.up, world, out);
  };
  const DifferencePair pair(
      {a.shape,
       b.shape,
       unit.down * a.scale,
       unit.down * b.scale,
       {{transposed_times(b.rotation, a.rotation.column(0)), transposed_times(b.rotation, a.rotation.column(1)),
         transposed_times(b.rotation, a.rotation.column(2))}},
       transposed_times(a.rotation, d_world)},
      frame.size);
  if (length - reach > enough) {
    const Vec3d n = pair.offset * (1 / length);
    memory.keep(n, pair.separation(n));
    return apart_along(length - reach, d_world * (1 / length));
  }
  const auto apart_at = [&](const Vec3d& n, const Separation& at) {
    memory.keep(n, at);
    apart_along(at.value, a.rotation * n);
  };
  DifferenceFacet facet = memory.facet();
  FacetAxis axis{};
  if (prove_nearest(pair, facet, axis) != Nearest::proven) {
    if (axis.value > enough) {  // what overlapped before may separate now
      const Separation at = pair.separation(axis.normal);
      if (at.value > enough) return apart_at(axis.normal, at);
    }
    Vec3d apart{};
    if (!find_nearest(pair, facet, axis, apart)) {
      if (const double square = dot(apart, apart); square > 0) {
        const Vec3d n = apart * (1 / std::sqrt(square));
        const Separation at = pair.separation(n);
        if (at.value > enough) return apart_at(n, at);
        if (at.value > 0) return distance(pair, n, at, frame, memory, out);
      }
      facet = search_all(pair, enough);
      if (facet.kind == DifferenceFacet::none) return refuse(out);  // nothing compares: a rotation is not finite
      axis = axis_of(pair, facet);
      if (!(std::abs(axis.value) <= 8)) return refuse(out);
      const Separation at = pair.separation(axis.normal);
      if (axis.value > enough && at.value > enough) return apart_at(axis.normal, at);
      if (axis.value > -polyhedron_rounding * frame.size) return distance(pair, axis.normal, at, frame, memory, out);
    }
  }
  memory.keep(facet);
  overlap(pair, facet, axis, frame, options.measure, out);
}

void answer(const Solid& a, const Solid& b, const Vec3d& offset, const Options& options, Cache* cache, Contact& out) {
  if (options.overlap_only && cache != nullptr) {
    double lower = 0;
    Vec3d n{};
    if (still_apart(a, b, offset, *cache, lower, n)) return stop_at(lower, n, out);
  }
  if (!seen_from_b(offset)) return solve(a, b, offset, options, {cache, false, a, b}, out);
  solve(b, a, -offset, options, {cache, true, b, a}, out);
  exchange(out, offset);
}

}  // namespace

Contact Sat::query(const Placed<shapes::Polyhedron>& a, const Placed<shapes::Polyhedron>& b, const Vec3d& offset,
                   const Options& options, Cache* cache) {
  Contact out;
  answer(a, b, offset, options, cache, out);
  return out;
}

void Sat::query_chunk(KindPair<shapes::Polyhedron, shapes::Polyhedron>, std::size_t n, const Body* a, const Body* b,
                      const Vec3d* offset, const Options& options, Cache* cache, Contact* out) {
  for (std::size_t i = 0; i < n; ++i)
    answer(placed<shapes::Polyhedron>(a[i]), placed<shapes::Polyhedron>(b[i]), offset[i], options,
           cache != nullptr ? cache + i : nullptr, out[i]);
}

}  // namespace contact
