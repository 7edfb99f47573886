#include "libcontact/methods/planar_ellipse.h"

#include <algorithm>
#include <cmath>

#include "libcontact/kernels/ellipse_search.h"
#include "libcontact/methods/method.h"
#include "libcontact/scale.h"

namespace contact {

namespace {

constexpr int step_limit = 100, cut_limit = 24;

struct Oval {
  double a, b;
  Vec3d x, y;  // directions of the axes, world

  // Support height h along n, support point and radius of curvature a²b²/h³ there.
  double support(const Vec3d& n, Vec3d& point, double& radius) const {
    const double u = a * dot(x, n), v = b * dot(y, n), h = std::sqrt(u * u + v * v);
    point = (a * (u / h)) * x + (b * (v / h)) * y;
    radius = (a / h) * (a / h) * (b / h) * b;
    return h;
  }
};

Oval oval(const Placed<shapes::Ellipse>& e, double down) {
  return {e.a * down, e.b * down, {e.cosine, e.sine, 0}, {-e.sine, e.cosine, 0}};
}

struct Pair {
  Oval a, b;
  Vec3d d;
  double size, least_radius;
};

struct Point {
  Vec3d n, xa, xb;
  double f, residual, ra, rb;
  double denominator() const { return ra + rb + f; }
};

Point evaluate(const Pair& pair, const Vec3d& n) {
  Point p;
  p.n = n;
  const double ha = pair.a.support(n, p.xa, p.ra), hb = pair.b.support(n, p.xb, p.rb);
  p.f = dot(n, pair.d) - (ha + hb);
  const Vec3d w = pair.d - (p.xa + p.xb);
  p.residual = n.x * w.y - n.y * w.x;
  return p;
}

struct Root {
  Point point;
  int iterations = 0;
  bool converged = false;
};

Root climb(const Pair& pair, const Vec3d& start) {
  const double unit = epsilon * pair.size;
  Root root{evaluate(pair, start), 0, false};
  double last = std::numeric_limits<double>::infinity();
  for (root.iterations = 1; root.iterations <= step_limit; ++root.iterations) {
    const Point& p = root.point;
    const double denominator = p.denominator();
    const double scale = denominator > 0 ? denominator : 2 * std::abs(denominator) + 0x1p-10 * (p.ra + p.rb);
    const double step = p.residual / scale, gain = p.residual * step, residual = std::abs(p.residual);
    const double curvature = (p.ra + p.rb) / (pair.least_radius > 0 ? pair.least_radius : 1);
    const bool settled = gain <= 64 * unit;
    if ((gain * std::max(1.0, curvature) <= unit && denominator > 0) || (settled && residual >= 0.5 * last) ||
        residual == 0) {
      root.converged = true;
      return root;
    }
    last = residual;
    double fraction = std::abs(step) > 1 ? 1 / std::abs(step) : 1;
    for (int cut = 0;; ++cut, fraction *= 0.25) {
      const double s = fraction * step;
      const Point next = evaluate(pair, normalized(Vec3d{p.n.x - s * p.n.y, p.n.y + s * p.n.x, 0}));
      if (next.f >= p.f - 2 * unit) {
        root.point = next;
        break;
      }
      if (cut == cut_limit) {
        root.converged = settled;
        return root;
      }
    }
  }
  return root;
}

// A stationary point after one more step s = r/(ρ_A + ρ_B + f), to second order. Gives its gap.
double refine(Point& p) {
  const double s = p.residual / p.denominator();
  const Vec3d t{-p.n.y, p.n.x, 0};
  p.xa += (p.ra * s) * t;
  p.xb += (p.rb * s) * t;
  p.n = normalized(p.n + s * t);
  return p.f + 0.5 * p.residual * s;
}
// Not where f hardly curves: there the step is long, and may lead away.
bool refines(const Pair& pair, const Point& p, bool unique) {
  if (!(p.denominator() > 0 && std::abs(p.residual) <= 0x1p-20 * p.denominator())) return false;
  if (unique) return true;
  Point next = p;
  refine(next);
  return evaluate(pair, next.n).f >= p.f - 2 * epsilon * pair.size;
}

// From many starts, as there may be more than one maximum. False for a rotation that is not finite, or zero.
bool deep(const Pair& pair, Root& best) {
  Vec3d start;
  length_and_direction(pair.d, start);
  if (start.z != 0) start = pair.a.b < pair.a.a ? pair.a.y : pair.a.x;  // one centre
  const Point first = evaluate(pair, start);
  if (!(std::abs(first.f) <= 16 && std::isfinite(first.residual))) return false;
  best = climb(pair, start);
  if (best.converged && best.point.f + pair.least_radius > 0) return true;
  // As f(−n) = f(n) − 2 n·d, the global maximum has n·d >= 0.
  constexpr double eighths[4][2] = {{1, 0},
                                    {0.92387953251128676, 0.38268343236508977},
                                    {0.70710678118654752, 0.70710678118654752},
                                    {0.38268343236508977, 0.92387953251128676}};
  int iterations = best.iterations;
  for (const Oval* body : {&pair.a, &pair.b})
    for (const auto& e : eighths)
      for (const bool quarter : {false, true}) {
        Vec3d n = quarter ? e[0] * body->y - e[1] * body->x : e[0] * body->x + e[1] * body->y;
        n = normalized(n);
        const Root root = climb(pair, dot(n, pair.d) < 0 ? -n : n);
        iterations += root.iterations;
        if (root.point.f > best.point.f) best = root;
      }
  best.iterations = iterations;
  return true;
}

// In units of `up`. False for a rotation that is not finite, or zero.
bool searched_deep(const Pair& pair, double ball, double up, Contact& c) {
  Root best{};
  if (!deep(pair, best)) return false;
  Point& p = best.point;
  const double allowance = rounding(pair.size), residual = std::abs(p.residual) + 2 * epsilon * (p.ra + p.rb);
  const double bound = 2 * (pair.least_radius + p.f);
  const bool unique = bound > 0;
  const double lower = p.f - allowance;
  double upper = std::min(unique ? p.f + residual * residual / bound : std::numeric_limits<double>::infinity(), ball);
  const bool proven = !best.converged || unique || ball <= p.f + allowance;
  const double gap = best.converged && refines(pair, p, unique) ? refine(p) : p.f;
  if (!proven) upper = gap;
  c = smooth_contact(gap, lower, std::max(upper, gap) + allowance, p.n, p.xa, pair.d - p.xb, up, best.iterations);
  if (!proven) c.certified = false;
  if (!best.converged) c.status = Status::not_converged;
  return true;
}

}  // namespace

Contact ellipse_pair(const Placed<shapes::Ellipse>& a, const Placed<shapes::Ellipse>& b, const Vec3d& offset,
                     const Options& options) {
  const double ra = std::max(a.a, a.b), rb = std::max(b.a, b.b), ca = std::min(a.a, a.b), cb = std::min(b.a, b.b);
  const double extent = max_abs(offset) + (ra + rb), limit = smallest_ratio * extent;
  if (!(extent_in_range(extent) && a.a >= limit && a.b >= limit && b.a >= limit && b.b >= limit)) return refused();
  const Scale unit = scale_of(extent);
  const auto flat = [&unit](const Placed<shapes::Ellipse>& e) {
    return FlatEllipse<double>{e.a * unit.down, e.b * unit.down, e.cosine, e.sine};
  };
  const Vec3d d = offset * unit.down;
  const EllipseAnswer<double> r = EllipseSearch<double>(flat(a), flat(b), {d.x, d.y}).solve({0, 0}, options.tolerance);
  if (r.solved != 0) return ellipse_contact(r, d, unit.up);
  const double distance = norm(d);
  const Pair pair{oval(a, unit.down), oval(b, unit.down), d, distance + (ra + rb) * unit.down,
                  (ca * (ca / ra) + cb * (cb / rb)) * unit.down};
  Contact c;
  if (!searched_deep(pair, distance - (ca + cb) * unit.down, unit.up, c)) return refused();
  return c;
}

}  // namespace contact
