#include "libcontact/methods/overlap_forms.h"

#include <algorithm>
#include <cmath>

#include "libcontact/methods/depth_spread.h"

namespace contact {

namespace {

struct Flat {
  double x, y;
};
double turn(const Flat& a, const Flat& b) { return a.x * b.y - a.y * b.x; }

}  // namespace

// K is the tip and the rim about its foot. Other is convex: it holds the rim where its face does, and the tip where
// that is in the cone from the face to a point inside.
bool corner_alone(const PolyhedronPair& pair, std::uint32_t face, std::uint32_t vertex, double reach,
                  CornerOverlap& out) {
  const shapes::Polyhedron &self = *pair.self, &other = *pair.other;
  const std::uint32_t first = self.first_spoke[vertex], count = self.first_spoke[vertex + 1] - first;
  if (count >= CornerOverlap::cap) return false;
  const HalfSpace keep = face_of_other(pair, face);
  const auto height = [&](const Vec3d& x) { return dot(keep.n, pair.self_scale * x) - keep.level; };
  const Vec3d& tip = self.vertices[vertex];
  const Vec3d x = pair.self_scale * tip;
  const double here = height(tip);
  out.corner[0] = x;
  double least = HUGE_VAL, square = 0;
  for (std::uint32_t k = 0; k < count; ++k) {
    const Vec3d& to = self.spokes[first + k].to;
    const double there = height(to);
    least = std::min(least, there);
    const Vec3d arm = (here / (here - there)) * (pair.self_scale * to - x);
    out.corner[k + 1] = x + arm;
    square = std::max(square, dot(arm, arm));
  }
  constexpr double within = 1 - 0x1p-20;
  const double border = within * (reach * reach);
  if (!(here < 0 && least > 0 && square < border)) return false;
  const Vec3d inside = pair.other_to_self * (pair.other_scale * core_ball(other).centre) + pair.offset - x;
  const double deeper = -dot(keep.n, inside);
  if (!(deeper > 0 && (dot(inside, inside) - deeper * deeper) * (here * here) < border * (deeper * deeper)))
    return false;
  out.count = count + 1;
  out.n = -keep.n;
  out.depth = -here;
  return true;
}

// Each end of the one edge's part lies in a face at the other edge where it is in the triangle over that edge.
bool edges_alone(const PolyhedronPair& pair, const EdgesMeeting& m, std::uint32_t edge_of_self,
                 std::uint32_t edge_of_other, EdgesOverlap& out) {
  if (!m.found) return false;
  const double ee = dot(m.e, m.e), ff = dot(m.f, m.f), ef = dot(m.e, m.f), we = dot(m.w, m.e), wf = dot(m.w, m.f),
               ww = dot(m.w, m.w), tent_e = pair.self->edge_tent[edge_of_self] * ee,
               tent_f = pair.other->edge_tent[edge_of_other] * ff;
  // A point at `place` along an edge and its distance, squared, from the other one's start.
  const auto held = [](double place, double square, double length, double tent) {
    const double along = place * place * length, end = std::min(place, 1 - place);
    return end > 0 && (square - along) + 0x1p-40 * (square + along) < tent * (end * end);
  };
  const double per_ee = 1 / ee, per_ff = 1 / ff;
  bool alone = true;
  for (int i = 0; i < 2; ++i) {
    const double s = m.s[i], t = m.t[i];
    alone = alone && s > 0 && s < 1 && t > 0 && t < 1 &&
            held((we + t * ef) * per_ee, ww + t * (2 * wf + t * ff), ee, tent_e) &&
            held((s * ef - wf) * per_ff, ww - s * (2 * we - s * ee), ff, tent_f);
  }
  if (!alone) return false;
  m.corners(out.corner);
  out.normal[0] = m.of_a[0];
  out.normal[1] = m.of_a[1];
  out.normal[2] = m.of_b[m.low];
  out.normal[3] = m.of_b[m.high];
  return true;
}

bool corner_slope(std::span<const Vec3d> corners, const Vec3d& n, double depth, double size, DepthSlope& out) {
  const std::size_t count = corners.size() - 1;
  const Vec3d tip = corners[0];
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

bool edges_slope(const Vec3d* x, const Vec3d* normal, double size, DepthSlope& out) {
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
      (alpha - 0.5) * of_other(normal[3], alpha + 0.5) - (alpha + 0.5) * of_other(normal[2], alpha - 0.5);
  const Vec3d turn_beta = (beta + 0.5) * of_self(normal[0], beta - 0.5) - (beta - 0.5) * of_self(normal[1], beta + 0.5);
  const Vec3d couple = (2 * gain * share * depth * depth) * (alpha * turn_alpha + beta * turn_beta);  // (4)
  out.force = gain * n;
  out.centroid = 0.5 * (middle_e + middle_f);
  out.moment = couple + cross(middle_e - alpha * e - out.centroid, out.force);
  out.volume = twice * depth * (1.0 / 6);
  out.tt = out.uu = out.tu = 0;
  return true;
}

}  // namespace contact
