// Newton's method on the unit sphere for the support separation of two ellipsoids, (1)–(4) of support_newton.h, without
// a branch per pair: T is double or a pack, a lane that has converged stands still, and its bits are those of double.
//
//   K_A = (S_A − x_A x_Aᵀ)/h_A,  S_A = R_A D_A² R_Aᵀ,  K = K_A + K_B,  K n = 0                                     (1)
//   (K + f) s = r  ⟂ n   =>   s = ((tr K + f) r − K r)/det,   det = e₂(K) + f (tr K + f)     (Cayley–Hamilton)      (2)
//
// e₂ is the second invariant, the product of the two radii of curvature summed over both bodies. No frame of the
// tangent plane is needed. Where K + f is not positive definite f is left out of (2): K alone is. A step that would
// lose separation is cut to a quarter. A pair that has not converged after `trials` evaluations, overlaps by more than
// m, is beyond `largest_aspect` (where (1) loses the square of the aspect ratio in digits) or gives no start is a
// straggler: the search of support_newton.cpp takes it from the best direction found here.
//
// Cost: about 220 operations, 3 roots and 4 divisions per evaluation; 4 evaluations at aspect ratio 2, 6 at 10.
// Source: own derivation. Validity: lengths in a power of two near the pair's extent. Accuracy: that of
// support_newton.h. Tests: tests/libcontact/ellipsoid_kernels.cpp, smooth_accuracy.cpp.
#pragma once

#include <cmath>

#include "shapes/math/select.h"
#include "shapes/math/vec.h"

namespace contact {

using shapes::all_of;
using shapes::larger;
using shapes::select;

template <class T>
struct EllipsoidPair {
  shapes::Vec3<T> axes_a, axes_b;          // semi-axes
  shapes::Mat3<T> rotation_a, rotation_b;  // body -> world
  shapes::Vec3<T> d;                       // centre of b − centre of a
};

template <class T>
struct EllipsoidAnswer {
  static constexpr double straggler = 0, solved = 1, proven = 2;
  T outcome, iterations;
  T gap, lower, upper;               // proven: lower alone
  shapes::Vec3<T> normal;            // straggler: the best direction found, or zero
  shapes::Vec3<T> inner_a, inner_b;  // support points of a along n, of b along −n turned about, from their centres
};

template <class T>
class EllipsoidSearch {
 public:
  using V = shapes::Vec3<T>;

  [[gnu::always_inline]] explicit EllipsoidSearch(const EllipsoidPair<T>& p) : d_(p.d) {
    for (int i = 0; i < 3; ++i) {
      a_.row[i] = scaled(p.rotation_a.row[i], p.axes_a);
      b_.row[i] = scaled(p.rotation_b.row[i], p.axes_b);
    }
    const T largest_a = largest(p.axes_a), largest_b = largest(p.axes_b);
    smallest_reach_ = select(largest_a < largest_b, largest_a, largest_b);
    least_a_ = least(p.axes_a);
    least_b_ = least(p.axes_b);
    flatness_a_ = least_a_ / largest_a;
    flatness_b_ = least_b_ / largest_b;
    distance_ = norm(d_);
    extent_ = distance_ + (largest_a + largest_b);
    unit_ = T(0x1p-52) * extent_;
  }

  // Support separation along n; above the margin it proves that the pair is apart. −1 of bodies without extent: their
  // rotation is none.
  [[gnu::always_inline]] T separation(const V& n) const {
    const T ha = norm(transposed_times(a_, n)), hb = norm(transposed_times(b_, n));
    return select(ha > T(0) && hb > T(0), dot(n, d_) - (ha + hb), T(-1));
  }
  [[gnu::always_inline]] T margin() const { return T(64) * unit_; }
  [[gnu::always_inline]] T allowance() const { return T(16) * unit_; }

  // `start`: a unit direction to begin with, or zero: cold. `stop_at_proof`: a separation above the margin is enough.
  // `tolerance`: so is an interval narrower than this part of the smaller circumradius; 0: as narrow as rounding
  // leaves.
  [[gnu::always_inline]] EllipsoidAnswer<T> solve(const V& start, bool stop_at_proof, double tolerance) const {
    const T enough = larger(T(tolerance) * smallest_reach_ - T(2) * allowance(), T(0));
    const Symmetric sa(a_), sb(b_);
    const T m = least_a_ * flatness_a_ + least_b_ * flatness_b_;
    const T aspect = T(1) / select(flatness_a_ < flatness_b_, flatness_a_, flatness_b_);
    const auto given = dot(start, start) > T(0.5);
    auto usable = aspect <= T(largest_aspect);
    V n = start;
    if (!all_of(given)) {
      auto found = given;
      n = choose(given, start, cold_start(sa, sb, found));
      usable = usable && (given || found);
    }

    auto done = !usable;
    V best{T(0), T(0), T(0)}, step = best, s, xa, xb;
    T f_best(-64), fraction(1), iterations(0), f, gain, excess, inverse_a, inverse_b;
    auto proof = f_best > T(0), apart = proof;  // none
    for (int trial = 0;; ++trial) {
      const V u = transposed_times(a_, n), v = transposed_times(b_, n);
      const T ha = norm(u), hb = norm(v);
      usable = usable && ha > T(0) && hb > T(0);
      inverse_a = T(1) / ha;
      inverse_b = T(1) / hb;
      xa = a_ * (u * inverse_a);
      xb = b_ * (v * inverse_b);
      f = dot(n, d_) - (ha + hb);
      const V w = d_ - (xa + xb), r = w - n * dot(w, n);
      const Symmetric k(sa, inverse_a, xa, sb, inverse_b, xb);
      const T trace = k.trace(), minors = k.minors(), with_f = trace + f;
      T determinant = minors + f * with_f;
      const auto at_maximum = determinant > T(0) && with_f + f > T(0);
      determinant = select(at_maximum, determinant, minors);
      const V turn = r * select(at_maximum, with_f, trace) - k * r;
      s = turn * (T(1) / larger(determinant, largest_abs(turn)));  // (2), no longer than √3
      gain = dot(r, s);
      const T curvature = T(0x1p-51) * trace;  // times the rounding of a direction: how loose r is
      excess = T(2) * (dot(r, r) + curvature * curvature);
      const auto accepted = usable && f >= f_best - T(2) * unit_;
      const T reach = T(2) * (m + f);
      const auto settled = (gain * aspect <= T(8) * unit_ && (excess <= T(8) * unit_ * reach || reach <= T(0))) ||
                           (gain <= enough && excess < enough * reach);
      if (stop_at_proof) proof = proof || (usable && !done && f > margin());
      iterations = select(done, iterations, T(trial + 1));
      done = done || proof || (accepted && at_maximum && settled);
      apart = reach > T(0);
      excess = excess / select(apart, reach, T(1));
      best = choose(accepted, n, best);
      if (trial + 1 == trials || all_of(done)) break;
      step = choose(accepted, s, step);
      f_best = select(accepted, f, f_best);
      fraction = select(accepted, T(1), T(0.25) * fraction);
      n = choose(done, n, normalized(best + fraction * step));
    }

    EllipsoidAnswer<T> answer;
    const auto solved = done && usable && apart && !proof;
    answer.outcome = select(solved, T(answer.solved), select(proof, T(answer.proven), T(answer.straggler)));
    answer.iterations = iterations;
    answer.gap = f + T(0.5) * gain;
    answer.lower = f - allowance();
    const T ball = distance_ - (least_a_ + least_b_), bound = f + excess;
    answer.upper = larger(select(bound < ball, bound, ball), answer.gap) + allowance();
    answer.normal = choose(solved, normalized(n + s), best);
    answer.inner_a = xa + (sa * s - xa * dot(xa, s)) * inverse_a;  // the step moves them by K_A s and K_B s
    answer.inner_b = xb + (sb * s - xb * dot(xb, s)) * inverse_b;
    return answer;
  }

 private:
  static constexpr int trials = 16;
  static constexpr double largest_aspect = 512;

  struct Symmetric {
    T xx, yy, zz, xy, xz, yz;
    [[gnu::always_inline]] explicit Symmetric(const shapes::Mat3<T>& a)  // A Aᵀ
        : xx(dot(a.row[0], a.row[0])),
          yy(dot(a.row[1], a.row[1])),
          zz(dot(a.row[2], a.row[2])),
          xy(dot(a.row[0], a.row[1])),
          xz(dot(a.row[0], a.row[2])),
          yz(dot(a.row[1], a.row[2])) {}
    // K of (1)
    [[gnu::always_inline]] Symmetric(const Symmetric& sa, const T& ia, const V& xa, const Symmetric& sb, const T& ib,
                                     const V& xb) {
      const V ya = xa * ia, yb = xb * ib;
      xx = (sa.xx * ia - xa.x * ya.x) + (sb.xx * ib - xb.x * yb.x);
      yy = (sa.yy * ia - xa.y * ya.y) + (sb.yy * ib - xb.y * yb.y);
      zz = (sa.zz * ia - xa.z * ya.z) + (sb.zz * ib - xb.z * yb.z);
      xy = (sa.xy * ia - xa.x * ya.y) + (sb.xy * ib - xb.x * yb.y);
      xz = (sa.xz * ia - xa.x * ya.z) + (sb.xz * ib - xb.x * yb.z);
      yz = (sa.yz * ia - xa.y * ya.z) + (sb.yz * ib - xb.y * yb.z);
    }
    [[gnu::always_inline]] T trace() const { return xx + yy + zz; }
    [[gnu::always_inline]] T minors() const { return (xx * yy - xy * xy) + (xx * zz - xz * xz) + (yy * zz - yz * yz); }
    [[gnu::always_inline]] friend V operator*(const Symmetric& m, const V& v) {
      return {m.xx * v.x + m.xy * v.y + m.xz * v.z, m.xy * v.x + m.yy * v.y + m.yz * v.z,
              m.xz * v.x + m.yz * v.y + m.zz * v.z};
    }
  };

  template <class M>
  [[gnu::always_inline]] static V choose(const M& mask, const V& a, const V& b) {
    return {select(mask, a.x, b.x), select(mask, a.y, b.y), select(mask, a.z, b.z)};
  }
  [[gnu::always_inline]] static T largest(const V& v) { return larger(v.x, larger(v.y, v.z)); }
  [[gnu::always_inline]] static T smaller(const T& a, const T& b) { return select(a < b, a, b); }
  [[gnu::always_inline]] static T least(const V& v) { return smaller(v.x, smaller(v.y, v.z)); }
  [[gnu::always_inline]] static T largest_abs(const V& v) {
    return larger(larger(larger(v.x, -v.x), larger(v.y, -v.y)), larger(v.z, -v.z));
  }

  // (S_A + S_B)⁻¹ d by cofactors: the normal at which the pair touches when both are scaled alike, to first order.
  template <class M>
  [[gnu::always_inline]] V cold_start(const Symmetric& a, const Symmetric& b, M& found) const {
    const T xx = a.xx + b.xx, yy = a.yy + b.yy, zz = a.zz + b.zz, xy = a.xy + b.xy, xz = a.xz + b.xz, yz = a.yz + b.yz;
    const T c00 = yy * zz - yz * yz, c01 = xz * yz - xy * zz, c02 = xy * yz - xz * yy, c11 = xx * zz - xz * xz;
    const T c12 = xy * xz - xx * yz, c22 = xx * yy - xy * xy;
    const V n{c00 * d_.x + c01 * d_.y + c02 * d_.z, c01 * d_.x + c11 * d_.y + c12 * d_.z,
              c02 * d_.x + c12 * d_.y + c22 * d_.z};
    const T square = dot(n, n);
    found = square > T(0x1p-900) && dot(n, d_) > T(0);  // positive definite: anything else is rounding
    return n * (T(1) / sqrt_of(select(found, square, T(1))));
  }
  [[gnu::always_inline]] static T sqrt_of(const T& x) {
    using std::sqrt;
    return sqrt(x);
  }

  shapes::Mat3<T> a_, b_;  // R D
  V d_;
  T smallest_reach_, least_a_, least_b_, flatness_a_, flatness_b_, distance_, extent_, unit_;
};

}  // namespace contact
