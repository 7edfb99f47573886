// Potential particles: (4)–(7) of constrained_minimisation.h.
#include <algorithm>
#include <cmath>

#include "libcontact/methods/constrained_minimisation.h"
#include "libcontact/methods/method.h"
#include "libcontact/methods/polyhedron_pair.h"
#include "libcontact/methods/potential.h"
#include "libcontact/methods/round_search.h"
#include "libcontact/scale.h"

namespace contact {

namespace {

// g = f + 1 of a body, half its gradient and half its second derivative at a point; axes of the query, units.
using Level = shapes::PotentialLevel<double>;

Level level(const BallAt& ball, const Vec3d& y) {
  Level l;
  const double inverse = 1 / ball.radius;
  const Vec3d u = inverse * y;
  l.g = dot(u, u);
  l.half_gradient = inverse * u;
  l.half_hessian = Mat3d::diagonal({inverse * inverse, inverse * inverse, inverse * inverse});
  return l;
}

// y from the body's origin.
Level level(const PotentialAt& p, const Vec3d& y) {
  const double inverse = 1 / p.scale;
  Level l = shapes::level_at<double>(*p.shape, inverse * transposed_times(p.rotation, y) - p.shape->centre);
  // In the geometry's units g has curvatures of the order of 1/size²: scaled to the query's.
  l.half_gradient = inverse * (p.rotation * l.half_gradient);
  l.half_hessian = p.rotation * (l.half_hessian * transposed(p.rotation));
  for (Vec3d& row : l.half_hessian.row) row *= inverse * inverse;
  return l;
}

struct Minimum {
  Vec3d x{};
  Level a, b;
  int steps = 0;
  bool converged = false;
};

// argmin of s g_A + (1 − s) g_B from m.x: Newton's method, the step halved until the function falls by a tenth of what
// it should; the last steps, whose fall is below rounding, in full.
template <class Pair>
bool minimise(const Pair& pair, double s, Minimum& m) {
  constexpr int step_limit = 60, last_steps = 3;
  const auto value = [&] { return s * m.a.g + (1 - s) * m.b.g; };
  for (int i = 0, last = 0; i < step_limit; ++i, ++m.steps) {
    const Vec3d gradient = s * m.a.half_gradient + (1 - s) * m.b.half_gradient;
    Mat3d h;
    for (int k = 0; k < 3; ++k) h.row[k] = s * m.a.half_hessian.row[k] + (1 - s) * m.b.half_hessian.row[k];
    const Vec3d step = shapes::potential::inverse(h) * gradient;
    const double fall = dot(step, gradient), before = value();
    if (!(fall > 0x1p-80 * before)) return fall >= 0 && before >= 0;
    const bool resolved = fall > 0x1p-44 * before;
    const Vec3d from = m.x;
    for (double fraction = 1;; fraction *= 0.5) {
      m.x = from - fraction * step;
      m.a = level(pair.a, m.x);
      m.b = level(pair.b, m.x - pair.d);
      if (!resolved || value() <= before - 0.1 * fraction * fall) break;
      if (!(fraction > 0x1p-40)) return false;
    }
    if (!resolved && ++last == last_steps) return true;
  }
  return false;
}

// The minimum of both together where they are equal: the weight s with g_A = g_B, which falls as s grows.
template <class Pair>
Minimum equal_minimum(const Pair& pair) {
  Minimum m;
  const Vec3d from = pair.a.inner_centre(), to = pair.d + pair.b.inner_centre();
  m.x = 0.5 * (from + to);
  m.a = level(pair.a, m.x);
  m.b = level(pair.b, m.x - pair.d);
  double low = 0, high = 1, d_low = 0, d_high = 0, s = 0.5;
  int side = 0;  // of the last two steps
  for (int i = 0; i < 200; ++i) {
    if (!minimise(pair, s, m)) return m;
    const double d = m.a.g - m.b.g;
    if (std::abs(d) <= 0x1p-40 * (m.a.g + m.b.g) || high - low <= 0x1p-50) {
      m.converged = true;
      return m;
    }
    // False position, halving the weight of an end that stays (Illinois).
    if (d > 0) {
      low = s, d_low = d;
      if (side > 0) d_high *= 0.5;
      side = 1;
    } else {
      high = s, d_high = d;
      if (side < 0) d_low *= 0.5;
      side = -1;
    }
    s = d_low != 0 && d_high != 0 ? low + (high - low) * (d_low / (d_low - d_high)) : 0.5 * (low + high);
    if (i % 8 == 7 || !(s > low && s < high)) s = 0.5 * (low + high);
  }
  return m;
}

// The τ > 0 where g = 1 on the line y + τ n; g(y) < 1. Newton's method from outside on a convex function.
template <class B>
double way_out(const B& body, const Vec3d& y, const Vec3d& n) {
  double tau = 4 * body.circumradius();
  for (int i = 0; i < 100; ++i) {
    const Level l = level(body, y + tau * n);
    const double slope = 2 * dot(l.half_gradient, n), step = (l.g - 1) / slope;
    if (!(slope > 0) || !(step > epsilon * body.circumradius())) break;
    tau -= step;
  }
  return tau;
}

// argmin of g on the plane through m.x with a unit normal, as `minimise`.
bool minimise_on_plane(const PotentialAt& body, const Vec3d& normal, Minimum& m) {
  constexpr int step_limit = 60, last_steps = 3;
  Vec3d t1, t2;
  tangent_frame(normal, t1, t2);
  m.a = level(body, m.x);
  for (int i = 0, last = 0; i < step_limit; ++i, ++m.steps) {
    const Vec3d h1 = m.a.half_hessian * t1, h2 = m.a.half_hessian * t2;
    const double g1 = dot(m.a.half_gradient, t1), g2 = dot(m.a.half_gradient, t2);
    const double h11 = dot(t1, h1), h12 = dot(t1, h2), h22 = dot(t2, h2), inverse = 1 / (h11 * h22 - h12 * h12);
    const double u = (h22 * g1 - h12 * g2) * inverse, v = (h11 * g2 - h12 * g1) * inverse;
    const Vec3d step = u * t1 + v * t2;
    const double fall = g1 * u + g2 * v, before = m.a.g;
    if (!(fall > 0x1p-80 * before)) return fall >= 0;
    const bool resolved = fall > 0x1p-44 * before;
    const Vec3d from = m.x;
    for (double fraction = 1;; fraction *= 0.5) {
      m.x = from - fraction * step;
      m.a = level(body, m.x);
      if (!resolved || m.a.g <= before - 0.1 * fraction * fall) break;
      if (!(fraction > 0x1p-40)) return false;
    }
    if (!resolved && ++last == last_steps) return true;
  }
  return false;
}

BallAt in_units(const Placed<shapes::Sphere>& s, double down) { return {s.radius * down}; }
PotentialAt in_units(const Placed<shapes::PotentialParticle>& p, double down) {
  return {p.shape, p.scale * down, p.rotation};
}
double reach(const Placed<shapes::Sphere>& s) { return s.radius; }
double reach(const Placed<shapes::PotentialParticle>& p) { return p.scale * p.shape->circumradius; }
double least_size(const Placed<shapes::Sphere>& s) { return s.radius; }
double least_size(const Placed<shapes::PotentialParticle>& p) {
  return std::min(p.scale, p.scale * p.shape->inner_radius);
}

template <class A, class B>
Contact answer(const Placed<A>& a, const Placed<B>& b, const Vec3d& offset) {
  const double size = max_abs(offset) + reach(a) + reach(b), limit = smallest_ratio * size;
  if (!(extent_in_range(size) && all_at_least(offset, -size) && least_size(a) >= limit && least_size(b) >= limit))
    return refused();
  const Scale scale = scale_of(size);
  RoundPair<decltype(in_units(a, 1)), decltype(in_units(b, 1))> pair{in_units(a, scale.down), in_units(b, scale.down),
                                                                     offset * scale.down, 0.0};
  pair.extent = norm(pair.d) + (pair.a.circumradius() + pair.b.circumradius());
  const auto hand_over = [&] {
    Contact c = Potential::query(a, b, offset, {}, nullptr);
    c.handed_over = true;
    return c;
  };
  const Minimum m = equal_minimum(pair);
  Vec3d n;
  const double slope = length_and_direction(m.a.half_gradient, n);
  if (!m.converged || !(slope > 0x1p-30)) return hand_over();
  const auto point = pair.evaluate(n);
  if (!(std::abs(point.f) <= 16)) return hand_over();
  const auto step = pair.newton_step(point);
  const double allowance = polyhedron_rounding * pair.extent;
  const double excess = pair.excess_bound(point, step);
  const double ball_gap =
      norm(pair.d + pair.b.inner_centre() - pair.a.inner_centre()) - (pair.a.inner_radius() + pair.b.inner_radius());
  const double upper = std::max(point.f, std::min(point.f + excess, ball_gap));
  Contact c = smooth_contact(point.f, point.f - (point.a.excess + point.b.excess) - allowance, upper + allowance, n,
                             point.a.x, pair.d + point.b.x, scale.up, m.steps);
  const bool inside = m.a.g < 1 && m.b.g < 1;
  c.method_overlap =
      (inside ? way_out(pair.a, m.x, n) + way_out(pair.b, m.x - pair.d, -n) : -point.f) * scale.up;  // (6)
  c.method_point = m.x * scale.up;
  return c;
}

}  // namespace

Contact ConstrainedMinimisation::query(const Placed<shapes::Sphere>& a, const Placed<shapes::PotentialParticle>& b,
                                       const Vec3d& offset, const Options&, Cache*) {
  return answer(a, b, offset);
}

Contact ConstrainedMinimisation::query(const Placed<shapes::PotentialParticle>& a,
                                       const Placed<shapes::PotentialParticle>& b, const Vec3d& offset, const Options&,
                                       Cache*) {
  if (seen_from_b(offset)) return exchanged(answer(b, a, -offset), offset);
  return answer(a, b, offset);
}

Contact ConstrainedMinimisation::query(const Placed<shapes::PotentialParticle>& a, const Placed<shapes::Plane>& b,
                                       const Vec3d& offset, const Options&, Cache*) {
  Contact c = Potential::query(a, b, offset, {.overlap_only = false, .patch = false}, nullptr);
  if (c.status == Status::refused) return c;
  const Scale scale = scale_of(max_abs(offset) + reach(a));
  const PotentialAt body = in_units(a, scale.down);
  const Vec3d n = -b.normal, centre = body.inner_centre();
  Minimum m;
  m.x = centre + dot(n, offset * scale.down - centre) * n;
  if (!minimise_on_plane(body, n, m)) c.status = Status::not_converged;
  c.iterations = m.steps;
  c.method_point = m.x * scale.up;
  if (m.a.g < 1) c.method_overlap = way_out(body, m.x, n) * scale.up;  // (7)
  return c;
}

}  // namespace contact
