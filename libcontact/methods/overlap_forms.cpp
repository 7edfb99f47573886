#include "libcontact/methods/overlap_forms.h"

#include <cmath>

#include "libcontact/methods/depth_spread.h"

namespace contact {

namespace {

struct Flat {
  double x, y;
};
double turn(const Flat& a, const Flat& b) { return a.x * b.y - a.y * b.x; }

}  // namespace

bool corner_slope(const OverlapBody& body, double size, DepthSlope& out) {
  const auto corners = body.corners();
  const std::size_t count = corners.size() - 1;
  const Vec3d n = -body.faces().back().normal, tip = corners[0];
  const double depth = body.depth();
  Vec3d t, u;
  tangent_frame(n, t, u);
  // Of the polygon from its first corner, which is at `first` from the tip's foot.
  const auto flat = [&](const Vec3d& x) { return Flat{dot(t, x), dot(u, x)}; };
  const Vec3d origin = corners[1];
  const Flat first = flat(origin - tip);
  double area = 0, x = 0, y = 0, xx = 0, yy = 0, xy = 0;
  Flat p = flat(corners[2] - origin);
  for (std::size_t i = 3; i <= count; ++i) {
    const Flat q = flat(corners[i] - origin);
    const double twice = turn(p, q), sx = p.x + q.x, sy = p.y + q.y;
    area += twice;
    x += twice * sx;
    y += twice * sy;
    xx += twice * (sx * sx + p.x * p.x + q.x * q.x);
    yy += twice * (sy * sy + p.y * p.y + q.y * q.y);
    xy += twice * (sx * sy + p.x * p.y + q.x * q.y);
    p = q;
  }
  if (!(area > 2 * least_depth * least_depth * size * size)) return false;
  const double per_area = 1 / area;
  const Flat g{per_area * x * (1.0 / 3), per_area * y * (1.0 / 3)};
  xx = per_area * xx * (1.0 / 12) - g.x * g.x;
  yy = per_area * yy * (1.0 / 12) - g.y * g.y;
  xy = per_area * xy * (1.0 / 12) - g.x * g.y;
  const double determinant = xx * yy - xy * xy;
  if (!(determinant > 0x1p-100 * (xx * yy))) return false;
  const double inverse = 1 / determinant;
  const Flat w{first.x + g.x, first.y + g.y}, m{inverse * (yy * w.x - xy * w.y), inverse * (xx * w.y - xy * w.x)};
  const double share = 1 / (1 + (1.0 / 16) * (w.x * m.x + w.y * m.y)), gain = std::sqrt(0.45 * share);  // (1)
  out.depth = gain * depth;
  if (!(out.depth > least_depth * size)) return false;
  // r over the polygon, of depth 1: less what its middle has, along β.
  const Flat beta{-(1.0 / 16) * share * m.x, -(1.0 / 16) * share * m.y};
  const double variance = (3.0 / 80) * share, middle = -0.25 * share;
  const auto residual = [&](const Flat& at) { return middle - beta.x * (at.x - g.x) - beta.y * (at.y - g.y); };
  double sum = 0, along_x = 0, along_y = 0;
  const double at_first = residual({0, 0});
  p = flat(corners[2] - origin);
  double at_p = residual(p);
  for (std::size_t i = 3; i <= count; ++i) {
    const Flat q = flat(corners[i] - origin);
    const double at_q = residual(q);
    const CornerWeights weight(turn(p, q), at_first, at_p, at_q, variance);
    sum += weight.sum();
    along_x += weight.b * p.x + weight.c * q.x;
    along_y += weight.b * p.y + weight.c * q.y;
    p = q;
    at_p = at_q;
  }
  if (!(sum > 0)) return false;
  const double over = 1 / sum, square = depth * depth;
  const Vec3d at = origin + (over * along_x + square * beta.x) * t + (over * along_y + square * beta.y) * u;  // (2)
  out.force = gain * n;
  out.centroid = origin + (g.x - 0.25 * w.x) * t + (g.y - 0.25 * w.y) * u + (0.25 * depth) * n;
  out.moment = cross(at - out.centroid, out.force);
  out.volume = area * depth * (1.0 / 6);
  out.tt = 0.6 * xx + (3.0 / 80) * w.x * w.x;
  out.uu = 0.6 * yy + (3.0 / 80) * w.y * w.y;
  out.tu = 0.6 * xy + (3.0 / 80) * w.x * w.y;
  out.t = t;
  out.u = u;
  return true;
}

bool edges_slope(const OverlapBody& body, double size, DepthSlope& out) {
  const auto x = body.corners();
  const auto faces = body.faces();
  const Vec3d e = x[1] - x[0], f = x[3] - x[2], across = cross(f, e);
  const double twice = norm(across);  // of the vector area
  if (!(twice > 2 * least_depth * least_depth * size * size)) return false;
  const double per_twice = 1 / twice;
  const Vec3d n = per_twice * across, middle_e = 0.5 * (x[0] + x[1]), middle_f = 0.5 * (x[2] + x[3]);
  const Vec3d between = middle_e - middle_f, fn = cross(f, n), g = cross(n, e);
  const double depth = dot(n, between), per_ef = -per_twice;  // e·(f × n) = −|f × e| = f·(n × e)
  const double alpha = per_ef * dot(between, fn), beta = -per_ef * dot(between, g);
  const double share = 1 / (1 + 2 * (alpha * alpha + beta * beta)), gain = std::sqrt(0.6 * share);  // (3)
  out.depth = gain * depth;
  if (!(out.depth > least_depth * size)) return false;
  // With u = m·n/(m·e) of other's faces, along e from the perpendicular over −δ, and v = m·n/(m·f) of self's:
  //   dα = δ ((α − ½) du₁ − (α + ½) du₀),  dβ = δ ((β + ½) dv₀ − (β − ½) dv₁)
  //   n turns with f: m·dn = −(m·g)/(f·g) θ·(f × n)
  const double per_depth = 1 / depth;
  const auto of_other = [&](const Vec3d& m, double place) {
    return (1 / dot(m, e)) * (cross(m, n) - (per_ef * dot(m, g)) * fn + (place * per_depth) * cross(m, e));
  };
  const auto of_self = [&](const Vec3d& m, double place) {
    return (-1 / dot(m, f)) * ((per_ef * dot(m, g)) * fn + (place * per_depth) * cross(f, m));
  };
  const Vec3d turn_alpha =
      (alpha - 0.5) * of_other(faces[3].normal, alpha + 0.5) - (alpha + 0.5) * of_other(faces[2].normal, alpha - 0.5);
  const Vec3d turn_beta =
      (beta + 0.5) * of_self(faces[0].normal, beta - 0.5) - (beta - 0.5) * of_self(faces[1].normal, beta + 0.5);
  const Vec3d couple = (2 * gain * share * depth * depth) * (alpha * turn_alpha + beta * turn_beta);  // (4)
  out.force = gain * n;
  out.centroid = 0.5 * (middle_e + middle_f);
  out.moment = couple + cross(middle_e - alpha * e - out.centroid, out.force);
  out.volume = twice * depth * (1.0 / 6);
  out.tt = out.uu = out.tu = 0;
  return true;
}

}  // namespace contact
