#include "libcontact/methods/polygon_regions.h"

#include <algorithm>
#include <cmath>

#include "libcontact/methods/planar_slope.h"
#include "libcontact/methods/polygon_patch.h"
#include "libcontact/methods/polygon_regions_smooth.h"
#include "libcontact/methods/region_parts.h"

namespace contact {

namespace {

using shapes::Kind;
using shapes::Polygon;
using Part = Polygon::Part;

// Sides of a piece: 2 · edge of a's outline, 2 · edge + 1 of b's; cuts likewise, their edge is the last number there
// is.
constexpr std::uint32_t cut_edge = no_edge / 2;
std::uint32_t number_of(std::uint32_t edge, bool of_b) { return 2 * std::min(edge, cut_edge) + (of_b ? 1 : 0); }

double radius(const PartsView& p) { return p.place.scale * p.shape.circumradius; }
void measure(const PlanarOverlap& overlap, double size, Contact& c) {
  DepthSlope slope;
  if (overlap.slope(size, slope)) c.measure = line_of_action(slope);
}

// A part of a against a part of b.
struct Piece {
  std::uint32_t part_a, part_b;
  std::uint32_t first, count;  // corners
};

class PolygonPair {
 public:
  PolygonPair(const PartsView& a, const PartsView& b, double size)
      : a_(a), b_(b), size_(size), smaller_(std::min(radius(a), radius(b))), least_(0.25 * smaller_) {}

  // `sides`: of each region that the list takes.
  void find(const Options& options, RegionList& list, PartSide* sides) {
    clip_parts();
    if (pieces_.size() == 0) return;
    if (pieces_.size() > 1) join();
    for (std::uint32_t i = 0; i < pieces_.size(); ++i)
      if (groups_.of(i) == i) answer(i, options, list, sides);
  }
  // Parts that share no region are farther apart than this; not positive: not known.
  double clearance() const { return least_ - margin_; }

 private:
  void clip_parts() {
    for (std::uint32_t i = 0; i < a_.count(); ++i) {
      const Vec3d centre = a_.place.point(a_.part(i).centre);
      for (std::uint32_t j = 0; j < b_.count(); ++j)
        if (!apart(i, j, centre)) clip(i, j);
    }
  }

  // Proves two parts apart, by their circles or by a side, with a margin for rounding, and takes note of by how much.
  bool apart(std::uint32_t i, std::uint32_t j, const Vec3d& centre) {
    const Part &p = a_.part(i), &q = b_.part(j);
    const Vec3d d = b_.place.point(q.centre) - centre;
    const double square = dot(d, d), reach = a_.place.scale * p.radius + b_.place.scale * q.radius,
                 far = reach + std::max(least_, margin_);
    if (square > far * far) return true;
    double gap = square > reach * reach ? std::sqrt(square) - reach : 0;
    if (gap < least_) gap = std::max(gap, a_.beyond_side(p, b_, q));
    if (gap < least_) gap = std::max(gap, b_.beyond_side(q, a_, p));
    if (!(gap > margin_)) return false;
    least_ = std::min(least_, gap);
    return true;
  }
  // The same of two that turned out to share nothing.
  void look_apart(const Part& p, const Part& q) {
    double gap = 0;
    for (std::size_t k = 0; k < q.normals.size(); ++k) gap = std::max(gap, a_.over_side(p, b_, q, k));
    for (std::size_t k = 0; k < p.normals.size(); ++k) gap = std::max(gap, b_.over_side(q, a_, p, k));
    least_ = std::min(least_, gap);
  }

  void clip(std::uint32_t i, std::uint32_t j) {
    const Part &p = a_.part(i), &q = b_.part(j);
    Corners buffer[2], *region = buffer, *other = buffer + 1;
    for (std::size_t k = 0; k < p.vertices.size(); ++k)
      region->push_back({a_.place.point(p.vertices[k]), number_of(p.edge[k], false)});
    for (std::size_t k = 0; k < q.normals.size(); ++k) {
      const Vec3d n = b_.normal(q, k);
      cut(*region, n, b_.height(q, k, n), number_of(q.edge[k], true), *other);
      std::swap(region, other);
      if (region->size() < 3) return look_apart(p, q);
    }
    const auto first = static_cast<std::uint32_t>(corners_.size());
    for (const LoopCorner& c : *region) corners_.push_back(c);
    pieces_.push_back({i, j, first, static_cast<std::uint32_t>(region->size())});
    groups_.add();
  }

  // The piece of two parts; pieces_.size() when they do not overlap.
  std::uint32_t piece(std::uint32_t part_a, std::uint32_t part_b) const {
    std::uint32_t i = 0;
    while (i < pieces_.size() && !(pieces_[i].part_a == part_a && pieces_[i].part_b == part_b)) ++i;
    return i;
  }

  // A seam of one body passes through a part of the other; with a margin, so that rounding never parts a region.
  bool crosses(const PartsView& of, const Polygon::Seam& seam, const PartsView& other, std::size_t part) const {
    const Vec3d p = of.place.point(seam.end[0]), q = of.place.point(seam.end[1]);
    double from = 0, to = 1;
    const Part& shape = other.part(part);
    for (std::size_t k = 0; k < shape.normals.size(); ++k) {
      const Vec3d n = other.normal(shape, k);
      const double h = other.height(shape, k, n) + planar_half_width * size_;
      const double hp = dot(n, p) - h, hq = dot(n, q) - h;
      if (hp > 0 && hq > 0) return false;
      if (hp > 0) from = std::max(from, hp / (hp - hq));
      if (hq > 0) to = std::min(to, hp / (hp - hq));
    }
    return from <= to;
  }

  // Regions end at a seam whose reflex corner the other body holds.
  void join() {
    for (const Polygon::Seam& seam : a_.shape.seams)
      join(
          b_.count(), [&](std::uint32_t side, std::uint32_t j) { return piece(seam.part[side], j); },
          [&] { return a_.blocked(seam, [&](const Vec3d& x) { return b_.holds(x); }); },
          [&](std::uint32_t j) { return crosses(a_, seam, b_, j); });
    for (const Polygon::Seam& seam : b_.shape.seams)
      join(
          a_.count(), [&](std::uint32_t side, std::uint32_t i) { return piece(i, seam.part[side]); },
          [&] { return b_.blocked(seam, [&](const Vec3d& x) { return a_.holds(x); }); },
          [&](std::uint32_t i) { return crosses(b_, seam, a_, i); });
  }
  template <class Of, class Blocked, class Crosses>
  void join(std::size_t parts, Of&& of, Blocked&& blocked, Crosses&& crosses) {
    bool open = false;  // asked where two pieces lie at the seam
    for (std::uint32_t k = 0; k < parts; ++k) {
      const std::uint32_t x = of(0, k);
      if (x == pieces_.size()) continue;
      const std::uint32_t y = of(1, k);
      if (y == pieces_.size()) continue;
      if (!open && blocked()) return;
      open = true;
      if (crosses(k)) groups_.join(x, y);
    }
  }

  void answer(std::uint32_t group, const Options& options, RegionList& list, PartSide* sides) {
    Marks parts_a, parts_b;
    parts_a.assign(a_.count(), 0);
    parts_b.assign(b_.count(), 0);
    const auto for_each_piece = [&](auto&& use) {
      for (std::uint32_t i = group; i < pieces_.size(); ++i)
        if (groups_.of(i) == group) use(pieces_[i]);
    };
    std::uint32_t count = 0;
    for_each_piece([&](const Piece& p) {
      parts_a[p.part_a] = parts_b[p.part_b] = 1;
      ++count;
    });
    Depth least;
    least.value = std::numeric_limits<double>::infinity();
    Vec3d outward{};
    std::uint32_t edge = no_edge;
    const auto consider = [&](std::uint32_t side) {
      const bool second = side % 2 == 1;
      const PartsView &own = second ? b_ : a_, &other = second ? a_ : b_;
      const Vec3d n = own.edge_normal(side / 2);
      const Depth d = other.behind(n, own.edge_height(side / 2, n), second ? parts_a : parts_b);
      if (!(d.value < least.value)) return;
      least = d;
      outward = n;
      edge = side;
    };
    for_each_piece([&](const Piece& p) {
      for (std::uint32_t k = 0; k < p.count; ++k) {
        const LoopCorner &c = corners_[p.first + k], &next = corners_[p.first + (k + 1 == p.count ? 0 : k + 1)];
        if (c.side / 2 != cut_edge && !(c.x == next.x)) consider(c.side);
      }
    });
    if (edge == no_edge) return;  // between cuts: its neighbours answer
    const bool of_b = edge % 2 == 1;
    const Vec3d on_edge = least.corner + least.value * outward;
    Contact c = region_answer(-least.value, size_, of_b ? -outward : outward, of_b ? least.corner : on_edge,
                              of_b ? on_edge : least.corner);
    PartSide side;
    if (count == 1 && (options.patch || options.measure))
      side = about_corner(pieces_[group], edge, outward, options, c);
    if (side.at.kind == SideContact::none) {
      AreaMoments moments;
      PlanarOverlap overlap;
      for_each_piece([&](const Piece& p) {
        Corners region;
        for (std::uint32_t k = 0; k < p.count; ++k) region.push_back(corners_[p.first + k]);
        if (options.patch) moments.add(region);
        if (!options.measure) return;
        overlap.add(region, [](std::uint32_t of) {
          if (of / 2 == cut_edge) return of % 2 == 0 ? PlanarOverlap::cut_of_a : PlanarOverlap::cut_of_b;
          return of % 2 == 0 ? PlanarOverlap::of_a : PlanarOverlap::of_b;
        });
      });
      if (options.patch) moments.patch(outward, c.patch);
      if (options.measure) measure(overlap, smaller_, c);
    }
    const std::size_t place = list.add(c);
    if (place < max_regions) sides[place] = side;
  }

  // The patch and depth of a region that is one piece, where it lies about one corner behind an edge: the deepest of
  // those within the part that the edge is of.
  PartSide about_corner(const Piece& p, std::uint32_t edge, const Vec3d& out, const Options& options,
                        Contact& c) const {
    const bool of_b = edge % 2 == 1;
    const Loop a(a_.part(p.part_a), a_.place), b(b_.part(p.part_b), b_.place);
    const Loop &self = of_b ? b : a, &other = of_b ? a : b;
    SideContact at{of_b ? SideContact::side_of_b : SideContact::side_of_a};
    while (self.edges[at.side] != edge / 2) ++at.side;
    double gap = 0;
    for (std::uint32_t k = 0; k < other.size(); ++k) {
      const Vec3d x = other.vertex(k);
      if (const double over = height_over(self, at.side, x); over < gap && holds(self, x)) gap = over, at.corner = k;
    }
    const Vec3d along{-out.y, out.x, 0};
    const double foot = dot_xy(along, other.vertex(at.corner)) - dot_xy(along, self.vertex(at.side));
    if (!(gap < 0) || !corner_patch({self, other, at, out, gap, foot}, smaller_, 1, options, c)) return {};
    return {at, p.part_a, p.part_b};
  }
  static double height_over(const Loop& p, std::uint32_t side, const Vec3d& x) {
    const Vec3d n = p.normal(side);
    return dot_xy(n, x) - p.height(side, n);
  }
  static bool holds(const Loop& p, const Vec3d& x) {
    for (std::uint32_t i = 0; i < p.size(); ++i)
      if (!(height_over(p, i, x) < 0)) return false;
    return true;
  }

  const PartsView &a_, &b_;
  double size_, smaller_, least_, margin_ = planar_half_width * size_;
  ShortList<Piece, 16> pieces_;
  ShortList<LoopCorner, 64> corners_;
  Groups groups_;
};

std::size_t pair_regions(const Placed<Polygon>& a, const Placed<Polygon>& b, const Vec3d& offset,
                         const Options& options, Contact* out, RegionSearch& search) {
  const double extent = max_abs(offset) + (a.scale * a.shape->circumradius + b.scale * b.shape->circumradius);
  if (!(a.scale > 0 && b.scale > 0 && extent_in_range(extent) && all_at_least(offset, -extent))) {
    out[0] = refused();
    return 1;
  }
  const Scale unit = scale_of(extent);
  const PartsView view_a{*a.shape, placement(a, unit.down, {})};
  const PartsView view_b{*b.shape, placement(b, unit.down, unit.down * offset)};
  RegionList list(out, max_regions);
  PolygonPair pair(view_a, view_b, 2 * extent * unit.down);
  pair.find(options, list, search.side);
  search.clearance = std::max(0.0, pair.clearance()) * unit.up;
  return list.finish(unit.up);
}

std::size_t line_regions(const Placed<Polygon>& a, const Placed<shapes::Line>& b, const Vec3d& offset,
                         const Options& options, Contact* out) {
  const double extent = max_abs(offset) + a.scale * a.shape->circumradius;
  if (!(a.scale > 0 && extent_in_range(extent) && all_at_least(offset, -extent))) {
    out[0] = refused();
    return 1;
  }
  const Scale unit = scale_of(extent);
  const PartsView view{*a.shape, placement(a, unit.down, {})};
  const Vec3d& m = b.normal;
  const double level = dot(m, unit.down * offset), size = 2 * extent * unit.down;
  const auto below = [&](const Vec3d& x) { return dot(m, x) < level; };
  Groups groups;
  Marks touched;
  for (std::size_t i = 0; i < view.count(); ++i) {
    char mark = 0;
    for (const Vec3d& v : view.part(i).vertices)
      if (below(view.place.point(v))) mark = 1;
    touched.push_back(mark);
    groups.add();
  }
  for (const Polygon::Seam& seam : a.shape->seams) {
    if (!view.blocked(seam, below) && (below(view.place.point(seam.end[0])) || below(view.place.point(seam.end[1]))))
      groups.join(seam.part[0], seam.part[1]);
  }
  RegionList list(out, max_regions);
  for (std::uint32_t g = 0; g < view.count(); ++g) {
    if (groups.of(g) != g) continue;
    Depth deepest;
    AreaMoments moments;
    PlanarOverlap overlap;
    for (std::uint32_t i = g; i < view.count(); ++i) {
      if (groups.of(i) != g || !touched[i]) continue;
      Corners part, region;
      for (const Vec3d& v : view.part(i).vertices) {
        const Vec3d x = view.place.point(v);
        if (const double d = level - dot(m, x); d > deepest.value) deepest = {d, x};
        part.push_back({x, PlanarOverlap::of_a});
      }
      if (!options.patch && !options.measure) continue;
      cut(part, m, level, PlanarOverlap::of_b, region);
      if (options.patch) moments.add(region);
      if (options.measure) overlap.add(region, [](std::uint32_t side) { return side; });
    }
    if (!(deepest.value > 0)) continue;
    Contact c = region_answer(-deepest.value, size, -m, deepest.corner, deepest.corner + deepest.value * m);
    if (options.patch) moments.patch(m, c.patch);
    if (options.measure) measure(overlap, radius(view), c);
    list.add(c);
  }
  return list.finish(unit.up);
}

bool is_cut(const Body& b) {
  return b.kind == Kind::polygon && b.geometry != nullptr && !static_cast<const Polygon*>(b.geometry)->convex;
}

}  // namespace

bool meets_in_regions(const Body& a, const Body& b) { return is_cut(a) || is_cut(b); }

std::size_t polygon_regions(const Body& a, const Body& b, const Vec3d& offset, const Options& options, Contact* out,
                            RegionSearch* search) {
  if (a.kind == Kind::disc && b.kind == Kind::polygon)
    return disc_regions(a.size.x, placed<Polygon>(b), offset, {out, max_regions});
  if (a.kind == Kind::ellipse && b.kind == Kind::polygon)
    return ellipse_regions(placed<shapes::Ellipse>(a), placed<Polygon>(b), offset, {out, max_regions});
  if (a.kind == Kind::polygon && b.kind == Kind::line)
    return line_regions(placed<Polygon>(a), placed<shapes::Line>(b), offset, options, out);
  if (a.kind != Kind::polygon || b.kind != Kind::polygon) {
    out[0] = refused();
    return 1;
  }
  RegionSearch unused;
  RegionSearch& found = search == nullptr ? unused : *search;
  if (!seen_from_b(offset)) return pair_regions(placed<Polygon>(a), placed<Polygon>(b), offset, options, out, found);
  const std::size_t count = pair_regions(placed<Polygon>(b), placed<Polygon>(a), -offset, options, out, found);
  for (std::size_t i = 0; i < count; ++i) {
    out[i] = exchanged(out[i], offset);
    PartSide& side = found.side[i];
    std::swap(side.part_a, side.part_b);
    if (side.at.kind != SideContact::none)
      side.at.kind = side.at.kind == SideContact::side_of_a ? SideContact::side_of_b : SideContact::side_of_a;
  }
  return count;
}

}  // namespace contact
