// Moments of a union of balls. The section at height z is a union of discs, bounded by the arcs that no other disc
// covers; its moments are exact sums over these arcs,
//   ∫ over the union = Σ over arcs [triangle(O, p, q) + sector(c, p, q) − triangle(c, p, q)]                        (1)
// (O the origin, c the centre of the arc's circle, p and q its ends). Across the sections: adaptive quadrature between
// the heights at which circles begin, end or begin to meet.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "shapes/compound_parts.h"
#include "shapes/quadrature.h"

namespace shapes::compound {
namespace {

constexpr double pi = std::numbers::pi;

struct Disc {
  double x, y, r;
};
struct Section {  // ∫1, x, y, xx, yy, xy
  double one = 0, x = 0, y = 0, xx = 0, yy = 0, xy = 0;

  void add_triangle(double ax, double ay, double bx, double by, double cx, double cy, double sign) {
    const double area = sign * 0.5 * ((bx - ax) * (cy - ay) - (by - ay) * (cx - ax));
    const double sx = ax + bx + cx, sy = ay + by + cy;
    one += area;
    x += area / 3 * sx;
    y += area / 3 * sy;
    xx += area / 12 * (ax * ax + bx * bx + cx * cx + sx * sx);
    yy += area / 12 * (ay * ay + by * by + cy * cy + sy * sy);
    xy += area / 12 * (ax * ay + bx * by + cx * cy + sx * sy);
  }
  void add_sector(const Disc& d, double from, double to, double c0, double s0, double c1, double s1) {
    const double angle = to - from, r2 = d.r * d.r, r3 = r2 * d.r, r4 = r2 * r2;
    const double m0 = 0.5 * r2 * angle, mu = r3 / 3 * (s1 - s0), mv = r3 / 3 * (c0 - c1);
    const double half = 0.5 * angle, quarter = 0.5 * (s1 * c1 - s0 * c0);
    const double muu = 0.25 * r4 * (half + quarter), mvv = 0.25 * r4 * (half - quarter);
    const double muv = 0.125 * r4 * (s1 * s1 - s0 * s0);
    one += m0;
    x += mu + d.x * m0;
    y += mv + d.y * m0;
    xx += muu + 2 * d.x * mu + d.x * d.x * m0;
    yy += mvv + 2 * d.y * mv + d.y * d.y * m0;
    xy += muv + d.x * mv + d.y * mu + d.x * d.y * m0;
  }
  void add_arc(const Disc& d, double from, double to) {  // (1)
    const double c0 = std::cos(from), s0 = std::sin(from), c1 = std::cos(to), s1 = std::sin(to);
    const double px = d.x + d.r * c0, py = d.y + d.r * s0, qx = d.x + d.r * c1, qy = d.y + d.r * s1;
    add_triangle(0, 0, px, py, qx, qy, 1);
    add_sector(d, from, to, c0, s0, c1, s1);
    add_triangle(d.x, d.y, px, py, qx, qy, -1);
  }
};

using Interval = std::pair<double, double>;

// Angles of circle i that disc j covers; false: all of them.
bool cover(const Disc& i, const Disc& j, bool j_first, std::vector<Interval>& covered) {
  const double dx = j.x - i.x, dy = j.y - i.y, d2 = dx * dx + dy * dy, d = std::sqrt(d2);
  if (d >= i.r + j.r) return true;
  if (d <= std::fabs(i.r - j.r)) return !(j.r > i.r || (j.r == i.r && j_first));
  const double cosine = (d2 + i.r * i.r - j.r * j.r) / (2 * d * i.r);
  const double half = std::acos(std::clamp(cosine, -1.0, 1.0));
  double from = std::atan2(dy, dx) - half;
  if (from < -pi) from += 2 * pi;
  const double to = from + 2 * half;
  if (to <= pi) {
    covered.emplace_back(from, to);
  } else {
    covered.emplace_back(from, pi);
    covered.emplace_back(-pi, to - 2 * pi);
  }
  return true;
}

Section section_of(const std::vector<Disc>& discs) {
  Section sum;
  std::vector<Interval> covered;
  for (std::size_t i = 0; i < discs.size(); ++i) {
    covered.clear();
    bool seen = true;
    for (std::size_t j = 0; j < discs.size() && seen; ++j)
      if (j != i) seen = cover(discs[i], discs[j], j < i, covered);
    if (!seen) continue;
    std::sort(covered.begin(), covered.end());
    double at = -pi;
    for (const auto& [from, to] : covered) {
      if (from > at) sum.add_arc(discs[i], at, from);
      at = std::max(at, to);
    }
    if (at < pi) sum.add_arc(discs[i], at, pi);
  }
  return sum;
}

}  // namespace

Moments moments_of_balls(const std::vector<const Part*>& balls) {
  std::vector<double> breaks;
  double volume = 0;
  for (const Part* p : balls) {
    const double r = p->size.x;
    breaks.push_back(p->centre.z - r);
    breaks.push_back(p->centre.z + r);
    volume = std::max(volume, r * r * r);
    for (const Part* q : balls) {  // the circle in which two balls meet
      if (p >= q) continue;
      const Vec3d d = q->centre - p->centre;
      const double d2 = dot(d, d), t = 0.5 + 0.5 * (r * r - q->size.x * q->size.x) / d2, rho2 = r * r - t * t * d2;
      if (!(d2 > 0) || !(rho2 > 0)) continue;
      const double middle = p->centre.z + t * d.z, reach = std::sqrt(rho2 * std::max(0.0, 1 - d.z * d.z / d2));
      breaks.push_back(middle - reach);
      breaks.push_back(middle + reach);
    }
  }
  std::sort(breaks.begin(), breaks.end());

  std::vector<Disc> discs;
  const auto at_height = [&](double z) {
    discs.clear();
    for (const Part* p : balls) {
      const double h = z - p->centre.z, square = p->size.x * p->size.x - h * h;
      if (square > 0) discs.push_back({p->centre.x, p->centre.y, std::sqrt(square)});
    }
    const Section s = section_of(discs);
    return std::array<double, 10>{s.one, s.x, s.y, z * s.one, s.xx, s.yy, z * z * s.one, z * s.y, z * s.x, s.xy};
  };
  std::array<double, 10> tolerance, sum{};
  tolerance.fill(1e-11 * volume);
  double error = 0;
  const double whole = breaks.back() - breaks.front();
  for (std::size_t i = 0; i + 1 < breaks.size(); ++i)
    if (breaks[i] < breaks[i + 1]) error += integrate(at_height, breaks[i], breaks[i + 1], whole, tolerance, 20, sum);
  return {sum[0], {sum[1], sum[2], sum[3]}, {sum[4], sum[5], sum[6]}, {sum[7], sum[8], sum[9]}, error * tolerance[0]};
}

}  // namespace shapes::compound
