#include "libcontact/methods/polygon_patch.h"

#include <algorithm>
#include <cmath>

#include "libcontact/kernels/side_overlap.h"
#include "libcontact/methods/planar_slope.h"
#include "libcontact/methods/short_list.h"
#include "libcontact/scale.h"

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

// The side's plane.
class Frame {
 public:
  Frame(const SideView& view, double up)
      : view_(view),
        border_(view.other, view.at.corner, view.out, -view.gap),
        n_(view.self.normals[view.at.side]),
        start_(view.self.vertices[view.at.side]),
        up_(up) {}

  const Border& border() const { return border_; }
  Point corner(std::uint32_t i) const {  // of self
    const Loop& self = view_.self;
    const Vec3d e = self.vertices[i] - start_;
    return {self.place.scale * (n_.x * e.y - n_.y * e.x) - view_.from_start, -self.place.scale * dot_xy(n_, e)};
  }
  Vec3d direction(double u, double h) const { return u * along() - h * view_.out; }
  Vec3d point(double u, double h) const {
    const Loop& other = view_.other;
    return other.place.point(other.vertices[view_.at.corner]) - view_.gap * view_.out + direction(u, h);
  }
  void set_patch(double u, double h, double square, Patch& patch) const {
    const double m = square * up_ * up_;
    patch.centre = up_ * point(u, h);
    patch.spread[0] = m * along().x * along().x;
    patch.spread[1] = m * along().y * along().y;
    patch.spread[3] = m * along().x * along().y;
  }

 private:
  Vec3d along() const { return {-view_.out.y, view_.out.x, 0}; }
  const SideView& view_;
  Border border_;
  Vec3d n_, start_;
  double up_;
};

// The whole overlap, clipped.
void clipped_patch(const SideView& view, const Frame& frame, Patch& patch) {
  const Loop& self = view.self;
  Points lists[2];
  Points *region = lists, *spare = lists + 1;
  behind_side(frame.border(), view.at.corner, *region);
  double deepest = 0;
  for (const Point& p : *region) deepest = std::max(deepest, p.h);
  // The sides of self behind this one, either way, until they run below the region: self being convex, they hold all of
  // its border that is as high.
  std::uint32_t right = self.next(view.at.side), left = view.at.side;
  for (Point p = frame.corner(right); self.next(right) != left;) {
    right = self.next(right);
    const Point q = frame.corner(right);
    if (!cut(region, spare, p, q)) return;
    if (q.h >= deepest) break;
    p = q;
  }
  for (Point q = frame.corner(view.at.side); left != right;) {
    left = self.before(left);
    const Point p = frame.corner(left);
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
  frame.set_patch(u, first_h / area, std::max(0.0, second_u / area - u * u), patch);
}

}  // namespace

bool corner_patch(const SideView& view, double smaller, double up, const Options& options, Contact& c) {
  const Loop &self = view.self, &other = view.other;
  const Frame frame(view, up);
  const auto of_self = [&](std::uint32_t i) {
    const Point p = frame.corner(i);
    return SidePoint<double>{p.u, p.h};
  };
  const auto of_other = [&](std::uint32_t i) {
    const Point p = frame.border()(i);
    return SidePoint<double>{p.u, p.h};
  };
  const std::uint32_t corner = view.at.corner, second = self.next(view.at.side), left = other.next(corner),
                      right = other.before(corner), half = corner + other.size() / 2;
  SideRegion<double> region;
  if (!region.find({-view.gap,
                    -view.from_start,
                    of_self(second).u,
                    of_self(self.before(view.at.side)),
                    of_self(self.next(second)),
                    {of_other(left), of_other(other.next(left))},
                    {of_other(right), of_other(other.before(right))},
                    of_other(half < other.size() ? half : half - other.size()),
                    self.is_cut(self.before(view.at.side)),
                    self.is_cut(second),
                    {other.is_cut(corner), other.is_cut(left)},
                    {other.is_cut(right), other.is_cut(other.before(right))}}))
    return false;
  const SideOverlap<double> found = region.measure();
  if (!(found.area > 0x1p-900)) return false;
  if (options.patch) frame.set_patch(found.u, found.h, std::max(0.0, found.spread), c.patch);
  const double least = least_depth * smaller;
  if (!options.measure || !(found.section > least && found.variance > 0 && found.depth > least)) return true;
  const Vec3d force = frame.direction(found.force.u, found.force.h);
  const double sign = view.at.kind == SideContact::side_of_a ? 1 : -1;
  c.measure = line_of_action({.depth = found.depth,
                              .force = sign * force,
                              .moment = {0, 0, sign * found.moment},
                              .centroid = frame.point(found.u, found.h)});
  rescale(c.measure, up);
  return true;
}

void polygon_patch(const SideView& view, double smaller, double up, const Options& options, Contact& c) {
  if (corner_patch(view, smaller, up, options, c)) return;
  if (options.patch) clipped_patch(view, Frame(view, up), c.patch);
  const bool of_a = view.at.kind == SideContact::side_of_a;
  if (options.measure &&
      outlines_depth(of_a ? view.self : view.other, of_a ? view.other : view.self, smaller, c.measure))
    rescale(c.measure, up);
}

}  // namespace contact
