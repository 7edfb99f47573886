// Newton's method on one angle for the support separation of two ellipses, without a branch per pair: T is double or a
// pack, a lane that has converged stands still, and its bits are those of double.
//
//   f(n) = n·d − h_A(n) − h_B(n),  h = |A^T n|, A = R diag(a, b)                                                  (1)
//   f' = r = t·(d − x_A − x_B),  x = A (A^T n)/h,  t = n turned by a right angle                                  (2)
//   f'' = −(ρ_A + ρ_B + f) − (r-terms that vanish at the maximum),  ρ = (a b)²/h³                                 (3)
//   n ← ((q² − r²) n + 2 q r t)/(q² + r²),  q = 2 (ρ_A + ρ_B + f): the turn 2 atan(r/q), no root                  (4)
//   gap <= f + r²/(2 (m + f)),  m = b_A²/a_A + b_B²/a_B the least radii of curvature, while m + f > 0             (5)
//   gap <= |d| − b_A − b_B                              (discs inside the bodies)                               (6)
//
// It starts at (A_A A_A^T + A_B A_B^T)⁻¹ d, or at a direction that it is given. A step that would lose separation is
// cut to a quarter. A pair that has not converged after `trials` evaluations, or overlaps by more than m, is a
// straggler: planar_ellipse.cpp tries many starts. The step that comes next is applied to first order to n, gap and
// support points.
//
// Cost: 2 roots, 4 divisions an evaluation; 3 to 4 evaluations at aspect ratio 2, 2 from the normal of the step before.
// Source: own derivation. Validity: lengths in a power of two near the pair's extent. Accuracy: planar.h. Tests:
// tests/libcontact/contract.cpp, ellipse_kernels.cpp, tests/extremes, tests/fuzz.
#pragma once

#include <cmath>

#include "libcontact/kernels/flat.h"
#include "shapes/math/select.h"

namespace contact {

using shapes::all_of;
using shapes::larger;
using shapes::lesser;
using shapes::select;

template <class T>
struct FlatEllipse {
  T a, b;  // semi-axes
  T cosine, sine;
};

template <class T>
struct EllipseAnswer {
  T solved, iterations;  // solved: 1, or 0 of a straggler, which has no other answer
  T gap, lower, upper;
  Flat<T> normal, inner_a, inner_b;  // support points of a along n, of b along −n turned about, from their centres
};

template <class T>
struct EllipsePoint {
  Flat<T> n, inner_a, inner_b;  // a direction; support points of a along it, of b along it, from their centres
  T f, residual;                // separation and its slope
  T radius_a, radius_b;         // ρ_A, ρ_B
};

template <class T>
class EllipseSearch {
 public:
  using V = Flat<T>;
  using Point = EllipsePoint<T>;

  [[gnu::always_inline]] EllipseSearch(const FlatEllipse<T>& a, const FlatEllipse<T>& b, const V& d)
      : a_(a), b_(b), d_(d) {
    using std::sqrt;
    const T ra = larger(a.a, a.b), rb = larger(b.a, b.b), ca = lesser(a.a, a.b), cb = lesser(b.a, b.b);
    const T distance = sqrt(dot(d, d));
    reach_ = lesser(ra, rb);
    ball_ = distance - (ca + cb);
    unit_ = T(0x1p-52) * (distance + (ra + rb));
    least_radius_ = ca * (ca / ra) + cb * (cb / rb);
  }

  // `start`: a unit direction to begin with, or zero: cold. `tolerance`: an interval narrower than this part of the
  // smaller circumradius is enough; 0: as narrow as rounding leaves it.
  [[gnu::always_inline]] EllipseAnswer<T> solve(const V& start, double tolerance) const {
    using std::sqrt;
    const T allowance = T(16) * unit_;
    Point p;
    EllipseAnswer<T> answer;
    const auto solved = climb(start, larger(T(0), T(tolerance) * reach_ - T(2) * allowance), p, answer.iterations);
    const T slope = (p.radius_a + p.radius_b) + p.f, size = select(p.residual < T(0), -p.residual, p.residual);
    const auto refines = slope > T(0) && size <= T(0x1p-20) * slope;  // else the step may lead away
    const T step = select(refines, p.residual / slope, T(0));
    const V t = p.n.turned(), turned = p.n + step * t;
    const T loose = size + T(0x1p-51) * (p.radius_a + p.radius_b), bound = T(2) * (least_radius_ + p.f);
    answer.solved = select(solved, T(1), T(0));
    answer.gap = p.f + T(0.5) * p.residual * step;
    answer.lower = p.f - allowance;
    answer.upper = larger(lesser(p.f + loose * loose / bound, ball_), answer.gap) + allowance;  // (5), (6)
    answer.normal = choose(refines, (T(1) / sqrt(dot(turned, turned))) * turned, p.n);
    answer.inner_a = p.inner_a + (p.radius_a * step) * t;
    answer.inner_b = p.inner_b + (p.radius_b * step) * t;
    return answer;
  }

 private:
  static constexpr int trials = 12;

  // `enough`: an interval (5) that is narrow enough. True for the lanes that are solved; the others are stragglers.
  [[gnu::always_inline]] auto climb(const V& start, const T& enough, Point& best, T& iterations) const {
    const T &unit = unit_, &least_radius = least_radius_;
    auto usable = d_.x == d_.x;
    const auto given = dot(start, start) > T(0.5);
    V n = start;
    if (!all_of(given)) {
      auto found = usable;
      n = choose(given, start, cold_start(found));
      usable = usable && (given || found);
    }
    best = {n, n, n, T(-64), T(0), T(1), T(0)};
    T fraction(1);
    iterations = T(0);
    auto solved = !usable && usable, done = !usable;
    for (int trial = 0; trial < trials; ++trial) {
      Point here;
      evaluate(n, here);
      const auto accepted = !done && here.f >= best.f - T(2) * unit;  // not of what is no number
      iterations = select(done, iterations, T(trial + 1));
      if (all_of(accepted)) {
        best = here;
        fraction = T(1);
      } else {
        best = choose(accepted, here, best);
        fraction = select(accepted, T(1), T(0.25) * fraction);
      }
      const T square = best.residual * best.residual, reach = T(2) * (least_radius + best.f),
              radii = best.radius_a + best.radius_b, slope = radii + best.f;
      // The slope is loose by the rounding of a direction times the radii.
      const T loose = T(0x1p-51) * radii, excess = T(2) * (square + loose * loose);
      const auto settled = (square * radii <= T(8) * unit * slope * least_radius && excess <= T(8) * unit * reach) ||
                           excess <= enough * reach;
      solved = solved || (accepted && reach > T(0) && settled);
      done = done || solved;
      if (all_of(done)) break;
      const T q = T(2) * select(slope > T(0), slope, radii), p = fraction * best.residual;
      const T pp = p * p, qq = q * q, inverse = T(1) / (pp + qq);
      n = choose(done, n, ((qq - pp) * inverse) * best.n + (T(2) * p * q * inverse) * best.n.turned());  // (4)
    }
    return solved;
  }

  struct Body {
    FlatEllipse<T> e;
    T area;  // (a b)²
    [[gnu::always_inline]] explicit Body(const FlatEllipse<T>& given) : e(given), area(e.a * e.b * (e.a * e.b)) {}
    [[gnu::always_inline]] V at(const V& n, T& height, T& radius) const {
      using std::sqrt;
      const T u = e.a * (n.x * e.cosine + n.y * e.sine), v = e.b * (n.y * e.cosine - n.x * e.sine);
      height = sqrt(u * u + v * v);
      const T inverse = T(1) / height;
      radius = area * inverse * (inverse * inverse);
      const T x = e.a * (u * inverse), y = e.b * (v * inverse);
      return {x * e.cosine - y * e.sine, x * e.sine + y * e.cosine};
    }
  };

  [[gnu::always_inline]] void evaluate(const V& n, Point& p) const {
    T ha, hb;
    p.n = n;
    p.inner_a = a_.at(n, ha, p.radius_a);
    p.inner_b = b_.at(n, hb, p.radius_b);
    p.f = dot(n, d_) - (ha + hb);  // (1)
    const V w = d_ - (p.inner_a + p.inner_b);
    p.residual = n.x * w.y - n.y * w.x;  // (2)
  }

  template <class M>
  [[gnu::always_inline]] static V choose(const M& mask, const V& a, const V& b) {
    return {select(mask, a.x, b.x), select(mask, a.y, b.y)};
  }
  template <class M>
  [[gnu::always_inline]] static Point choose(const M& mask, const Point& a, const Point& b) {
    return {choose(mask, a.n, b.n),
            choose(mask, a.inner_a, b.inner_a),
            choose(mask, a.inner_b, b.inner_b),
            select(mask, a.f, b.f),
            select(mask, a.residual, b.residual),
            select(mask, a.radius_a, b.radius_a),
            select(mask, a.radius_b, b.radius_b)};
  }

  template <class M>
  [[gnu::always_inline]] V cold_start(M& found) const {
    using std::sqrt;
    const auto add = [](const FlatEllipse<T>& e, T& xx, T& xy, T& yy) {
      const T a = e.a * e.a, b = e.b * e.b, difference = a - b;
      xx += a - difference * (e.sine * e.sine);
      yy += b + difference * (e.sine * e.sine);
      xy += difference * (e.sine * e.cosine);
    };
    T xx(0), xy(0), yy(0);
    add(a_.e, xx, xy, yy);
    add(b_.e, xx, xy, yy);
    const V n{yy * d_.x - xy * d_.y, xx * d_.y - xy * d_.x};
    const T square = dot(n, n);
    found = found && square > T(0x1p-900) && dot(n, d_) > T(0);  // positive definite: anything else is rounding
    return (T(1) / sqrt(select(found, square, T(1)))) * n;
  }

  Body a_, b_;
  V d_;
  T reach_, ball_, unit_, least_radius_;  // the smaller circumradius; (6); eps L; m
};

}  // namespace contact
