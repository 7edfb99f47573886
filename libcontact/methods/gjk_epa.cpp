#include "libcontact/methods/gjk_epa.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "libcontact/methods/convex_search.h"
#include "libcontact/scale.h"

namespace contact {

namespace {

using Corner = ConvexPair::Corner;

constexpr int step_limit = 200;
constexpr double good_width = 1e-6;  // of the interval, over the smaller circumradius: to be content

// Weights of the point of the plane, line or space through the corners of `mask` that is nearest to the origin. False
// when one is not positive, or the corners are not independent.
bool weights(const ConvexPair::Corner (&corner)[4], int mask, double (&weight)[4]) {
  int index[4], n = 0;
  for (int i = 0; i < 4; ++i)
    if (mask >> i & 1) index[n++] = i;
  const Vec3d& p = corner[index[0]].at;
  double w[4] = {1, 0, 0, 0};
  if (n == 2) {
    const Vec3d e = corner[index[1]].at - p;
    const double inverse = 1 / dot(e, e);
    w[1] = -dot(p, e) * inverse;
    w[1] -= dot(p + w[1] * e, e) * inverse;  // what rounding left along e
    w[0] = 1 - w[1];
  } else if (n == 3) {
    const Vec3d e = corner[index[1]].at - p, f = corner[index[2]].at - p, normal = cross(e, f);
    const double inverse = 1 / dot(normal, normal);
    Vec3d v = p;
    for (int pass = 0; pass < 2; ++pass) {
      w[1] -= dot(cross(v, f), normal) * inverse;
      w[2] -= dot(cross(e, v), normal) * inverse;
      v = p + w[1] * e + w[2] * f;
    }
    w[0] = 1 - w[1] - w[2];
  } else if (n == 4) {
    const Vec3d e = corner[1].at - p, f = corner[2].at - p, g = corner[3].at - p;
    const double inverse = -1 / dot(e, cross(f, g));
    w[1] = dot(p, cross(f, g)) * inverse;
    w[2] = dot(p, cross(g, e)) * inverse;
    w[3] = dot(p, cross(e, f)) * inverse;
    w[0] = 1 - w[1] - w[2] - w[3];
  }
  for (int i = 0; i < 4; ++i) weight[i] = 0;
  for (int i = 0; i < n; ++i) {
    if (!(w[i] > 0 && w[i] <= 1)) return false;
    weight[index[i]] = w[i];
  }
  return true;
}

}  // namespace

void Simplex::reduce() {
  double best[4] = {1, 0, 0, 0}, w[4], least = std::numeric_limits<double>::infinity();
  for (int mask = (1 << count) - 1; mask > 0; --mask) {
    if (!weights(p, mask, w)) continue;
    if (std::popcount(static_cast<unsigned>(mask)) == full) {
      std::copy(w, w + 4, best);
      break;
    }
    Vec3d v{};
    for (int i = 0; i < count; ++i) v += w[i] * p[i].at;
    if (const double square = dot(v, v); square < least) {
      least = square;
      std::copy(w, w + 4, best);
    }
  }
  int kept = 0;
  for (int i = 0; i < count; ++i)
    if (best[i] > 0) {
      p[kept] = p[i];
      weight[kept++] = best[i];
    }
  count = kept;
}

namespace {

// Of a simplex that holds the origin, to rounding, makes a full one that does. False when the bodies touch: K ends at
// the origin.
bool enclose(ConvexSearch& s) {
  Simplex& x = s.near;
  while (x.count < x.full) {
    if (x.count == 1 || s.lower >= -s.rounding()) return false;
    const Vec3d e = x.p[1].at - x.p[0].at;
    Vec3d n, across, other;
    if (x.count == 3) {
      length_and_direction(cross(e, x.p[2].at - x.p[0].at), n);
    } else if (x.full == 3) {
      length_and_direction({-e.y, e.x, 0}, n);
    } else {
      length_and_direction(e, across);
      tangent_frame(across, n, other);
    }
    x.p[x.count++] = s.probe(n);
  }
  return !(s.lower >= -s.rounding());
}

// The direction from the nearest point v to the origin. Of a triangle, or a segment in the plane, it is the normal,
// which keeps its digits as v vanishes.
Vec3d to_origin(const Simplex& s, const Vec3d& v, double distance) {
  const Vec3d e = s.p[1].at - s.p[0].at;
  Vec3d n;
  if (s.count < s.full - 1) return v * (-1 / distance);
  if (!(length_and_direction(s.full == 3 ? Vec3d{-e.y, e.x, 0} : cross(e, s.p[2].at - s.p[0].at), n) > 0))
    return v * (-1 / distance);
  return dot(n, v) > 0 ? -n : n;
}

// The nearest point of the segment from the last one to a new corner: closer where that corner lies nearer along it.
Simplex towards(const Simplex& from, const Corner& w) {
  Simplex s = from;
  s.p[0] = {from.nearest(), from.on_a()};
  s.p[1] = w;
  s.count = 2;
  s.reduce();
  return s;
}

ConvexMeasure measure(const ConvexPair& pair) {
  ConvexSearch s(pair);
  Vec3d n;
  if (!(length_and_direction(-pair.inside(), n) > 0)) n = {1, 0, 0};
  s.near.p[0] = s.probe(n);
  s.near.count = 1;
  s.upper = norm(s.near.nearest());
  double outside = s.upper;  // of the last simplex that does not hold the origin
  while (s.upper > s.rounding() && !s.closed() && s.steps < step_limit) {
    const Corner w = s.probe(to_origin(s.near, s.near.nearest(), s.upper));
    if (s.closed()) break;
    Simplex next = s.near;
    next.p[next.count++] = w;
    next.reduce();
    if (next.count == next.full) {
      s.near = next;
      s.upper = 0;
      break;
    }
    if (!(norm(next.nearest()) < s.upper)) next = towards(s.near, w);
    const double closer = norm(next.nearest());
    if (!(closer < s.upper)) break;
    s.near = next;
    s.upper = outside = closer;
  }
  if (!(s.upper > s.rounding()) && enclose(s)) expand(s, s.near);
  if (!s.finished()) finish_on_features(s);
  if (!s.finished() && !(pair.a.has_corners() && pair.b.has_corners())) finish_on_curvature(s);

  // A sliver may hold the origin to rounding alone: a direction that keeps the bodies apart knows better.
  if (s.upper < s.lower - 4 * s.rounding()) s.upper = outside;

  ConvexMeasure m;
  m.normal = s.normal;
  m.iterations = s.steps;
  m.upper = s.upper - pair.margins();  // (1), (2)
  m.overlap = pair.margins() - s.lower;
  const double enough = std::fmax(pair.tolerance > 0 ? pair.tolerance : good_width, good_width) * pair.small;
  m.converged = s.width() <= std::fmax(enough, 64 * s.rounding());
  const Vec3d on_a = s.near.on_a(), on_b = on_a - s.near.nearest();
  m.point = 0.5 * (on_a + on_b + (pair.a.margin - pair.b.margin) * m.normal);
  m.meets = true;
  return m;
}

}  // namespace

Contact GjkEpa::answer(const ConvexBody& a, const ConvexBody& b, const Vec3d& offset, const Options& options) {
  return by_convex_method(a, b, offset, options, measure);
}

}  // namespace contact
