// Bodies of the plane that were apart, apart still: one evaluation of the support separation along the axis in the
// cache. A proof, checked anew; where it fails, nothing follows. Inner header.
#pragma once

#include <cmath>

#include "libcontact/methods/method.h"
#include "libcontact/methods/polygon_pair.h"
#include "libcontact/scale.h"

namespace contact {

// Where an axis is kept, so are the corners that polygons reach farthest along it with.
inline double reach_of(const Placed<shapes::Disc>& p) { return p.radius; }
inline double reach_of(const Placed<shapes::Ellipse>& p) { return std::max(p.a, p.b); }
inline double reach_of(const Placed<shapes::Polygon>& p) { return p.scale * p.shape->circumradius; }

// Greatest height along the unit vector n of the body's own frame, in units.
inline double support_height(const Placed<shapes::Disc>& p, const Vec3d&, double down, std::uint32_t&) {
  return down * p.radius;
}
inline double support_height(const Placed<shapes::Ellipse>& p, const Vec3d& n, double down, std::uint32_t&) {
  const double u = down * p.a * n.x, v = down * p.b * n.y;
  return std::sqrt(u * u + v * v);
}
inline double support_height(const Placed<shapes::Polygon>& p, const Vec3d& n, double down, std::uint32_t& corner) {
  const std::vector<Vec3d>& list = p.shape->vertices;
  const double scale = down * p.scale;
  if (p.shape->convex && list.size() > 16) {
    const Lowest found = lowest_from(list, -n, corner < list.size() ? corner : 0);
    corner = found.vertex;
    // Where corners are level a walk may end early, lower by rounding times the length of the way.
    if (scale * found.rise > 0x1p-30) return -scale * found.value;
  }
  double highest = dot_xy(n, list[0]);
  for (const Vec3d& v : list) highest = std::max(highest, dot_xy(n, v));
  return scale * highest;
}

inline Vec3d turned_back(double cosine, double sine, const Vec3d& v) {
  return {cosine * v.x + sine * v.y, cosine * v.y - sine * v.x, 0};
}
template <class Body>
Vec3d in_frame_of(const Body& p, const Vec3d& v) {
  if constexpr (requires { p.cosine; })
    return turned_back(p.cosine, p.sine, v);
  else
    return v;
}
template <class Body>
Vec3d from_frame_of(const Body& p, const Vec3d& v) {
  if constexpr (requires { p.cosine; })
    return turned_back(p.cosine, -p.sine, v);
  else
    return v;
}

template <class A, class B>
bool still_apart(const A& a, const B& b, const Vec3d& offset, const Options& options, Cache* cache, Contact& c) {
  if (!options.overlap_only || cache == nullptr || (cache->axis.x == 0 && cache->axis.y == 0)) return false;
  Vec3d n = cache->axis;
  if (n.z != 0) return false;
  if (!(std::abs(dot_xy(n, n) - 1) <= 16 * epsilon)) {
    if (!cached_direction(cache, n)) return false;
  }
  const double ra = reach_of(a), rb = reach_of(b);
  const double extent = std::abs(offset.x) + std::abs(offset.y) + std::abs(offset.z) + (ra + rb);
  if (!(ra > 0 && rb > 0 && extent_in_range(extent))) return false;
  const Scale unit = scale_of(extent);
  const Vec3d world = from_frame_of(a, n), back = -in_frame_of(b, world);
  const double size = extent * unit.down;
  const double value = unit.down * dot_xy(world, offset) - support_height(a, n, unit.down, cache->feature[0]) -
                       support_height(b, back, unit.down, cache->feature[1]);
  if (!(value > proof_margin(size))) return false;
  cache->axis = n;
  c = separation_proof(value, size, world, unit.up);
  return true;
}

// The axis of an answer that found the bodies apart; none otherwise.
template <class A>
void keep_apart(const A& a, const Contact& c, Cache* cache) {
  if (cache == nullptr) return;
  *cache = {};
  if (c.status == Status::separated) cache->axis = in_frame_of(a, c.normal);
}

// The side that answered an overlap, its kind in the two upper bits; `turned`: solved from the caller's B.
inline SideContact side_in(const Cache* cache, bool turned) {
  if (cache == nullptr || !(cache->axis == Vec3d{})) return {};
  const auto kind = static_cast<SideContact::Kind>(cache->feature[0] >> 30);
  if (kind != SideContact::side_of_a && kind != SideContact::side_of_b) return {};
  const auto other = kind == SideContact::side_of_a ? SideContact::side_of_b : SideContact::side_of_a;
  return {turned ? other : kind, cache->feature[0] & 0x3fffffffu, cache->feature[1]};
}
inline void keep_side(const SideContact& side, bool turned, Cache* cache) {
  if (cache == nullptr || side.kind == SideContact::none || side.side > 0x3fffffffu) return;
  const auto other = side.kind == SideContact::side_of_a ? SideContact::side_of_b : SideContact::side_of_a;
  cache->feature[0] = static_cast<std::uint32_t>(turned ? other : side.kind) << 30 | side.side;
  cache->feature[1] = side.corner;
}

}  // namespace contact
