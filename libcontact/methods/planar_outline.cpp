#include "libcontact/methods/planar_outline.h"

#include <algorithm>
#include <cmath>

#include "libcontact/methods/method.h"
#include "libcontact/methods/planar_space.h"
#include "libcontact/methods/point_ellipsoid.h"
#include "libcontact/scale.h"

namespace contact {

namespace {

const double infinity = std::numeric_limits<double>::infinity();

Contact answer(double gap, double excess, double size, const Vec3d& n, const Vec3d& a, const Vec3d& b) {
  return smooth_contact(gap, gap - planar_half_width * size, gap + planar_half_width * size + excess, n, a, b);
}

}  // namespace

void cut(const Corners& in, const Vec3d& n, double height, std::uint32_t side, Corners& out) {
  out.clear();
  if (in.size() == 0) return;
  LoopCorner p = in[in.size() - 1];
  double hp = dot(n, p.x) - height;
  for (const LoopCorner& q : in) {
    const double hq = dot(n, q.x) - height;
    const auto crossing = [&] { return p.x + (hp / (hp - hq)) * (q.x - p.x); };
    if (hp < 0) {
      out.push_back(p);
      if (hq > 0) out.push_back({crossing(), side});
    } else if (hp == 0) {
      out.push_back({p.x, hq > 0 ? side : p.side});
    } else if (hq < 0) {
      out.push_back({crossing(), p.side});
    }
    p = q;
    hp = hq;
  }
}

void AreaMoments::add(const Corners& region) {
  if (region.size() < 3) return;
  if (area_ == 0) origin_ = region[0].x;
  // Triangles about the region's own first corner, which is d from the origin.
  const Vec3d d = region[0].x - origin_;
  for (std::size_t i = 1; i + 1 < region.size(); ++i) {
    const Vec3d p = region[i].x - region[0].x, q = region[i + 1].x - region[0].x;
    const double w = 0.5 * std::abs(p.x * q.y - p.y * q.x);
    const Vec3d mean = d + (1.0 / 3) * (p + q), u = d + p, v = d + q;
    // ∫x² over a triangle = w/12 (Σ xᵢ² + 9 x̄²)
    area_ += w;
    first_ += w * mean;
    xx_ += w / 12 * (d.x * d.x + u.x * u.x + v.x * v.x + 9 * mean.x * mean.x);
    yy_ += w / 12 * (d.y * d.y + u.y * u.y + v.y * v.y + 9 * mean.y * mean.y);
    xy_ += w / 12 * (d.x * d.y + u.x * u.y + v.x * v.y + 9 * mean.x * mean.y);
  }
}

bool AreaMoments::patch(const Vec3d& n, Patch& patch) const {
  if (!(area_ > 0x1p-900)) return false;
  const Vec3d along{-n.y, n.x, 0}, mean = first_ * (1 / area_);
  const double second = (along.x * along.x * xx_ + along.y * along.y * yy_ + 2 * along.x * along.y * xy_) / area_;
  const double u = dot(along, mean), m = std::max(0.0, second - u * u);
  patch.centre = origin_ + mean;
  patch.spread[0] = m * along.x * along.x;
  patch.spread[1] = m * along.y * along.y;
  patch.spread[3] = m * along.x * along.y;
  return true;
}

Lowest lowest_from(std::span<const Vec3d> loop, const Vec3d& m, std::uint32_t vertex) {
  const auto count = static_cast<std::uint32_t>(loop.size());
  const auto after = [&](std::uint32_t i) { return i + 1 == count ? 0 : i + 1; };
  const auto before = [&](std::uint32_t i) { return (i == 0 ? count : i) - 1; };
  const auto height = [&](std::uint32_t i) { return dot_xy(m, loop[i]); };
  std::uint32_t at = vertex;
  double here = height(at), ahead = height(after(at)), behind = height(before(at));
  while (ahead < here) {
    at = after(at);
    behind = here;
    here = ahead;
    ahead = height(after(at));
  }
  while (behind < here) {
    at = before(at);
    ahead = here;
    here = behind;
    behind = height(before(at));
  }
  return {at, here, std::min(ahead, behind) - here};
}

Contact disc_loop(double radius, const Loop& p, double size) {
  double best = -infinity;
  Vec3d n{};
  for (std::uint32_t i = 0; i < p.size(); ++i) {
    const Vec3d out = p.normal(i);
    if (const double f = -p.height(i, out); f > best) best = f, n = -out;
  }
  Vec3d on_b = best * n;
  if (best > 0) {
    double least = infinity;
    Vec3d nearest{}, towards;
    for (std::uint32_t i = 0; i < p.size(); ++i) {
      const Vec3d v = p.vertex(i);
      if (const double square = dot_xy(v, v); square < least) least = square, nearest = v;
    }
    if (length_and_direction(nearest, towards) > 0 && towards.z == 0) {
      double f = infinity;
      for (std::uint32_t i = 0; i < p.size(); ++i) f = std::min(f, dot_xy(towards, p.vertex(i)));
      if (f > best) best = f, n = towards, on_b = nearest;
    }
  }
  if (!(std::abs(best) <= 8)) return refused();
  return answer(best - radius, 0, size, n, radius * n, on_b);
}

namespace {

class EllipseLoop {
 public:
  EllipseLoop(const Placed<shapes::Ellipse>& a, const Loop& p, double size) : e_(in_space(a)), p_(p), size_(size) {
    const double small = std::min(a.a, a.b);
    least_ = small;
    least_curvature_radius_ = small * (small / std::max(a.a, a.b));
  }

  Contact solve() {
    const std::uint32_t side = sides();
    if (!(std::abs(best_) <= 16)) return refused();
    if (!over_side(side)) all_vertices();
    return answer(best_, excess_, size_, n_, on_a_, on_b_);
  }

 private:
  Vec3d support(const Vec3d& n) const { return scaled(e_.semi_axes, transposed_times(e_.rotation, n)); }

  // The best of the sides' normals.
  std::uint32_t sides() {
    std::uint32_t top = 0, best_side = 0;
    double highest = -infinity;  // of the ellipse's centre over a side
    for (std::uint32_t i = 0; i < p_.size(); ++i)
      if (const double h = -p_.height(i, p_.normal(i)); h > highest) highest = h, top = i;
    const auto evaluate = [&](std::uint32_t i) {
      const Vec3d out = p_.normal(i), u = support(-out);
      const double reach = norm(u), f = -p_.height(i, out) - reach;
      if (!(f > best_ || (f == best_ && i < best_side))) return;
      best_ = f;
      best_side = i;
      n_ = -out;
      on_a_ = e_.rotation * scaled(e_.semi_axes, u * (1 / reach));
      on_b_ = on_a_ + f * n_;
    };
    evaluate(top);
    const double margin = 16 * epsilon * size_;
    for (std::uint32_t i = 0; i < p_.size(); ++i)
      if (i != top && !(-p_.height(i, p_.normal(i)) - least_ + margin < best_)) evaluate(i);
    return best_side;
  }

  // Is this the greatest separation? The ellipse is a convex body K and a ball of its least radius of curvature ρ.
  // While gap + ρ > 0, K is apart from the polygon: nearest to it over the side, if its lowest point lies over the
  // side. Else a vertex at an end of the side bounds all of f by its own greatest φ_v, which f reaches where no other
  // vertex is lower.
  bool over_side(std::uint32_t side) {
    const Vec3d along{n_.y, -n_.x, 0};
    const double u = dot_xy(along, on_a_), from = dot_xy(along, p_.vertex(side)),
                 to = dot_xy(along, p_.vertex(p_.next(side)));
    if (from <= u && u <= to) return best_ + least_curvature_radius_ > 16 * epsilon * size_;
    const std::uint32_t end = u < from ? side : p_.next(side);
    const Vec3d v = p_.vertex(end), y = transposed_times(e_.rotation, v);
    const EllipsoidFoot foot = nearest_on_ellipsoid(e_.semi_axes, y);
    const Vec3d normal = e_.rotation * foot.normal;
    if (lowest_from(p_.vertices, p_.in_frame(normal), end).vertex != end) return false;
    try_foot(foot, normal, y, v, dot_xy(normal, v));
    return true;
  }

  bool try_foot(const EllipsoidFoot& foot, const Vec3d& normal, const Vec3d& y, const Vec3d& v, double lowest) {
    const double f = lowest - norm(support(normal));
    if (!(f > best_)) return false;
    best_ = f;
    n_ = normal;
    on_a_ = e_.rotation * foot.foot;
    on_b_ = v;
    excess_ = foot.residual * norm(y);
    return true;
  }

  // The best normal is that of a foot, with another vertex the lowest along it: as good as a direction next to it
  // (bodies about one centre). Then the point of the polygon is the one across the gap, where there is one.
  void across() {
    const Vec3d opposite = on_a_ + best_ * n_;
    for (std::uint32_t i = 0; i < p_.size(); ++i) {
      const Vec3d out = p_.normal(i);
      if (dot_xy(out, opposite) - p_.height(i, out) > 16 * epsilon * size_) return;
    }
    on_b_ = opposite;
  }

  // The sides' normals hold the maximum where they bound a vertex cone; inside the cone it is the normal of a foot.
  void all_vertices() {
    for (std::uint32_t i = 0; i < p_.size(); ++i) {
      const Vec3d v = p_.vertex(i), y = transposed_times(e_.rotation, v);
      EllipsoidFoot feet[2] = {nearest_on_ellipsoid(e_.semi_axes, y), {}};
      const int count = second_foot(e_.semi_axes, y, feet[1]) ? 2 : 1;
      for (int k = 0; k < count; ++k) {
        const Vec3d normal = e_.rotation * feet[k].normal;
        double lowest = dot_xy(normal, v);
        std::uint32_t at = i;
        for (std::uint32_t j = 0; j < p_.size(); ++j)
          if (const double h = dot_xy(normal, p_.vertex(j)); h < lowest) lowest = h, at = j;
        if (try_foot(feet[k], normal, y, p_.vertex(at), lowest) && at != i) across();
      }
    }
  }

  const Placed<shapes::Ellipsoid> e_;
  const Loop& p_;
  double size_, least_, least_curvature_radius_;
  double best_ = -infinity, excess_ = 0;
  Vec3d n_{}, on_a_{}, on_b_{};
};

}  // namespace

Contact ellipse_loop(const Placed<shapes::Ellipse>& a, const Loop& b, double size) {
  return EllipseLoop(a, b, size).solve();
}

}  // namespace contact
