#include "libcontact/methods/planar_slope.h"

#include <cmath>
#include <utility>

namespace contact {

namespace {

bool is_of_b(std::uint32_t side) { return side == PlanarOverlap::of_b || side == PlanarOverlap::cut_of_b; }
// Of a's border the end counts, of b's the start.
double end_of_border(std::uint32_t side) {
  return side == PlanarOverlap::of_a ? 1 : side == PlanarOverlap::of_b ? -1 : 0;
}

}  // namespace

bool PlanarOverlap::slope(double size, DepthSlope& out) const {
  if (corners_.size() < 3) return false;
  const Vec3d apex = corners_[0].x;
  const auto out_of = [](const Vec3d& along) { return Vec3d{along.y, -along.x, 0}; };
  Vec3d of[4]{};
  each_side([&](const At& e) { of[e.side] += out_of(e.to - e.from); });
  const Vec3d surface = 0.5 * (of[of_a] - of[of_b]);
  const double section = norm(surface);
  if (!(section > least_depth * size)) return false;
  const Vec3d n = surface * (1 / section), t{-n.y, n.x, 0};

  // ∫1, ∫x, ∫xx about the apex, along t and n; triangles from each piece's first corner.
  double area = 0, ft = 0, fn = 0, tt = 0, tn = 0, nn = 0;
  each_side([&](const At& at) {
    const Vec3d p = at.from - at.first, q = at.to - at.first, o = at.first - apex;
    const double w = 0.5 * (p.x * q.y - p.y * q.x);
    const double a = dot(t, o), b = dot(t, o + p), c = dot(t, o + q), d = dot(n, o), e = dot(n, o + p),
                 f = dot(n, o + q);
    area += w;
    ft += w * (a + b + c) / 3;
    fn += w * (d + e + f) / 3;
    tt += w * ((a + b + c) * (a + b + c) + a * a + b * b + c * c) / 12;
    nn += w * ((d + e + f) * (d + e + f) + d * d + e * e + f * f) / 12;
    tn += w * ((a + b + c) * (d + e + f) + a * d + b * e + c * f) / 12;
  });
  if (!(area > 0)) return false;
  const double ct = ft / area, cn = fn / area;
  tt = tt / area - ct * ct;
  nn = nn / area - cn * cn;
  tn = tn / area - ct * cn;
  if (!(tt > 0)) return false;
  const double beta = tn / tt, variance = nn - beta * tn;  // (2)
  if (!(variance > 0)) return false;
  const Vec3d centre = t * ct + n * cn;
  const auto residual = [&](const Vec3d& x) { return dot(n, x - centre) - beta * dot(t, x - centre); };

  out.depth = std::sqrt(12 * variance);  // (1)
  if (!(out.depth > least_depth * size)) return false;
  const double scale = out.depth / (2 * variance * area), turn = beta * out.depth / section;
  out.force = out.moment = {};
  const auto press = [&](double weight, const Vec3d& at, const Vec3d& normal) {
    out.force -= weight * normal;
    out.moment -= weight * cross(at, normal);
  };
  each_side([&](const At& e) {
    const Vec3d x = e.from - apex, y = e.to - apex, ahead = out_of(y - x);
    const bool with_b = is_of_b(e.side), before_with_b = is_of_b(e.before);
    if (with_b) {  // (4)
      const double r = residual(x), q = residual(y);
      press(scale * ((3 * r * r + 2 * r * q + q * q) / 12 - 0.5 * variance), x - centre, ahead);
      press(scale * ((3 * q * q + 2 * r * q + r * r) / 12 - 0.5 * variance), y - centre, ahead);
    }
    // An end of the chord: by how much it moves with this corner.
    const double share = 0.5 * (end_of_border(e.before) - end_of_border(e.side));
    if (share == 0) return;
    if (with_b == before_with_b) {  // where a cut of b begins
      if (with_b) press(-share * turn, x - centre, n);
      return;
    }
    // The outlines cross here.
    const Vec3d behind = out_of(e.from - e.previous);
    const double length = norm(ahead), before = norm(behind);
    if (!(length > 0 && before > 0)) return;
    const Vec3d u = ahead * (1 / length), v = behind * (1 / before);
    const Vec3d &self = with_b ? v : u, &other = with_b ? u : v;
    const double sine = norm(cross(self, other));
    if (sine > 0) press(std::abs(share) * (turn * dot(t, self) / sine), x - centre, other);
  });
  out.centroid = apex + centre;
  return true;
}

bool outline_depth(const Corners& region, double smaller, OverlapDepth& out) {
  if (region.size() < 3) return false;
  PlanarOverlap overlap;
  overlap.add(region, [](std::uint32_t side) { return side; });
  DepthSlope slope;
  if (!overlap.slope(smaller, slope)) return false;
  out = line_of_action(slope);
  return true;
}

bool outlines_depth(const Loop& a, const Loop& b, double smaller, OverlapDepth& out) {
  Corners buffer[2], *region = buffer, *other = buffer + 1;
  for (std::uint32_t i = 0; i < a.size(); ++i) region->push_back({a.vertex(i), PlanarOverlap::of_a});
  for (std::uint32_t k = 0; k < b.size() && region->size() >= 3; ++k) {
    const Vec3d n = b.normal(k);
    cut(*region, n, b.height(k, n), PlanarOverlap::of_b, *other);
    std::swap(region, other);
  }
  return outline_depth(*region, smaller, out);
}

}  // namespace contact
