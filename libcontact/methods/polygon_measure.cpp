#include "libcontact/methods/polygon_measure.h"

#include <algorithm>
#include <cmath>

#include "libcontact/methods/planar.h"
#include "libcontact/scale.h"

namespace contact {

namespace {

// Least distance from x to an edge's line, inside.
double depth_of(const shapes::Polygon& p, const Placement& place, const Vec3d& x) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < p.normals.size(); ++i)
    least = std::min(least, place.scale * p.offsets[i] - dot(place.direction(p.normals[i]), x - place.at));
  return least;
}

// The vertex that lies highest along n.
Vec3d highest(const shapes::Polygon& p, const Placement& place, const Vec3d& n) {
  Vec3d best{};
  double most = -std::numeric_limits<double>::infinity();
  for (const Vec3d& v : p.vertices) {
    const Vec3d x = place.point(v);
    if (const double h = dot(n, x); h > most) most = h, best = x;
  }
  return best;
}

Contact answer(const Placed<shapes::Polygon>& a, const Placed<shapes::Polygon>& b, const Vec3d& offset,
               PolygonMethod method) {
  double up = 1;
  const PlacedPolygons pair = placed_polygons(a, b, offset, up);
  if (!(pair.size > 0)) return refused();
  const PolygonMeasure m = method(pair);
  const bool usable = m.found && std::abs(dot(m.normal, m.normal) - 1) < 0x1p-40 && std::abs(m.overlap) <= 16 &&
                      dot(m.point, m.point) <= 256;
  Contact c;
  if (usable && pair.a.convex && pair.b.convex) {
    const Vec3d on_a = highest(pair.a, pair.place_a, m.normal), on_b = highest(pair.b, pair.place_b, -m.normal);
    const double f = dot(m.normal, on_b - on_a), allowance = planar_half_width * pair.size;
    const double upper = -(depth_of(pair.a, pair.place_a, m.inside) + depth_of(pair.b, pair.place_b, m.inside));
    if (!(std::abs(f) <= 8)) return refused();
    c = smooth_contact(f, f - allowance, std::max(f, upper) + allowance, m.normal, on_a, on_b, up);
  } else {
    c = Planar::query(a, b, offset, {}, nullptr);
    c.handed_over = !usable;
    if (!usable) return c;
  }
  c.method_overlap = m.overlap * up;
  c.method_normal = m.normal;
  c.method_point = m.point * up;
  return c;
}

}  // namespace

PlacedPolygons placed_polygons(const Placed<shapes::Polygon>& a, const Placed<shapes::Polygon>& b, const Vec3d& offset,
                               double& up) {
  const double extent = max_abs(offset) + (a.scale * a.shape->circumradius + b.scale * b.shape->circumradius);
  if (!(a.scale > 0 && b.scale > 0 && extent_in_range(extent) && all_at_least(offset, -extent)))
    return {*a.shape, *b.shape, {}, {}, 0};
  const Scale unit = scale_of(extent);
  up = unit.up;
  return {*a.shape, *b.shape, placement(a, unit.down, {}), placement(b, unit.down, unit.down * offset),
          2 * extent * unit.down};
}

Contact by_polygon_method(const Placed<shapes::Polygon>& a, const Placed<shapes::Polygon>& b, const Vec3d& offset,
                          PolygonMethod method) {
  if (seen_from_b(offset)) return exchanged(answer(b, a, -offset, method), offset);
  return answer(a, b, offset, method);
}

}  // namespace contact
