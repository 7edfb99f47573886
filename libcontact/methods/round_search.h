// The search of potential.h, (1) to (4), over a pair of round bodies.
#pragma once

#include "libcontact/methods/method.h"
#include "libcontact/methods/round_bodies.h"

namespace contact {

template <class A, class B>
struct RoundPair {
  A a;
  B b;
  Vec3d d;        // origin of B from that of A
  double extent;  // |d| + circumradii, near 1

  struct Point {
    Vec3d n;
    typename A::At a;
    typename B::At b;
    double f;
  };
  struct Step {
    Vec3d turn, shift_a, shift_b;  // of n, and what it moves the support points by, to first order
    Vec3d w;
    double gain;       // r·s: twice the predicted gain in f
    double residual;   // |r|
    double curvature;  // trace of K_A + K_B
    bool at_maximum;   // (3) is positive definite
  };
  struct Root {
    Point point;
    Step step;
    int iterations = 0;
    bool converged = false, proof = false;
  };

  double least_curvature_radius() const { return a.least_curvature_radius() + b.least_curvature_radius(); }

  Point evaluate(const Vec3d& n, const Point* near = nullptr) const {
    Point p;
    p.n = n;
    p.a = a.at(n, near != nullptr ? &near->a : nullptr);
    p.b = b.at(-n, near != nullptr ? &near->b : nullptr);
    p.f = dot(n, d) - (p.a.height + p.b.height);
    return p;
  }

  Step newton_step(const Point& p) const {
    Vec3d t1, t2;
    tangent_frame(p.n, t1, t2);
    const TangentMatrix ka = a.radii(p.a, p.n, t1, t2), kb = b.radii(p.b, -p.n, t1, t2);
    Step s;
    s.w = d - p.a.x + p.b.x;
    const double r1 = dot(t1, s.w), r2 = dot(t2, s.w);
    s.curvature = (ka.k11 + ka.k22) + (kb.k11 + kb.k22);
    const double k12 = ka.k12 + kb.k12;
    double k11 = (ka.k11 + kb.k11) + p.f, k22 = (ka.k22 + kb.k22) + p.f, determinant = k11 * k22 - k12 * k12;
    s.at_maximum = determinant > 0 && k11 > 0;
    if (!s.at_maximum) {
      const double half = 0.5 * (k11 - k22);
      const double least = 0.5 * (k11 + k22) - std::sqrt(half * half + k12 * k12);
      const double shift = 2 * std::abs(least) + 0x1p-10 * (s.curvature + std::abs(p.f));
      k11 += shift;
      k22 += shift;
      determinant = k11 * k22 - k12 * k12;
    }
    const double inverse = 1 / determinant;
    const double s1 = (k22 * r1 - k12 * r2) * inverse, s2 = (k11 * r2 - k12 * r1) * inverse;  // (3)
    s.turn = s1 * t1 + s2 * t2;
    s.shift_a = (ka.k11 * s1 + ka.k12 * s2) * t1 + (ka.k12 * s1 + ka.k22 * s2) * t2;
    s.shift_b = -((kb.k11 * s1 + kb.k12 * s2) * t1 + (kb.k12 * s1 + kb.k22 * s2) * t2);
    s.gain = r1 * s1 + r2 * s2;
    s.residual = std::sqrt(r1 * r1 + r2 * r2);
    return s;
  }

  // How far (4) reaches above f; infinite where it does not hold. The support points are loose by eps times their
  // radius of curvature, and so is the residual.
  double excess_bound(const Point& p, const Step& s) const {
    double denominator = 2 * (least_curvature_radius() + p.f);
    if (p.f > 0) denominator = std::max(denominator, norm(s.w) + p.f);
    if (!(denominator > 0)) return std::numeric_limits<double>::infinity();
    const double residual = s.residual + 2 * epsilon * s.curvature;
    return residual * residual / denominator;
  }

  // Climbs to a stationary point of f. With `stop_at_proof` it stops at the first f above the margin.
  Root climb(const Point& start, bool stop_at_proof) const {
    constexpr int step_limit = 100, cut_limit = 24;
    const double unit = epsilon * extent;
    Root root;
    root.point = start;
    double last_residual = std::numeric_limits<double>::infinity();
    for (root.iterations = 1;; ++root.iterations) {
      if (stop_at_proof && root.point.f - (root.point.a.excess + root.point.b.excess) > proof_margin(extent)) {
        root.proof = root.converged = true;
        return root;
      }
      root.step = newton_step(root.point);
      const Step& s = root.step;
      const bool settled = s.gain <= 64 * unit;  // the gap is known to rounding
      const bool bounded =
          least_curvature_radius() + root.point.f <= 0 || excess_bound(root.point, root.step) <= 8 * unit;
      if ((s.residual <= 8 * unit && bounded) || (settled && s.residual >= 0.5 * last_residual)) {
        root.converged = true;
        return root;
      }
      if (root.iterations == step_limit) return root;
      last_residual = s.residual;
      const double turn = dot(s.turn, s.turn);
      double fraction = turn > 1 ? 1 / std::sqrt(turn) : 1;
      for (int cut = 0;; ++cut, fraction *= 0.25) {
        const Point next = evaluate(normalized(root.point.n + fraction * s.turn), &root.point);
        if (next.f >= root.point.f - 2 * unit) {
          root.point = next;
          break;
        }
        if (cut == cut_limit || !(next.f == next.f)) {
          root.converged = settled;
          return root;
        }
      }
    }
  }

  // The best direction among that of the centres and the normals that lie towards the other body.
  Point cold_start() const {
    const Vec3d between = d + b.inner_centre() - a.inner_centre();
    const double distance = norm(between);
    Point best = evaluate(distance > 0 ? between * (1 / distance) : Vec3d{0, 0, 1});
    const auto steepest = [&](const auto& body, double sign) {
      Vec3d n{};
      double most = 0;
      body.for_each_normal([&](const Vec3d& normal) {
        const double along = sign * dot(normal, between);
        if (along > most) most = along, n = sign * normal;
      });
      if (!(most > 0)) return;
      const Point p = evaluate(normalized(n));
      if (p.f > best.f) best = p;
    };
    steepest(a, 1.0);
    steepest(b, -1.0);
    return best;
  }

  // The best of several climbs for a pair that overlaps by more than m: from the normals that separate it best, of both
  // bodies and between them.
  Root search_deep(Root best) const {
    constexpr int most = 8;
    Point starts[most];
    int count = 0;
    const auto offer = [&](const Vec3d& direction) {
      const Point p = evaluate(normalized(direction));
      int at = count < most ? count++ : most;
      if (at == most && !(p.f > starts[most - 1].f)) return;
      if (at == most) --at;
      for (; at > 0 && p.f > starts[at - 1].f; --at) starts[at] = starts[at - 1];
      starts[at] = p;
    };
    a.for_each_normal(offer);
    b.for_each_normal([&](const Vec3d& n) { offer(-n); });
    // And between those: the edges and corners of the sum of both bodies.
    Vec3d normals[most];
    const int ranked = count;
    for (int i = 0; i < ranked; ++i) normals[i] = starts[i].n;
    for (int i = 0; i < ranked; ++i)
      for (int j = 0; j < i; ++j)
        if (const Vec3d between = normals[i] + normals[j]; dot(between, between) > 0x1p-10) offer(between);
    int iterations = best.iterations;
    for (int i = 0; i < count; ++i) {
      const Root root = climb(starts[i], false);
      iterations += root.iterations;
      if (root.point.f > best.point.f || (root.converged && !best.converged && root.point.f == best.point.f))
        best = root;
    }
    best.iterations = iterations;
    return best;
  }
};

}  // namespace contact
