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
  Corner p = in[in.size() - 1];
  double hp = dot(n, p.x) - height;
  for (const Corner& q : in) {
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

Contact disc_outline(double radius, const Outline& p, double size) {
  double best = -infinity;
  Vec3d n{};
  for (std::size_t i = 0; i < p.size(); ++i)
    if (const double f = -p.height(i); f > best) best = f, n = -p.normal(i);
  Vec3d on_b = best * n;
  if (best > 0) {
    double least = infinity;
    Vec3d nearest{};
    for (std::size_t i = 0; i < p.size(); ++i)
      if (const double square = dot(p.vertex(i), p.vertex(i)); square < least) least = square, nearest = p.vertex(i);
    std::size_t index = 0;
    if (Vec3d towards; length_and_direction(nearest, towards) > 0 && towards.z == 0) {
      if (const double f = p.lowest(towards, index); f > best) best = f, n = towards, on_b = p.vertex(index);
    }
  }
  if (!(std::abs(best) <= 8)) return refused();
  return answer(best - radius, 0, size, n, radius * n, on_b);
}

Contact ellipse_outline(const Placed<shapes::Ellipse>& a, const Outline& p, double size) {
  const Placed<shapes::Ellipsoid> e = in_space(a);
  const auto support = [&](const Vec3d& n) { return scaled(e.semi_axes, transposed_times(e.rotation, n)); };
  double best = -infinity, excess = 0;
  Vec3d n{}, on_a{}, on_b{};
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Vec3d u = support(-p.normal(i));
    const double reach = norm(u), f = -p.height(i) - reach;
    if (!(f > best)) continue;
    best = f;
    n = -p.normal(i);
    on_a = e.rotation * scaled(e.semi_axes, u * (1 / reach));
    on_b = on_a + f * n;
  }
  if (!(std::abs(best) <= 16)) return refused();
  // The edge normals hold the maximum where they bound a vertex cone; inside the cone it is the normal of a foot.
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Vec3d &v = p.vertex(i), y = transposed_times(e.rotation, v);
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
  return answer(best, excess, size, n, on_a, on_b);
}

Contact outline_pair(const Outline& a, const Outline& b, double size, const Options& options) {
  double best = -infinity;
  Vec3d n{}, on_a{}, on_b{};
  std::size_t index = 0;
  // A vertex of one body over an edge of the other, within the edge's ends where edges are parallel. True: apart for
  // sure, and nothing more is asked.
  const auto take = [&](const Outline& edges, const Outline& other, bool of_a) {
    for (std::size_t i = 0; i < edges.size(); ++i) {
      const Vec3d& out = edges.normal(i);
      const double f = other.lowest(out, index) - edges.height(i);
      if (!(f > best)) continue;
      best = f;
      const Vec3d &v = other.vertex(index), &p = edges.vertex(i), &q = edges.vertex(edges.next(i));
      const Vec3d along{-out.y, out.x, 0};
      const double u = dot(along, v), inside = std::clamp(u, dot(along, p), std::max(dot(along, p), dot(along, q)));
      const Vec3d at = v + (inside - u) * along, under = at - f * out;
      n = of_a ? out : -out;
      on_a = of_a ? under : at;
      on_b = of_a ? at : under;
      if (options.overlap_only && f > proof_margin(size)) return true;
    }
    return false;
  };
  if (take(a, b, true) || take(b, a, false)) return best <= 8 ? separation_proof(best, size, n, 1) : refused();
  if (best > -planar_half_width * size) {
    double least = infinity;
    std::size_t ia = 0, ib = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
      for (std::size_t j = 0; j < b.size(); ++j) {
        const Vec3d between = b.vertex(j) - a.vertex(i);
        if (const double square = dot(between, between); square < least) least = square, ia = i, ib = j;
      }
    const Vec3d &va = a.vertex(ia), &vb = b.vertex(ib);
    if (Vec3d towards; length_and_direction(vb - va, towards) > 0 && towards.z == 0) {
      const double f = b.lowest(towards, index) + a.lowest(-towards, index);
      if (f > best) best = f, n = towards, on_a = va, on_b = vb;
    }
  }
  if (!(std::abs(best) <= 8)) return refused();
  Contact c = answer(best, 0, size, n, on_a, on_b);
  if (!options.patch || !(best < 0)) return c;
  Corners buffer[2], *region = buffer, *other = buffer + 1;
  for (const Outline::Side& side : a.sides) region->push_back({side.vertex, 0});
  for (const Outline::Side& side : b.sides) {
    cut(*region, side.normal, side.height, 0, *other);
    std::swap(region, other);
  }
  AreaMoments moments;
  moments.add(*region);
  moments.patch(n, c.patch);
  return c;
}

}  // namespace contact
