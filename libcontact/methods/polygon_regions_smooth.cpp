#include "libcontact/methods/polygon_regions_smooth.h"

#include <algorithm>
#include <cmath>

#include "libcontact/methods/planar_space.h"
#include "libcontact/methods/point_ellipsoid.h"
#include "libcontact/methods/segments.h"

namespace contact {

namespace {

using shapes::Polygon;
using Part = Polygon::Part;

// What one direction says about the pair.
struct Witness {
  double gap;
  Vec3d normal, on_a, on_b;  // normal from the smooth body to the polygon
};

// Smooth bodies about the origin, in units.
struct DiscView {
  double radius;
  // Where the disc is the unit disc.
  Vec3d round(const Vec3d& x) const { return x * (1 / radius); }
  Contact against(const Loop& o, double size) const { return disc_loop(radius, o, size); }
  Witness edge(const Vec3d& out, double height) const { return {-height - radius, -out, -radius * out, height * out}; }
  template <class Accept>
  void corner(const Vec3d& v, Accept&& accept) const {
    Vec3d n;
    const double distance = length_and_direction(v, n);
    if (distance > 0 && n.z == 0) accept(Witness{distance - radius, n, radius * n, v});
  }
};

struct EllipseView {
  Placed<shapes::Ellipse> ellipse;
  Placed<shapes::Ellipsoid> e;
  explicit EllipseView(const Placed<shapes::Ellipse>& a) : ellipse(a), e(in_space(a)) {}
  Vec3d support(const Vec3d& n) const { return scaled(e.semi_axes, transposed_times(e.rotation, n)); }
  Vec3d round(const Vec3d& x) const {
    const Vec3d y = transposed_times(e.rotation, x);
    return {y.x / e.semi_axes.x, y.y / e.semi_axes.y, 0};
  }
  Contact against(const Loop& o, double size) const { return ellipse_loop(ellipse, o, size); }
  Witness edge(const Vec3d& out, double height) const {
    const Vec3d u = support(-out);
    const double reach = norm(u), gap = -height - reach;
    const Vec3d on_a = e.rotation * scaled(e.semi_axes, u * (1 / reach));
    return {gap, -out, on_a, on_a - gap * out};
  }
  template <class Accept>
  void corner(const Vec3d& v, Accept&& accept) const {
    const Vec3d y = transposed_times(e.rotation, v);
    EllipsoidFoot feet[2] = {nearest_on_ellipsoid(e.semi_axes, y), {}};
    const int count = second_foot(e.semi_axes, y, feet[1]) ? 2 : 1;
    for (int k = 0; k < count; ++k) {
      const Vec3d n = e.rotation * feet[k].normal;
      accept(Witness{dot(n, v) - norm(support(n)), n, e.rotation * feet[k].foot, v});
    }
  }
};

double cross_z(const Vec3d& a, const Vec3d& b) { return a.x * b.y - a.y * b.x; }

template <class Smooth>
class SmoothPair {
 public:
  SmoothPair(const Smooth& a, const PartsView& b, double size) : a_(a), b_(b), size_(size) {}

  void find(double reach, RegionList& list) {
    Groups groups;
    for (std::uint32_t i = 0; i < b_.count(); ++i) {
      const bool met =
          b_.near(i, {}, reach, planar_half_width * size_) && a_.against(Loop(b_.part(i), b_.place), size_).gap < 0;
      touched_.push_back(met ? 1 : 0);
      groups.add();
    }
    for (std::size_t s = 0; s < b_.shape.seams.size(); ++s) {
      const Polygon::Seam& seam = b_.shape.seams[s];
      if (touched_[seam.part[0]] && touched_[seam.part[1]] &&
          !b_.blocked(seam, [&](const Vec3d& x) { return holds(x); }) &&
          crosses(b_.place.point(seam.end[0]), b_.place.point(seam.end[1]), planar_half_width))
        groups.join(seam.part[0], seam.part[1]);
    }
    // Within the polygon a body may cross no edge: then every edge of the parts that it meets counts.
    bool found = false;
    for (const bool all : {false, true})
      for (std::uint32_t g = 0; g < b_.count() && (!all || !found); ++g)
        if (touched_[g] && groups.of(g) == g) found |= answer(groups, g, all, list);
  }

 private:
  bool holds(const Vec3d& x) const {
    const Vec3d y = a_.round(x);
    return dot(y, y) < 1;
  }
  bool crosses(const Vec3d& p, const Vec3d& q, double margin) const {
    const Vec3d y = a_.round(p);
    const Vec3d nearest = point_segment({}, y, a_.round(q) - y).b;
    return dot(nearest, nearest) < 1 + margin;
  }

  // The corner between two sides of the outline is convex, and w lies between their normals.
  bool in_cone(const Vec3d& before, const Vec3d& after, const Vec3d& w) const {
    return cross_z(before, after) > 0 && cross_z(before, w) >= 0 && cross_z(w, after) >= 0;
  }

  bool answer(const Groups& groups, std::uint32_t group, bool all, RegionList& list) const {
    Witness best{-std::numeric_limits<double>::infinity(), {}, {}, {}};
    const auto accept = [&](const Witness& w) {
      if (w.gap > best.gap) best = w;
    };
    for (std::uint32_t i = group; i < b_.count(); ++i)
      if (touched_[i] && groups.of(i) == group) edges_and_corners(b_.part(i), all, accept);
    if (!(best.gap > -std::numeric_limits<double>::infinity())) return false;
    if (best.gap < 0) list.add(region_answer(best.gap, size_, best.normal, best.on_a, best.on_b));
    return true;
  }

  template <class Accept>
  void edges_and_corners(const Part& part, bool all, Accept&& accept) const {
    const Polygon& shape = b_.shape;
    for (std::size_t k = 0; k < part.vertices.size(); ++k) {
      const std::uint32_t e = part.edge[k];
      if (e == no_edge) continue;
      const Vec3d p = b_.place.point(part.vertices[k]);
      const Vec3d q = b_.place.point(part.vertices[k + 1 == part.vertices.size() ? 0 : k + 1]);
      if (!all && !crosses(p, q, 0)) continue;
      const Vec3d out = b_.edge_normal(e);
      accept(a_.edge(out, b_.edge_height(e, out)));
      for (const std::uint32_t c : {e, shape.next(e)}) {
        const Vec3d v = b_.place.point(shape.vertices[c]);
        if (!holds(v)) continue;
        const Vec3d before = b_.edge_normal(shape.before(c)), after = b_.edge_normal(c);
        a_.corner(v, [&](const Witness& w) {
          if (in_cone(before, after, -w.normal)) accept(w);
        });
      }
    }
  }

  const Smooth& a_;
  const PartsView& b_;
  double size_;
  Marks touched_;
};

template <class Smooth>
std::size_t regions(const Smooth& a, double reach, const Placed<Polygon>& b, const Vec3d& offset, const Scale& unit,
                    double size, RegionList& list) {
  const PartsView view{*b.shape, placement(b, unit.down, unit.down * offset)};
  SmoothPair<Smooth>(a, view, size).find(reach, list);
  return list.finish(unit.up);
}

}  // namespace

std::size_t disc_regions(double radius, const Placed<Polygon>& b, const Vec3d& offset, RegionList list) {
  const double extent = max_abs(offset) + (radius + b.scale * b.shape->circumradius);
  if (!(radius > 0 && b.scale > 0 && extent_in_range(extent) && all_at_least(offset, -extent))) {
    list.add(refused());
    return 1;
  }
  const Scale unit = scale_of(extent);
  const double r = radius * unit.down;
  return regions(DiscView{r}, r, b, offset, unit, 2 * extent * unit.down, list);
}

std::size_t ellipse_regions(const Placed<shapes::Ellipse>& a, const Placed<Polygon>& b, const Vec3d& offset,
                            RegionList list) {
  const double extent = max_abs(offset) + (std::max(a.a, a.b) + b.scale * b.shape->circumradius);
  const double limit = smallest_ratio * extent;
  if (!(a.a >= limit && a.b >= limit && b.scale > 0 && extent_in_range(extent) && all_at_least(offset, -extent))) {
    list.add(refused());
    return 1;
  }
  const Scale unit = scale_of(extent);
  const EllipseView view({a.a * unit.down, a.b * unit.down, a.cosine, a.sine});
  return regions(view, std::max(a.a, a.b) * unit.down, b, offset, unit, 2 * extent * unit.down, list);
}

}  // namespace contact
