#include "libcontact/overlap_volume.h"

#include <cmath>
#include <numbers>
#include <utility>

#include "libcontact/methods/clip.h"
#include "libcontact/methods/clip_volume.h"
#include "libcontact/methods/method.h"
#include "libcontact/methods/planar_outline.h"
#include "libcontact/scale.h"
#include "shapes/math/arc_tangent.h"

namespace contact {

namespace {

using shapes::Kind;

constexpr double pi = std::numbers::pi;
// A rim shorter than this of the overlap's bodies, squared where it is an area, has no direction but that of rounding.
constexpr double least_section = 0x1p-40;
// α − sin α cos α, the area of a unit disc beyond the line at cos α = 1 − h.
double unit_segment(double h) {
  const double s = std::sqrt(h * (2 - h)), c = 1 - h;
  if (h > 1) return pi - unit_segment(2 - h);
  const double alpha = shapes::arc_tangent(s / (1 + c)) * 2, y = 2 * alpha;
  if (y > 0.5) return alpha - s * c;
  double term = y * y * y / 6, sum = 0;  // ½(y − sin y) without cancellation
  for (int n = 5; n < 20; n += 2) {
    sum += term;
    term *= -y * y / (n * (n - 1));
  }
  return 0.5 * sum;
}

// Heights of the two caps or segments; false where one round body holds the other, or they are apart.
bool heights(double overlap, double ra, double rb, double& ha, double& hb) {
  if (!(overlap > 0)) return false;
  if (!(rb <= std::numeric_limits<double>::max())) {
    ha = overlap;
    hb = 0;
    return overlap < 2 * ra;
  }
  const double d = ra + rb - overlap;
  if (!(d > 0)) return false;
  ha = overlap * (2 * rb - overlap) / (2 * d);
  hb = overlap * (2 * ra - overlap) / (2 * d);
  return ha > 0 && hb > 0;
}

bool finish(const VolumeSection& v, OverlapVolume& out) {
  out.volume = v.volume;
  out.section = v.section;
  out.screw = 0;
  return v.volume > 0 && v.section > 0;
}

bool round_bodies(const Body& a, const Body& b, const Vec3d& offset, OverlapVolume& out) {
  const double distance = length_and_direction(offset, out.normal), ra = a.size.x, rb = b.size.x;
  const double overlap = ra + rb - distance;
  double ha, hb;
  if (!heights(overlap, ra, rb, ha, hb)) return false;
  out.point = out.normal * (ra - ha);
  return finish(a.kind == Kind::disc ? disc_overlap(overlap, ra, rb) : sphere_overlap(overlap, ra, rb), out);
}

// Balls and discs, stretched: in the space where the body is the unit one, the wall cuts off a height t.
bool stretched(const Body& a, const Vec3d& wall, double height, OverlapVolume& out) {
  const bool flat = shapes::dimension_of(a.kind) == 2;
  const bool round = a.kind == Kind::sphere || a.kind == Kind::disc;
  const Vec3d axes = round ? Vec3d{a.size.x, a.size.x, a.size.x} : flat ? Vec3d{a.size.x, a.size.y, 0} : a.size;
  const Vec3d n = round ? -wall : transposed_times(a.rotation, -wall);
  const Vec3d u = scaled(axes, n);
  const double reach = norm(u), t = (reach - height) / reach;
  if (!(t > 0 && t < 2)) return false;
  const double product = flat ? axes.x * axes.y : axes.x * axes.y * axes.z;
  const VolumeSection unit = flat ? disc_overlap(t, 1, HUGE_VAL) : sphere_overlap(t, 1, HUGE_VAL);
  const Vec3d middle = scaled(axes, u) * ((1 - t) / reach);
  out.normal = -wall;
  out.point = round ? middle : a.rotation * middle;
  return finish({unit.volume * product, unit.section * (product / reach)}, out);
}

// The line of action and the couple along it, from S and the moment about the centroid.
void set_action(const Vec3d& surface, const Vec3d& moment, const Vec3d& centroid, OverlapVolume& out) {
  out.section = length_and_direction(surface, out.normal);
  out.point = centroid + cross(out.normal, moment) * (1 / out.section);
  out.screw = dot(out.normal, moment) / out.section;
}

double extent(const Body& b) { return circumradius(b); }

bool polyhedra(const Body& a, const Body& b, const Vec3d& offset, OverlapVolume& out) {
  if (seen_from_b(offset)) {  // the same bits in both orders
    if (!polyhedra(b, a, -offset, out)) return false;
    out.normal = -out.normal;
    out.point += offset;
    return true;
  }
  const ClippedVolume c = clipped_volume(placed<shapes::Polyhedron>(a), placed<shapes::Polyhedron>(b), offset);
  const double size = std::min(extent(a), extent(b));
  if (!(c.volume > 0)) return false;
  out.volume = c.volume;
  set_action(c.surface, c.moment, c.centroid, out);
  return out.section > least_section * size * size;
}

bool polygons(const Body& a, const Body& b, const Vec3d& offset, OverlapVolume& out) {
  if (seen_from_b(offset)) {
    if (!polygons(b, a, -offset, out)) return false;
    out.normal = -out.normal;
    out.point += offset;
    return true;
  }
  const ClippedArea c = clipped_area(placed<shapes::Polygon>(a), placed<shapes::Polygon>(b), offset);
  if (!(c.area > 0)) return false;
  out.volume = c.area;
  set_action(c.surface, {0, 0, c.moment}, c.centroid, out);
  out.screw = 0;
  return out.section > least_section * std::min(extent(a), extent(b));
}

// What lies of a polyhedron behind a wall through the point at `height` below its origin; lengths in units of `up`. The
// cones over the submerged faces have their apex in the wall: its own face adds nothing.
bool polyhedron_wall(const Body& a, const Vec3d& wall, double height, OverlapVolume& out) {
  const auto& p = *static_cast<const shapes::Polyhedron*>(a.geometry);
  const double size = extent(a);
  if (!extent_in_range(size)) return false;
  const Scale unit = scale_of(size);
  const double scale = a.size.x * unit.down;
  const Vec3d n = transposed_times(a.rotation, wall);
  const double level = -height * unit.down;  // n·x of the wall
  bool begun = false;
  double volume = 0, section = 0;
  Vec3d apex{}, first{}, moment{};
  for (const auto& face : p.faces) {
    Corners region, below;
    for (std::uint32_t k = 0; k < face.count; ++k)
      region.push_back({scale * p.vertices[p.face_vertices[face.first + k]], 0});
    cut(region, n, level, 0, below);
    if (below.size() < 3) continue;
    if (!begun) apex = below[0].x - n * (dot(n, below[0].x) - level), begun = true;
    const Vec3d corner = below[0].x - apex;
    const double rise = dot(face.normal, corner), towards = -dot(face.normal, n);
    Vec3d v = below[1].x - below[0].x;
    for (std::size_t i = 2; i < below.size(); ++i) {
      const Vec3d w = below[i].x - below[0].x, middle = corner + (1.0 / 3) * (v + w);
      const double area = 0.5 * dot(face.normal, cross(v, w)), cone = area * rise / 3;
      volume += cone;
      first += cone * (0.75 * middle);
      section += area * towards;
      moment += area * cross(middle, face.normal);
      v = w;
    }
  }
  if (!(volume > 0 && section > least_section)) return false;
  // S = −n · section to rounding, and the moment has no part along it: the rim lies in the wall.
  const Vec3d centroid = first * (1 / volume), along = -n;
  const Vec3d about = moment - cross(centroid, along * section);
  const Vec3d point = apex + centroid + cross(along, about) * (1 / section);
  out.volume = volume * unit.up * unit.up * unit.up;
  out.section = section * unit.up * unit.up;
  out.normal = -wall;
  out.point = a.rotation * point * unit.up;
  out.screw = 0;
  return true;
}

bool polygon_line(const Body& a, const Vec3d& wall, double height, OverlapVolume& out) {
  const auto& p = *static_cast<const shapes::Polygon*>(a.geometry);
  const double size = extent(a);
  if (!extent_in_range(size)) return false;
  const Scale unit = scale_of(size);
  const double scale = a.size.x * unit.down;
  const Vec3d n = transposed_times(a.rotation, wall);
  const double level = -height * unit.down;
  Corners region, below;
  for (const Vec3d& v : p.vertices) region.push_back({scale * v, 0});
  cut(region, n, level, 1, below);
  if (below.size() < 3) return false;
  double area = 0, section = 0;
  Vec3d first{}, start = below[0].x, on_wall{};
  for (std::size_t i = 0; i < below.size(); ++i) {
    const Vec3d& x = below[i].x;
    const Vec3d along = below[i + 1 == below.size() ? 0 : i + 1].x - x, v = x - start, w = v + along;
    const double part = 0.5 * (v.x * w.y - v.y * w.x);
    area += part;
    first += part * (1.0 / 3) * (v + w);
    if (below[i].side != 1) continue;
    section += norm(along);
    on_wall = x + 0.5 * along;  // the chord: its middle is on the line of action
  }
  if (!(area > 0 && section > least_section)) return false;
  const Vec3d centroid = start + first * (1 / area);
  const Vec3d point = on_wall + n * dot(n, centroid - on_wall);
  out.volume = area * unit.up * unit.up;
  out.section = section * unit.up;
  out.normal = -wall;
  out.point = a.rotation * point * unit.up;
  out.screw = 0;
  return true;
}

}  // namespace

VolumeSection sphere_overlap(double overlap, double ra, double rb) {
  double ha, hb;
  if (!heights(overlap, ra, rb, ha, hb)) return {};
  const double of_b = hb > 0 ? hb * hb * (3 * rb - hb) : 0;
  return {pi / 3 * (ha * ha * (3 * ra - ha) + of_b), pi * ha * (2 * ra - ha)};
}

VolumeSection disc_overlap(double overlap, double ra, double rb) {
  double ha, hb;
  if (!heights(overlap, ra, rb, ha, hb)) return {};
  const double of_b = hb > 0 ? rb * rb * unit_segment(hb / rb) : 0;
  return {ra * ra * unit_segment(ha / ra) + of_b, 2 * std::sqrt(ha * (2 * ra - ha))};
}

bool has_overlap_volume(Kind a, Kind b) {
  const bool solid = a == Kind::sphere || a == Kind::polyhedron, flat = a == Kind::disc || a == Kind::polygon;
  if (a == b) return solid || flat;
  if (b == Kind::plane) return solid || a == Kind::ellipsoid;
  return b == Kind::line && (flat || a == Kind::ellipse);
}

bool overlap_volume(const Body& a, const Body& b, const Vec3d& offset, OverlapVolume& out) {
  if (!has_overlap_volume(a.kind, b.kind)) return false;
  if (b.kind == Kind::plane || b.kind == Kind::line) {
    const Vec3d wall = b.rotation.column(b.kind == Kind::plane ? 2 : 1);
    const double height = -dot(wall, offset);  // of a's origin over the wall
    if (a.kind == Kind::polyhedron) return polyhedron_wall(a, wall, height, out);
    if (a.kind == Kind::polygon) return polygon_line(a, wall, height, out);
    return stretched(a, wall, height, out);
  }
  if (a.kind == Kind::polyhedron) return polyhedra(a, b, offset, out);
  if (a.kind == Kind::polygon) return polygons(a, b, offset, out);
  return round_bodies(a, b, offset, out);
}

}  // namespace contact
