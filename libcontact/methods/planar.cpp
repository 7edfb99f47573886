#include "libcontact/methods/planar.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "libcontact/methods/analytic.h"
#include "libcontact/methods/method.h"
#include "libcontact/methods/planar_ellipse.h"
#include "libcontact/methods/point_ellipsoid.h"
#include "libcontact/scale.h"

namespace contact {

namespace {

constexpr double half_width = 32 * epsilon;  // of the bounds of a polygon pair, for a pair of unit size
const double infinity = std::numeric_limits<double>::infinity();

Vec3d turned(double c, double s, const Vec3d& v) { return {c * v.x - s * v.y, s * v.x + c * v.y, 0}; }
Mat3d rotation_of(double c, double s) { return {{{c, -s, 0}, {s, c, 0}, {0, 0, 1}}}; }

Placed<shapes::Ellipsoid> in_space(const Placed<shapes::Ellipse>& e) {
  return {{e.a, e.b, std::max(e.a, e.b)}, rotation_of(e.cosine, e.sine)};
}

// A polygon in units and world axes.
struct Outline {
  const shapes::Polygon* shape;
  double scale, cosine, sine;
  Vec3d at;

  std::size_t size() const { return shape->vertices.size(); }
  Vec3d vertex(std::size_t i) const { return at + scale * turned(cosine, sine, shape->vertices[i]); }
  Vec3d normal(std::size_t i) const { return turned(cosine, sine, shape->normals[i]); }
  double height(const Vec3d& n, std::size_t i) const { return scale * shape->offsets[i] + dot(n, at); }  // of edge i
  double lowest(const Vec3d& n, std::size_t& index) const {
    double least = infinity;
    for (std::size_t i = 0; i < size(); ++i)
      if (const double h = dot(n, vertex(i)); h < least) least = h, index = i;
    return least;
  }
};

Outline outline(const Placed<shapes::Polygon>& p, double down, const Vec3d& at) {
  return {p.shape, p.scale * down, p.cosine, p.sine, at};
}

Contact answer(double gap, double excess, double size, const Vec3d& n, const Vec3d& a, const Vec3d& b) {
  return smooth_contact(gap, gap - half_width * size, gap + half_width * size + excess, n, a, b);
}

// Keeps the part of a convex region with n·x <= height.
void cut(std::vector<Vec3d>& region, const Vec3d& n, double height, std::vector<Vec3d>& scratch) {
  scratch.clear();
  for (std::size_t i = 0; i < region.size(); ++i) {
    const Vec3d &p = region[i], &q = region[(i + 1) % region.size()];
    const double hp = dot(n, p) - height, hq = dot(n, q) - height;
    if (hp <= 0) scratch.push_back(p);
    if ((hp < 0 && hq > 0) || (hp > 0 && hq < 0)) scratch.push_back(p + (hp / (hp - hq)) * (q - p));
  }
  region.swap(scratch);
}

// Area moments of a convex region: below the line of the contact its area is ∫h, so these are the moments of the patch.
bool area_patch(const std::vector<Vec3d>& region, const Vec3d& n, Patch& patch) {
  if (region.size() < 3) return false;
  const Vec3d along{-n.y, n.x, 0}, &origin = region[0];
  double area = 0, second = 0;
  Vec3d first{};
  for (std::size_t i = 1; i + 1 < region.size(); ++i) {
    const Vec3d p = region[i] - origin, q = region[i + 1] - origin;
    const double w = 0.5 * std::abs(p.x * q.y - p.y * q.x), u = dot(along, p), v = dot(along, q);
    area += w;
    first += (w / 3) * (p + q);
    second += w * (u * u + u * v + v * v) / 6;
  }
  if (!(area > 0x1p-900)) return false;
  const Vec3d mean = first * (1 / area);
  const double u = dot(along, mean), m = std::max(0.0, second / area - u * u);
  patch.centre = origin + mean;
  patch.spread[0] = m * along.x * along.x;
  patch.spread[1] = m * along.y * along.y;
  patch.spread[3] = m * along.x * along.y;
  return true;
}

bool usable(const Placed<shapes::Polygon>& p) { return p.scale > 0 && p.shape->convex; }

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
                      const Options&, Cache*) {
  if (seen_from_b(offset)) return exchanged(ellipse_pair(b, a, -offset), offset);
  return ellipse_pair(a, b, offset);
}

Contact Planar::query(const Placed<shapes::Disc>& a, const Placed<shapes::Polygon>& b, const Vec3d& offset,
                      const Options&, Cache*) {
  const double extent = max_abs(offset) + (a.radius + b.scale * b.shape->circumradius);
  if (!(a.radius > 0 && usable(b) && extent_in_range(extent) && all_at_least(offset, -extent))) return refused();
  const Scale unit = scale_of(extent);
  const Outline p = outline(b, unit.down, unit.down * offset);
  const double radius = a.radius * unit.down, size = 2 * extent * unit.down;
  double best = -infinity;
  Vec3d n{};
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Vec3d out = p.normal(i);
    if (const double f = -p.height(out, i); f > best) best = f, n = -out;
  }
  Vec3d on_b = best * n;
  if (best > 0) {
    double least = infinity;
    Vec3d nearest{};
    for (std::size_t i = 0; i < p.size(); ++i) {
      const Vec3d v = p.vertex(i);
      if (const double square = dot(v, v); square < least) least = square, nearest = v;
    }
    std::size_t index = 0;
    if (Vec3d towards; length_and_direction(nearest, towards) > 0 && towards.z == 0) {
      if (const double f = p.lowest(towards, index); f > best) best = f, n = towards, on_b = p.vertex(index);
    }
  }
  if (!(std::abs(best) <= 8)) return refused();
  Contact c = answer(best - radius, 0, size, n, radius * n, on_b);
  rescale(c, unit.up);
  return c;
}

Contact Planar::query(const Placed<shapes::Ellipse>& a, const Placed<shapes::Polygon>& b, const Vec3d& offset,
                      const Options&, Cache*) {
  const double extent = max_abs(offset) + (std::max(a.a, a.b) + b.scale * b.shape->circumradius);
  const double limit = smallest_ratio * extent;
  if (!(a.a >= limit && a.b >= limit && usable(b) && extent_in_range(extent) && all_at_least(offset, -extent)))
    return refused();
  const Scale unit = scale_of(extent);
  const Outline p = outline(b, unit.down, unit.down * offset);
  const Placed<shapes::Ellipsoid> e = in_space({a.a * unit.down, a.b * unit.down, a.cosine, a.sine});
  const double size = 2 * extent * unit.down;
  const auto support = [&](const Vec3d& n) { return scaled(e.semi_axes, transposed_times(e.rotation, n)); };
  double best = -infinity, excess = 0;
  Vec3d n{}, on_a{}, on_b{};
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Vec3d out = p.normal(i), u = support(-out);
    const double reach = norm(u), f = -p.height(out, i) - reach;
    if (!(f > best)) continue;
    best = f;
    n = -out;
    on_a = e.rotation * scaled(e.semi_axes, u * (1 / reach));
    on_b = on_a + f * n;
  }
  if (!(std::abs(best) <= 16)) return refused();
  // The edge normals hold the maximum where they bound a vertex cone; inside the cone it is the normal of a foot.
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Vec3d v = p.vertex(i), y = transposed_times(e.rotation, v);
    EllipsoidFoot feet[2] = {nearest_on_ellipsoid(e.semi_axes, y), {}};
    const int count = second_foot(e.semi_axes, y, feet[1]) ? 2 : 1;
    for (int k = 0; k < count; ++k) {
      const Vec3d normal = e.rotation * feet[k].normal;
      std::size_t index = i;
      const double f = p.lowest(normal, index) - norm(support(normal));
      if (!(f > best)) continue;
      best = f;
      n = normal;
      on_a = e.rotation * feet[k].foot;
      on_b = v;
      excess = feet[k].residual * norm(y);
    }
  }
  Contact c = answer(best, excess, size, n, on_a, on_b);
  rescale(c, unit.up);
  return c;
}

namespace {

Contact polygon_pair(const Placed<shapes::Polygon>& first, const Placed<shapes::Polygon>& second, const Vec3d& offset,
                     const Options& options) {
  const double extent =
      max_abs(offset) + (first.scale * first.shape->circumradius + second.scale * second.shape->circumradius);
  if (!(usable(first) && usable(second) && extent_in_range(extent) && all_at_least(offset, -extent))) return refused();
  const Scale unit = scale_of(extent);
  const Outline a = outline(first, unit.down, {}), b = outline(second, unit.down, unit.down * offset);
  const double size = 2 * extent * unit.down;
  double best = -infinity;
  Vec3d n{}, on_a{}, on_b{};
  std::size_t index = 0;
  // A vertex of one body over an edge of the other, within the edge's ends where edges are parallel.
  const auto take = [&](const Outline& edges, const Outline& other, bool of_a) {
    for (std::size_t i = 0; i < edges.size(); ++i) {
      const Vec3d out = edges.normal(i);
      const double f = other.lowest(out, index) - edges.height(out, i);
      if (!(f > best)) continue;
      best = f;
      const Vec3d v = other.vertex(index), p = edges.vertex(i), q = edges.vertex((i + 1) % edges.size());
      const Vec3d along{-out.y, out.x, 0};
      const double u = dot(along, v), inside = std::clamp(u, dot(along, p), std::max(dot(along, p), dot(along, q)));
      const Vec3d at = v + (inside - u) * along, under = at - f * out;
      n = of_a ? out : -out;
      on_a = of_a ? under : at;
      on_b = of_a ? at : under;
    }
  };
  take(a, b, true);
  take(b, a, false);
  if (best > -half_width * size) {
    double least = infinity;
    std::size_t ia = 0, ib = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
      for (std::size_t j = 0; j < b.size(); ++j) {
        const Vec3d between = b.vertex(j) - a.vertex(i);
        if (const double square = dot(between, between); square < least) least = square, ia = i, ib = j;
      }
    const Vec3d va = a.vertex(ia), vb = b.vertex(ib);
    if (Vec3d towards; length_and_direction(vb - va, towards) > 0 && towards.z == 0) {
      const double f = b.lowest(towards, index) + a.lowest(-towards, index);
      if (f > best) best = f, n = towards, on_a = va, on_b = vb;
    }
  }
  if (!(std::abs(best) <= 8)) return refused();
  Contact c = answer(best, 0, size, n, on_a, on_b);
  if (options.patch && best < 0) {
    std::vector<Vec3d> region, scratch;
    for (std::size_t i = 0; i < a.size(); ++i) region.push_back(a.vertex(i));
    for (std::size_t j = 0; j < b.size() && region.size() >= 3; ++j) {
      const Vec3d out = b.normal(j);
      cut(region, out, b.height(out, j), scratch);
    }
    area_patch(region, n, c.patch);
  }
  rescale(c, unit.up);
  return c;
}

}  // namespace

Contact Planar::query(const Placed<shapes::Polygon>& a, const Placed<shapes::Polygon>& b, const Vec3d& offset,
                      const Options& options, Cache*) {
  if (seen_from_b(offset)) return exchanged(polygon_pair(b, a, -offset, options), offset);
  return polygon_pair(a, b, offset, options);
}

Contact Planar::query(const Placed<shapes::Polygon>& a, const Placed<shapes::Line>& b, const Vec3d& offset,
                      const Options& options, Cache*) {
  const double extent = max_abs(offset) + a.scale * a.shape->circumradius;
  if (!(usable(a) && extent_in_range(extent) && all_at_least(offset, -extent))) return refused();
  const Scale unit = scale_of(extent);
  const Outline p = outline(a, unit.down, {});
  const double level = dot(b.normal, unit.down * offset), size = 2 * extent * unit.down;
  std::size_t index = 0;
  const double gap = p.lowest(b.normal, index) - level;
  if (!(std::abs(gap) <= 8)) return refused();
  const Vec3d tip = p.vertex(index);
  Contact c = answer(gap, 0, size, -b.normal, tip, tip - gap * b.normal);
  if (options.patch && gap < 0) {
    std::vector<Vec3d> region, scratch;
    for (std::size_t i = 0; i < p.size(); ++i) region.push_back(p.vertex(i));
    cut(region, b.normal, level, scratch);
    area_patch(region, b.normal, c.patch);
  }
  rescale(c, unit.up);
  return c;
}

}  // namespace contact
