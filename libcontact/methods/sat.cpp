#include "libcontact/methods/sat.h"

#include <algorithm>
#include <cmath>

#include "libcontact/methods/face_patch.h"
#include "libcontact/methods/gjk.h"
#include "libcontact/methods/method.h"
#include "libcontact/methods/sat_search.h"
#include "libcontact/methods/segments.h"
#include "libcontact/scale.h"

namespace contact {
namespace {

// The answer is built in A's frame, in units; this takes it to the caller's axes and metres.
struct Frame {
  const Mat3d& rotation;
  double up;
  double size;  // L in units

  Contact finish(Contact c, double lower, double upper, const Vec3d& normal) const {
    c.certified = true;
    c.gap_lower = lower - polyhedron_rounding * size;
    c.gap_upper = upper + polyhedron_rounding * size;
    c.status = c.gap_lower > 0 ? Status::separated : (c.gap_upper < 0 ? Status::overlapping : Status::touching);
    c.normal = c.method_normal = rotation * normal;
    c.point_a = rotation * c.point_a;
    c.point_b = rotation * c.point_b;
    c.method_point = 0.5 * (c.point_a + c.point_b);
    c.method_overlap = -c.gap;
    rescale(c, up);
    return c;
  }
  // A direction whose support separation proves that the bodies are apart.
  Contact proof(double value, const Vec3d& normal, Cache* cache) const {
    if (cache) cache->axis = normal;
    Contact c;
    c.status = Status::separated;
    c.certified = true;
    c.gap = c.gap_lower = (value - polyhedron_rounding * size) * up;
    c.gap_upper = std::numeric_limits<double>::infinity();
    c.normal = c.method_normal = rotation * normal;
    c.method_overlap = -c.gap;
    return c;
  }
};

// Witness points of an edge–edge axis: the closest points of the two lines, a gap apart along the normal.
void edge_witness(const PolyhedronPair& pair, const EdgeAxis& axis, double gap, Contact& c) {
  const auto& ea = pair.self->edges[axis.edge_a];
  const auto& eb = pair.other->edges[axis.edge_b];
  const Vec3d p = pair.self_vertex(ea.vertex[0]), e = pair.self_vertex(ea.vertex[1]) - p;
  const Vec3d q = pair.other_vertex(eb.vertex[0]), f = pair.other_vertex(eb.vertex[1]) - q;
  const Vec3d n = cross(e, f);
  const double square = dot(n, n);
  const double s = square > 0 ? std::clamp(dot(cross(q - p, f), n) / square, 0.0, 1.0) : 0.5;
  c.point_a = p + s * e;
  c.point_b = c.point_a + gap * axis.normal;
}

// The query of (b, a, −offset): a cached axis is A's to the caller, B's there.
Contact from_the_other(const Placed<shapes::Polyhedron>& a, const Placed<shapes::Polyhedron>& b, const Vec3d& offset,
                       const Options& options, Cache* cache) {
  if (cache == nullptr) return Sat::query(b, a, -offset, options, nullptr);
  Cache other{-transposed_times(b.rotation, a.rotation * cache->axis)};
  const Contact c = Sat::query(b, a, -offset, options, &other);
  cache->axis = -transposed_times(a.rotation, b.rotation * other.axis);
  return c;
}

}  // namespace

Contact Sat::query(const Placed<shapes::Polyhedron>& a, const Placed<shapes::Polyhedron>& b, const Vec3d& offset,
                   const Options& options, Cache* cache) {
  if (seen_from_b(offset)) return exchanged(from_the_other(a, b, offset, options, cache), offset);
  const double radius_a = a.scale * a.shape->circumradius, radius_b = b.scale * b.shape->circumradius;
  const double extent = max_abs(offset) + (radius_a + radius_b);
  if (!(a.scale > 0 && b.scale > 0 && extent_in_range(extent) && all_at_least(offset, -extent))) return refused();
  const Scale unit = scale_of(extent);
  const Vec3d d_world = unit.down * offset;
  const double distance = norm(d_world);
  const PolyhedronPair pair{
      a.shape,
      b.shape,
      unit.down * a.scale,
      unit.down * b.scale,
      {{transposed_times(b.rotation, a.rotation.column(0)), transposed_times(b.rotation, a.rotation.column(1)),
        transposed_times(b.rotation, a.rotation.column(2))}},
      transposed_times(a.rotation, d_world)};
  const Frame frame{a.rotation, unit.up, distance + unit.down * (radius_a + radius_b)};
  const double enough = options.overlap_only ? proof_margin(frame.size) : std::numeric_limits<double>::infinity();
  if (options.overlap_only) {
    Vec3d axis;
    if (cached_direction(cache, axis)) {
      const double value = pair.separation(axis).value;
      if (value > enough) return frame.proof(value, axis, cache);
    }
    const double apart = distance - unit.down * (radius_a + radius_b);
    if (apart > enough) return frame.proof(apart, pair.offset * (1 / distance), cache);
  }

  const PolyhedronPair reversed = pair.swapped();
  FaceSearch faces_a(pair), faces_b(reversed);
  double best = -std::numeric_limits<double>::infinity();
  std::uint32_t face = 0;
  EdgeAxis axis{};
  enum { none, face_of_a, face_of_b, edges } kind = none;
  if (faces_a.search(best, enough, face)) kind = face_of_a;
  if (!(best > enough)) {
    double bar = best + face_preference * frame.size;
    if (faces_b.search(bar, enough, face)) kind = face_of_b, best = bar;
  }
  if (!(best > 0)) {
    const double bar = best + face_preference * frame.size;
    if (search_edges(faces_a, faces_b, bar, enough, axis)) kind = edges, best = axis.value;
  }
  if (kind == none) return refused();  // nothing compares: a rotation is not finite
  const Vec3d normal = kind == face_of_a   ? a.shape->faces[face].normal
                       : kind == face_of_b ? -(pair.other_to_self * b.shape->faces[face].normal)
                                           : axis.normal;
  if (best > enough) return frame.proof(best, normal, cache);

  Contact c;
  const Separation support = pair.separation(normal);
  const double lower = support.value;
  if (!(std::abs(lower) <= 8)) return refused();
  if (lower > -polyhedron_rounding * frame.size) {
    const PolyhedronDistance found = polyhedron_distance(pair, normal, frame.size);
    if (cache) cache->axis = found.normal;
    c.gap = 0.5 * (found.lower + found.upper);
    c.point_a = found.on_self;
    c.point_b = found.on_other;
    c.patch.centre = a.rotation * (0.5 * (c.point_a + c.point_b));
    c.iterations = found.iterations;
    return frame.finish(c, found.lower, found.upper, found.normal);
  }
  if (cache) cache->axis = {};
  c.gap = lower;
  Patch patch;
  bool spread = false;
  if (kind == edges) {
    edge_witness(pair, axis, lower, c);
  } else if (kind == face_of_a) {
    spread = face_patch(pair, face, support.on_other, lower, c.point_a, c.point_b, patch);
  } else {
    spread = face_patch(reversed, face, support.on_self, lower, c.point_b, c.point_a, patch);
    const auto to_a = [&](const Vec3d& x) { return pair.other_to_self * x + pair.offset; };
    c.point_a = to_a(c.point_a);
    c.point_b = to_a(c.point_b);
    patch = rotated(patch, pair.other_to_self);
    patch.centre += pair.offset;
  }
  if (!spread) patch = {0.5 * (c.point_a + c.point_b), {}};
  c.patch = rotated(patch, a.rotation);
  return frame.finish(c, lower, std::max(lower, best), normal);
}

}  // namespace contact
