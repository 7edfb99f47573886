#include "libcontact/methods/polygon_patch.h"

#include <algorithm>
#include <cmath>

#include "libcontact/methods/short_list.h"

namespace contact {

namespace {

struct Point {
  double u, h;  // along the side from the foot of the corner; depth behind the side
};
using Points = ShortList<Point, 32>;

Point crossing(const Point& p, const Point& q, double hp, double hq) {
  const double t = hp / (hp - hq);
  return {p.u + t * (q.u - p.u), p.h + t * (q.h - p.h)};
}

// Other's border in the plane of the side, counted from the corner.
struct Border {
  const Loop& loop;
  Vec3d x, y, tip;
  double depth;

  Border(const Loop& p, std::uint32_t corner, const Vec3d& out, double d)
      : loop(p), x(in_frame({-out.y, out.x, 0})), y(in_frame(out)), tip(p.vertices[corner]), depth(d) {}
  Vec3d in_frame(const Vec3d& v) const {
    const Placement& p = loop.place;
    return {p.scale * (p.cosine * v.x + p.sine * v.y), p.scale * (p.cosine * v.y - p.sine * v.x), 0};
  }
  Point operator()(std::uint32_t i) const {
    const Vec3d e = loop.vertices[i] - tip;
    return {dot_xy(x, e), depth - dot_xy(y, e)};
  }
};

// What of it lies behind the side, from where it goes in to where it comes out.
void behind_side(const Border& border, std::uint32_t corner, Points& region) {
  const Loop& other = border.loop;
  std::uint32_t first = corner;
  Point entry{0, border.depth}, before = border(other.before(first));
  while (before.h > 0 && other.before(first) != corner) {
    first = other.before(first);
    entry = before;
    before = border(other.before(first));
  }
  if (!(before.h > 0)) region.push_back({crossing(before, entry, before.h, entry.h).u, 0});
  region.push_back(entry);
  Point last = entry;
  for (std::uint32_t i = other.next(first); i != first; i = other.next(i)) {
    const Point p = i == corner ? Point{0, border.depth} : border(i);
    if (!(p.h > 0)) {
      region.push_back({crossing(last, p, last.h, p.h).u, 0});
      return;
    }
    region.push_back(p);
    last = p;
  }
}

// The part of a region on the inner side of the line from p to q, as the border of `self` runs there.
bool cut(Points*& region, Points*& spare, const Point& p, const Point& q) {
  const double cu = p.h - q.h, ch = q.u - p.u;
  const auto within = [&](const Point& x) { return cu * (x.u - p.u) + ch * (x.h - p.h); };
  bool outside = false;
  for (const Point& x : *region) outside |= within(x) < 0;
  if (!outside) return true;
  spare->clear();
  Point last = (*region)[region->size() - 1];
  double side = within(last);
  for (const Point& x : *region) {
    const double here = within(x);
    if ((here < 0) != (side < 0)) spare->push_back(crossing(last, x, side, here));
    if (!(here < 0)) spare->push_back(x);
    last = x;
    side = here;
  }
  std::swap(region, spare);
  return region->size() >= 3;
}

}  // namespace

void polygon_patch(const Loop& self, const Loop& other, const SideContact& at, const Vec3d& out, double gap,
                   double from_start, double up, Patch& patch) {
  const Vec3d n = self.normals[at.side], start = self.vertices[at.side];
  const Border border(other, at.corner, out, -gap);
  const auto corner = [&](std::uint32_t i) {
    const Vec3d e = self.vertices[i] - start;
    return Point{self.place.scale * (n.x * e.y - n.y * e.x) - from_start, -self.place.scale * dot_xy(n, e)};
  };
  const auto set = [&](double u, double h, double square) {
    const Vec3d along{-out.y, out.x, 0}, foot = other.place.point(other.vertices[at.corner]) - gap * out;
    const double m = square * up * up;
    patch.centre = up * (foot + u * along - h * out);
    patch.spread[0] = m * along.x * along.x;
    patch.spread[1] = m * along.y * along.y;
    patch.spread[3] = m * along.x * along.y;
  };
  const std::uint32_t second = self.next(at.side);
  // One corner alone behind the side, clear of its ends: a triangle.
  const Point before = border(other.before(at.corner)), after = border(other.next(at.corner));
  const Point left_end = corner(at.side), left_next = corner(self.before(at.side));
  const Point right_end = corner(second), right_next = corner(self.next(second));
  if (!(before.h > 0) && !(after.h > 0) && left_next.h > -gap && right_next.h > -gap) {
    const double d = -gap, l = d / (d - before.h) * before.u, r = d / (d - after.h) * after.u;
    // The outer corners and the tip against the lines of the sides beyond.
    const auto within = [&](const Point& p, const Point& q, double u, double h) {
      return (p.h - q.h) * (u - p.u) + (q.u - p.u) * (h - p.h) >= 0;
    };
    const double low = std::min(l, r), high = std::max(l, r);
    if (within(right_end, right_next, high, 0) && within(right_end, right_next, 0, d) &&
        within(left_next, left_end, low, 0) && within(left_next, left_end, 0, d)) {
      if ((high - low) * d > 0x1p-900) set((l + r) / 3, d / 3, (l * l + r * r - l * r) / 18);
      return;
    }
  }
  Points lists[2];
  Points *region = lists, *spare = lists + 1;
  behind_side(border, at.corner, *region);
  double deepest = 0;
  for (const Point& p : *region) deepest = std::max(deepest, p.h);
  // The sides of self behind this one, either way, until they run below the region: self being convex, they hold all of
  // its border that is as high.
  std::uint32_t right = second, left = at.side;
  for (Point p = right_end; self.next(right) != left;) {
    right = self.next(right);
    const Point q = corner(right);
    if (!cut(region, spare, p, q)) return;
    if (q.h >= deepest) break;
    p = q;
  }
  for (Point q = left_end; left != right;) {
    left = self.before(left);
    const Point p = corner(left);
    if (!cut(region, spare, p, q)) return;
    if (p.h >= deepest) break;
    q = p;
  }
  double area = 0, first_u = 0, first_h = 0, second_u = 0;
  const Points& list = *region;
  const Point a = list[0];
  for (std::size_t i = 1; i + 1 < list.size(); ++i) {
    const Point b = list[i], c = list[i + 1];
    const double w = 0.5 * std::abs((b.u - a.u) * (c.h - a.h) - (b.h - a.h) * (c.u - a.u));
    const double u = a.u + b.u + c.u;
    // ∫u² over a triangle = w/12 (Σ uᵢ² + (Σ uᵢ)²)
    area += w;
    first_u += w / 3 * u;
    first_h += w / 3 * (a.h + b.h + c.h);
    second_u += w / 12 * (a.u * a.u + b.u * b.u + c.u * c.u + u * u);
  }
  if (!(area > 0x1p-900)) return;
  const double u = first_u / area;
  set(u, first_h / area, std::max(0.0, second_u / area - u * u));
}

}  // namespace contact
