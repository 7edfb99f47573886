#include "libcontact/methods/polygon_pair.h"

#include <algorithm>
#include <cmath>

#include "libcontact/methods/facet_alone.h"
#include "libcontact/methods/method.h"
#include "libcontact/methods/polygon_patch.h"
#include "libcontact/scale.h"

namespace contact {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// A side of `self` as `other` meets it, in world axes.
struct Side {
  Vec3d out;      // unit
  double height;  // out·x on it
  Vec3d seen;     // out in other's own frame
  Side(const Loop& self, const Loop& other, std::uint32_t i)
      : out(self.normal(i)), height(self.height(i, out)), seen(other.in_frame(out)) {}
};

double corner_height(const Side& side, const Loop& other, std::uint32_t corner) {
  return dot_xy(side.out, other.vertex(corner)) - side.height;
}

// The corner of `other` that is lowest over a side; of corners level to rounding, the first of those that compare
// lowest.
double lowest_corner(const Side& side, const Loop& other, double size, std::uint32_t& corner) {
  const Lowest found = lowest_from(other.vertices, side.seen, corner);
  corner = found.vertex;
  if (other.place.scale * found.rise > 16 * epsilon * size) return corner_height(side, other, corner);
  double least = infinity;
  for (std::uint32_t i = 0; i < other.size(); ++i)
    if (const double h = corner_height(side, other, i); h < least) least = h, corner = i;
  return least;
}

// A point inside a loop, with the radius of a circle about it.
struct Core {
  Vec3d centre;
  double radius;
};
Core core_of(const Loop& p) {
  if (p.core > 0) return {p.place.at, p.place.scale * p.core};
  return {p.vertex(0), 0};
}

struct Best {
  double value = -infinity;
  SideContact at;
};

// The sides of `self`. Stops at the first one above `enough`.
void search(const Loop& self, const Loop& other, SideContact::Kind kind, double size, double enough, Best& best) {
  const Placement& p = self.place;
  const auto seen = [&](const Vec3d& x) {  // in self's own frame
    const Vec3d d = x - p.at;
    return Vec3d{p.cosine * d.x + p.sine * d.y, p.cosine * d.y - p.sine * d.x, 0};
  };
  const auto height = [&](std::uint32_t i, const Vec3d& x) {
    return dot_xy(self.normals[i], x) - p.scale * self.offsets[i];
  };
  const Core core = core_of(other);
  const Vec3d centre = seen(core.centre);
  std::uint32_t first = 0;
  double top = -infinity;
  for (std::uint32_t i = 0; i < self.size(); ++i)
    if (const double h = height(i, centre); h > top) top = h, first = i;
  const double margin = 16 * epsilon * size;
  std::uint32_t corner = 0;
  const auto evaluate = [&](std::uint32_t i) {
    const double value = lowest_corner(Side(self, other, i), other, size, corner);
    const bool earlier = value == best.value && best.at.kind == kind && i < best.at.side;
    if (value > best.value || earlier) best = {value, {kind, i, corner}};
  };
  evaluate(first);
  if (best.value > enough) return;
  const Vec3d tip = seen(other.vertex(corner));
  for (std::uint32_t i = 0; i < self.size(); ++i) {
    if (i == first || height(i, centre) - core.radius + margin < best.value || height(i, tip) + margin < best.value)
      continue;
    evaluate(i);
    if (best.value > enough) return;
  }
}

struct Witness {
  Vec3d n, on_a, on_b;
  double foot, from, to;  // along the side: of the corner, and the side's ends
};

Witness witness_of(const Loop& self, const Loop& other, const SideContact& at, const Side& side, double value) {
  const Vec3d v = other.vertex(at.corner), along{-side.out.y, side.out.x, 0};
  const Vec3d p = self.vertex(at.side), q = self.vertex(self.next(at.side));
  const double u = dot_xy(along, v), from = dot_xy(along, p), to = std::max(from, dot_xy(along, q));
  const double inside = std::clamp(u, from, to);
  const Vec3d on_other = v + (inside - u) * along, under = on_other - value * side.out;
  if (at.kind == SideContact::side_of_a) return {side.out, under, on_other, u, from, to};
  return {-side.out, on_other, under, u, from, to};
}

// Does the search find this side, and is none as near? Moves the corner to the lowest one.
bool stands(const Loop& self, const Loop& other, SideContact& at, double size, double& value, Witness& w) {
  if (!(at.side < self.size() && at.corner < other.size())) return false;
  const Side side(self, other, at.side);
  const Lowest lowest = lowest_from(other.vertices, side.seen, at.corner);
  at.corner = lowest.vertex;
  value = corner_height(side, other, at.corner);
  w = witness_of(self, other, at, side, value);
  const auto below = [&](std::uint32_t i) {
    return self.place.scale * (self.offsets[at.side] - dot_xy(self.normals[at.side], self.vertices[i]));
  };
  const double next = std::min(below(self.before(at.side)), below(self.next(self.next(at.side))));
  const Core own = core_of(self), its = core_of(other);
  return facet_is_alone(-value, std::min(w.foot - w.from, w.to - w.foot),
                        std::min(next, other.place.scale * lowest.rise), side.out, own.centre - its.centre,
                        own.radius + its.radius, size);
}

// Member by member: a copy of a whole answer costs as much as the proof of a side.
void set(Contact& c, double value, double half_width, double up, const Witness& w) {
  const double lower = value - half_width, upper = value + half_width;
  c.status = lower > 0 ? Status::separated : (upper < 0 ? Status::overlapping : Status::touching);
  c.certified = true;
  c.gap = value * up;
  c.gap_lower = lower * up;
  c.gap_upper = upper * up;
  c.normal = c.method_normal = w.n;
  c.point_a = up * w.on_a;
  c.point_b = up * w.on_b;
  c.patch.centre = c.method_point = 0.5 * (c.point_a + c.point_b);
  c.method_overlap = -value * up;
}

// The direction between the nearest two corners, where it says more than `value` along n.
void try_corners(const Loop& a, const Loop& b, double& value, Witness& w) {
  double least = infinity;
  std::uint32_t ia = 0, ib = 0;
  for (std::uint32_t i = 0; i < a.size(); ++i) {
    const Vec3d va = a.vertex(i);
    for (std::uint32_t j = 0; j < b.size(); ++j) {
      const Vec3d between = b.vertex(j) - va;
      if (const double square = dot_xy(between, between); square < least) least = square, ia = i, ib = j;
    }
  }
  const Vec3d va = a.vertex(ia), vb = b.vertex(ib);
  Vec3d towards;
  if (!(length_and_direction(vb - va, towards) > 0 && towards.z == 0)) return;
  const auto lowest = [&](const Loop& p, const Vec3d& n) {
    double low = infinity;
    for (const Vec3d& v : p.vertices) low = std::min(low, dot_xy(n, p.place.point(v)));
    return low;
  };
  if (const double f = lowest(b, towards) + lowest(a, -towards); f > value) {
    value = f;
    w.n = towards;
    w.on_a = va;
    w.on_b = vb;
  }
}

}  // namespace

void loop_pair(const Loop& a, const Loop& b, const PairSize& pair, const Options& options, SideContact& known,
               Contact& c) {
  const double size = pair.extent, up = pair.up;
  SideContact at = known;
  known = {};
  double value = 0;
  Witness w{};
  const auto of_a = [&] { return at.kind == SideContact::side_of_a; };
  const auto self = [&]() -> const Loop& { return of_a() ? a : b; };
  const auto other = [&]() -> const Loop& { return of_a() ? b : a; };
  if (at.kind == SideContact::none || !stands(self(), other(), at, size, value, w)) {
    const double enough = options.overlap_only ? proof_margin(size) : infinity;
    Best best;
    search(a, b, SideContact::side_of_a, size, enough, best);
    if (!(best.value > enough)) search(b, a, SideContact::side_of_b, size, enough, best);
    if (!(std::abs(best.value) <= 8)) return;
    at = best.at;
    value = best.value;
    const Side side(self(), other(), at.side);
    if (value > enough) {
      c = separation_proof(value, size, of_a() ? side.out : -side.out, up);
      return;
    }
    w = witness_of(self(), other(), at, side, value);
    // Over the side itself the nearest points are found.
    if (value > -planar_half_width * size && !(w.from <= w.foot && w.foot <= w.to)) try_corners(a, b, value, w);
    if (!(std::abs(value) <= 8)) return;
  }
  set(c, value, planar_half_width * size, up, w);
  if (!(value < 0)) return;
  known = at;
  if (options.patch || options.measure)
    polygon_patch({self(), other(), at, of_a() ? w.n : -w.n, value, w.foot - w.from}, pair.smaller, up, options, c);
}

}  // namespace contact
