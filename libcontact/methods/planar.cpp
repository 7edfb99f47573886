#include "libcontact/methods/planar.h"

#include <algorithm>
#include <cmath>

#include "libcontact/methods/analytic.h"
#include "libcontact/methods/method.h"
#include "libcontact/methods/planar_apart.h"
#include "libcontact/methods/planar_ellipse.h"
#include "libcontact/methods/planar_outline.h"
#include "libcontact/methods/planar_space.h"
#include "libcontact/methods/polygon_pair.h"
#include "libcontact/methods/polygon_regions.h"
#include "libcontact/scale.h"

namespace contact {

namespace {

Body body_of(const Placed<shapes::Disc>& p) {
  Body b;
  b.kind = shapes::Kind::disc;
  b.size.x = p.radius;
  return b;
}
Mat3d rotation_of(double c, double s) { return {{{c, -s, 0}, {s, c, 0}, {0, 0, 1}}}; }
Body body_of(const Placed<shapes::Ellipse>& p) {
  Body b;
  b.kind = shapes::Kind::ellipse;
  b.size = {p.a, p.b, 0};
  b.rotation = rotation_of(p.cosine, p.sine);
  return b;
}
Body body_of(const Placed<shapes::Polygon>& p) {
  Body b;
  b.kind = shapes::Kind::polygon;
  b.geometry = p.shape;
  b.size.x = p.scale;
  b.rotation = rotation_of(p.cosine, p.sine);
  return b;
}

// With a polygon that is not convex: the deepest of the regions of the overlap. False when there are none.
template <class A>
bool deepest_region(const Placed<A>& a, const Placed<shapes::Polygon>& b, const Vec3d& offset, const Options& options,
                    Contact& c) {
  Contact found[max_regions];
  const std::size_t count = polygon_regions(body_of(a), body_of(b), offset, options, found);
  for (std::size_t i = 0; i < count; ++i)
    if (i == 0 || found[i].gap < c.gap) c = found[i];
  return count > 0;
}

// Of the answers of several parts, that of the nearest.
void keep_nearest(Contact& best, const Contact& c) {
  if (best.status == Status::refused || c.gap < best.gap) best = c;
}

Contact disc_polygon(const Placed<shapes::Disc>& a, const Placed<shapes::Polygon>& b, const Vec3d& offset,
                     const Options& options) {
  const double extent = max_abs(offset) + (a.radius + b.scale * b.shape->circumradius);
  if (!(a.radius > 0 && b.scale > 0 && extent_in_range(extent) && all_at_least(offset, -extent))) return refused();
  Contact c = refused();
  if (!b.shape->convex && deepest_region(a, b, offset, options, c)) return c;
  const Scale unit = scale_of(extent);
  const Placement place = placement(b, unit.down, unit.down * offset);
  for (const auto& part : b.shape->parts)
    keep_nearest(c, disc_loop(a.radius * unit.down, Loop(part, place), 2 * extent * unit.down));
  rescale(c, unit.up);
  return c;
}

Contact ellipse_polygon(const Placed<shapes::Ellipse>& a, const Placed<shapes::Polygon>& b, const Vec3d& offset,
                        const Options& options) {
  const double extent = max_abs(offset) + (std::max(a.a, a.b) + b.scale * b.shape->circumradius);
  const double limit = smallest_ratio * extent;
  if (!(a.a >= limit && a.b >= limit && b.scale > 0 && extent_in_range(extent) && all_at_least(offset, -extent)))
    return refused();
  Contact c = refused();
  if (!b.shape->convex && deepest_region(a, b, offset, options, c)) return c;
  const Scale unit = scale_of(extent);
  const Placement place = placement(b, unit.down, unit.down * offset);
  const Placed<shapes::Ellipse> ellipse{a.a * unit.down, a.b * unit.down, a.cosine, a.sine};
  for (const auto& part : b.shape->parts)
    keep_nearest(c, ellipse_loop(ellipse, Loop(part, place), 2 * extent * unit.down));
  rescale(c, unit.up);
  return c;
}

void polygon_pair(const Placed<shapes::Polygon>& a, const Placed<shapes::Polygon>& b, const Vec3d& offset,
                  const Options& options, SideContact& known, Contact& c) {
  const double radius_a = a.scale * a.shape->circumradius, radius_b = b.scale * b.shape->circumradius;
  const double extent = max_abs(offset) + (radius_a + radius_b);
  if (!(a.scale > 0 && b.scale > 0 && extent_in_range(extent) && all_at_least(offset, -extent))) return;
  const Scale unit = scale_of(extent);
  const Placement place_a = placement(a, unit.down, {}), place_b = placement(b, unit.down, unit.down * offset);
  const PairSize size{2 * extent * unit.down, std::min(radius_a, radius_b) * unit.down, unit.up};
  if (a.shape->convex && b.shape->convex)
    return loop_pair(Loop(*a.shape, place_a), Loop(*b.shape, place_b), size, options, known, c);
  known = {};
  if (deepest_region(a, b, offset, options, c)) return;
  for (const auto& part : a.shape->parts)
    for (const auto& other : b.shape->parts) {
      SideContact none;
      Contact one = refused();
      loop_pair(Loop(part, place_a), Loop(other, place_b), size, options, none, one);
      keep_nearest(c, one);
    }
}

Contact ellipses(const Placed<shapes::Ellipse>& a, const Placed<shapes::Ellipse>& b, const Vec3d& offset,
                 const Options& options, Cache* cache) {
  const bool exchanges = seen_from_b(offset);
  Contact c = exchanges ? ellipse_pair(b, a, -offset, options) : ellipse_pair(a, b, offset, options);
  if (exchanges) exchange(c, offset);
  keep_apart(a, c, cache);
  return c;
}

}  // namespace

Contact Planar::query(const Placed<shapes::Disc>& a, const Placed<shapes::Disc>& b, const Vec3d& offset, const Options&,
                      Cache*) {
  const double reach = a.radius + b.radius;
  Vec3d n;
  const double distance = length_and_direction(offset, n), extent = distance + reach;
  if (!(a.radius > 0 && b.radius > 0 && extent_in_range(extent))) return refused();
  if (n.z != 0) n = {1, 0, 0};  // one centre
  const double gap = distance - reach, allowance = rounding(extent);
  return smooth_contact(gap, gap - allowance, gap + allowance, n, a.radius * n, offset - b.radius * n);
}

Contact Planar::query(const Placed<shapes::Disc>& a, const Placed<shapes::Ellipse>& b, const Vec3d& offset,
                      const Options& options, Cache*) {
  return Analytic::query(Placed<shapes::Sphere>{a.radius}, in_space(b), offset, options, nullptr);
}

Contact Planar::query(const Placed<shapes::Disc>& a, const Placed<shapes::Line>& b, const Vec3d& offset,
                      const Options& options, Cache*) {
  return Analytic::query(Placed<shapes::Sphere>{a.radius}, Placed<shapes::Plane>{b.normal}, offset, options, nullptr);
}

Contact Planar::query(const Placed<shapes::Ellipse>& a, const Placed<shapes::Line>& b, const Vec3d& offset,
                      const Options& options, Cache*) {
  return Analytic::query(in_space(a), Placed<shapes::Plane>{b.normal}, offset, options, nullptr);
}

Contact Planar::query(const Placed<shapes::Ellipse>& a, const Placed<shapes::Ellipse>& b, const Vec3d& offset,
                      const Options& options, Cache* cache) {
  if (options.overlap_only && cache != nullptr)
    if (Contact c; still_apart(a, b, offset, options, cache, c)) return c;
  return ellipses(a, b, offset, options, cache);
}

Contact Planar::query(const Placed<shapes::Disc>& a, const Placed<shapes::Polygon>& b, const Vec3d& offset,
                      const Options& options, Cache* cache) {
  Contact c;
  if (still_apart(a, b, offset, options, cache, c)) return c;
  c = disc_polygon(a, b, offset, options);
  keep_apart(a, c, cache);
  return c;
}

Contact Planar::query(const Placed<shapes::Ellipse>& a, const Placed<shapes::Polygon>& b, const Vec3d& offset,
                      const Options& options, Cache* cache) {
  Contact c;
  if (still_apart(a, b, offset, options, cache, c)) return c;
  c = ellipse_polygon(a, b, offset, options);
  keep_apart(a, c, cache);
  return c;
}

Contact Planar::query(const Placed<shapes::Polygon>& a, const Placed<shapes::Polygon>& b, const Vec3d& offset,
                      const Options& options, Cache* cache) {
  Contact c;
  if (still_apart(a, b, offset, options, cache, c)) return c;
  c.gap_lower = -std::numeric_limits<double>::infinity();
  c.gap_upper = std::numeric_limits<double>::infinity();
  const bool turned = seen_from_b(offset);
  SideContact known = side_in(cache, turned);
  if (turned) {
    polygon_pair(b, a, -offset, options, known, c);
    exchange(c, offset);
  } else {
    polygon_pair(a, b, offset, options, known, c);
  }
  keep_apart(a, c, cache);
  keep_side(known, turned, cache);
  return c;
}

Contact Planar::query(const Placed<shapes::Polygon>& a, const Placed<shapes::Line>& b, const Vec3d& offset,
                      const Options& options, Cache*) {
  const double extent = max_abs(offset) + a.scale * a.shape->circumradius;
  if (!(a.scale > 0 && extent_in_range(extent) && all_at_least(offset, -extent))) return refused();
  const Scale unit = scale_of(extent);
  const Placement place = placement(a, unit.down, {});
  const double level = dot(b.normal, unit.down * offset), size = 2 * extent * unit.down;
  double gap = std::numeric_limits<double>::infinity();
  Vec3d tip{};
  for (const Vec3d& v : a.shape->vertices) {
    const Vec3d x = place.point(v);
    if (const double height = dot(b.normal, x) - level; height < gap) gap = height, tip = x;
  }
  if (!(std::abs(gap) <= 8)) return refused();
  Contact c = smooth_contact(gap, gap - planar_half_width * size, gap + planar_half_width * size, -b.normal, tip,
                             tip - gap * b.normal);
  if (options.patch && gap < 0) {
    AreaMoments moments;
    for (const auto& part : a.shape->parts) {
      Corners whole, below;
      for (const Vec3d& v : part.vertices) whole.push_back({place.point(v), 0});
      cut(whole, b.normal, level, 0, below);
      moments.add(below);
    }
    moments.patch(b.normal, c.patch);
  }
  rescale(c, unit.up);
  return c;
}

}  // namespace contact
