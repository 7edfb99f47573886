#include "libcontact/methods/ellipsoid_climb.h"

#include <algorithm>
#include <cmath>

#include "libcontact/methods/method.h"
#include "libcontact/scale.h"

namespace contact {

namespace {

constexpr int step_limit = 160;
constexpr int cut_limit = 24;  // a step is cut to a quarter this many times before the point counts as stationary

// The pair in units where the extent is near 1.
struct Pair {
  Mat3d a, b;  // R D: columns are the semi-axes as vectors
  Vec3d d;
  double extent;                  // |d| + circumradii
  double least_curvature_radius;  // m of (4)
  double aspect;                  // the larger of the two aspect ratios
  double ball_gap;                // right side of (5)
};

struct Point {  // of the search
  Vec3d n;
  Vec3d u, v;     // Dᵀ Rᵀ n of A and B, unit
  double ha, hb;  // support heights
  double f;       // (1)
};

struct Step {
  Vec3d turn;              // tangential change of n
  Vec3d shift_a, shift_b;  // what it moves the support points by, to first order
  Vec3d xa, xb, w;
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

Mat3d columns_scaled(const Mat3d& r, const Vec3d& s) {
  return {{scaled(r.row[0], s), scaled(r.row[1], s), scaled(r.row[2], s)}};
}

Point evaluate(const Pair& pair, const Vec3d& n) {
  Point p;
  p.n = n;
  p.u = transposed_times(pair.a, n);
  p.v = transposed_times(pair.b, n);
  p.ha = norm(p.u);
  p.hb = norm(p.v);
  p.u *= 1 / p.ha;
  p.v *= 1 / p.hb;
  p.f = dot(n, pair.d) - (p.ha + p.hb);
  return p;
}

// Symmetric 2×2 matrix of radii of curvature of one body in the tangent plane (t1, t2).
struct Curvature {
  double k11, k12, k22;
};

Curvature curvature(const Mat3d& axes, const Vec3d& u, double height, const Vec3d& t1, const Vec3d& t2) {
  Vec3d p = transposed_times(axes, t1), q = transposed_times(axes, t2);
  p -= dot(p, u) * u;
  q -= dot(q, u) * u;
  const double inverse = 1 / height;
  return {dot(p, p) * inverse, dot(p, q) * inverse, dot(q, q) * inverse};
}

Step newton_step(const Pair& pair, const Point& p) {
  Vec3d t1, t2;
  tangent_frame(p.n, t1, t2);
  const Curvature ka = curvature(pair.a, p.u, p.ha, t1, t2), kb = curvature(pair.b, p.v, p.hb, t1, t2);
  Step s;
  s.xa = pair.a * p.u;
  s.xb = pair.b * p.v;
  s.w = pair.d - (s.xa + s.xb);
  const double r1 = dot(t1, s.w), r2 = dot(t2, s.w);
  s.curvature = (ka.k11 + ka.k22) + (kb.k11 + kb.k22);
  const double k12 = ka.k12 + kb.k12;
  double k11 = (ka.k11 + kb.k11) + p.f, k22 = (ka.k22 + kb.k22) + p.f;
  double determinant = k11 * k22 - k12 * k12;
  s.at_maximum = determinant > 0 && k11 > 0;
  if (!s.at_maximum) {
    const double half = 0.5 * (k11 - k22);
    const double least = 0.5 * (k11 + k22) - std::sqrt(half * half + k12 * k12);
    const double shift = 2 * std::abs(least) + 0x1p-10 * s.curvature;
    k11 += shift;
    k22 += shift;
    determinant = k11 * k22 - k12 * k12;
  }
  const double inverse = 1 / determinant;
  const double s1 = (k22 * r1 - k12 * r2) * inverse, s2 = (k11 * r2 - k12 * r1) * inverse;  // (3)
  s.turn = s1 * t1 + s2 * t2;
  s.shift_a = (ka.k11 * s1 + ka.k12 * s2) * t1 + (ka.k12 * s1 + ka.k22 * s2) * t2;
  s.shift_b = (kb.k11 * s1 + kb.k12 * s2) * t1 + (kb.k12 * s1 + kb.k22 * s2) * t2;
  s.gain = r1 * s1 + r2 * s2;
  s.residual = std::sqrt(r1 * r1 + r2 * r2);
  return s;
}

// How far (4) reaches above f; infinite where it does not hold. The support points are loose by eps times their radius
// of curvature, and so is the residual.
double excess_bound(const Pair& pair, const Point& p, const Step& s) {
  double denominator = 2 * (pair.least_curvature_radius + p.f);
  if (p.f > 0) denominator = std::max(denominator, norm(s.w) + p.f);
  if (!(denominator > 0)) return std::numeric_limits<double>::infinity();
  const double residual = s.residual + 2 * epsilon * s.curvature;
  return residual * residual / denominator;
}

// Climbs to a stationary point of f. With `stop_at_proof` it stops at the first f above the margin.
Root climb(const Pair& pair, const Point& start, bool stop_at_proof) {
  const double unit = epsilon * pair.extent;
  Root root;
  root.point = start;
  double last_residual = std::numeric_limits<double>::infinity();
  for (root.iterations = 1;; ++root.iterations) {
    if (stop_at_proof && root.point.f > proof_margin(pair.extent)) {
      root.proof = root.converged = true;
      return root;
    }
    root.step = newton_step(pair, root.point);
    const Step& s = root.step;
    const bool settled = s.gain <= 64 * unit;                      // the gap is known to rounding
    const bool points_settled = s.gain * pair.aspect <= 8 * unit;  // and the next order of the points is negligible
    const bool bounded =
        pair.least_curvature_radius + root.point.f <= 0 || excess_bound(pair, root.point, s) <= 8 * unit;
    if ((points_settled && bounded) || (settled && s.residual >= 0.5 * last_residual)) {
      root.converged = true;
      return root;
    }
    if (root.iterations == step_limit) return root;
    last_residual = s.residual;
    const double turn = dot(s.turn, s.turn);
    double fraction = turn > 1 ? 1 / std::sqrt(turn) : 1;
    for (int cut = 0;; ++cut, fraction *= 0.25) {
      const Point next = evaluate(pair, normalized(root.point.n + fraction * s.turn));
      if (next.f >= root.point.f - 2 * unit) {
        root.point = next;
        break;
      }
      if (cut == cut_limit) {
        root.converged = settled;
        return root;
      }
    }
  }
}

// Direction (S_A + S_B)⁻¹ d by cofactors: the normal at which the pair touches when both are scaled alike, to first
// order.
Vec3d cold_start(const Pair& pair) {
  double s[3][3];
  for (int i = 0; i < 3; ++i)
    for (int j = i; j < 3; ++j) s[i][j] = dot(pair.a.row[i], pair.a.row[j]) + dot(pair.b.row[i], pair.b.row[j]);
  const double c00 = s[1][1] * s[2][2] - s[1][2] * s[1][2], c01 = s[0][2] * s[1][2] - s[0][1] * s[2][2];
  const double c02 = s[0][1] * s[1][2] - s[0][2] * s[1][1], c11 = s[0][0] * s[2][2] - s[0][2] * s[0][2];
  const double c12 = s[0][1] * s[0][2] - s[0][0] * s[1][2], c22 = s[0][0] * s[1][1] - s[0][1] * s[0][1];
  const Vec3d& d = pair.d;
  Vec3d n;
  length_and_direction(
      {c00 * d.x + c01 * d.y + c02 * d.z, c01 * d.x + c11 * d.y + c12 * d.z, c02 * d.x + c12 * d.y + c22 * d.z}, n);
  if (dot(n, d) > 0) return n;  // S_A + S_B is positive definite: anything else is rounding
  length_and_direction(d, n);
  return n;
}

// The best of several climbs for a pair that overlaps by more than m. At the global maximum n·d >= 0, as f(−n) = f(n) −
// 2 n·d.
Root search_deep(const Pair& pair, const EllipsoidPair<double>& bodies, Root best) {
  Vec3d starts[10];
  int count = 0;
  const Vec3d* axes[2] = {&bodies.axes_a, &bodies.axes_b};
  const Mat3d* rotations[2] = {&bodies.rotation_a, &bodies.rotation_b};
  Vec3d thin[2];
  for (int body = 0; body < 2; ++body) {
    int k = 0;
    for (int i = 0; i < 3; ++i) {
      starts[count++] = rotations[body]->column(i);
      if ((*axes[body])[i] < (*axes[body])[k]) k = i;
    }
    thin[body] = rotations[body]->column(k);
  }
  for (const double sign : {1.0, -1.0}) {
    Vec3d between;
    if (length_and_direction(thin[0] + sign * thin[1], between) > 0x1p-20) starts[count++] = between;
  }
  int iterations = best.iterations;
  for (int i = 0; i < count; ++i) {
    const Vec3d& n = starts[i];
    const Root root = climb(pair, evaluate(pair, dot(n, pair.d) < 0 ? -n : n), false);
    iterations += root.iterations;
    if (root.point.f > best.point.f || (root.converged && !best.converged && root.point.f == best.point.f)) best = root;
  }
  best.iterations = iterations;
  return best;
}

EllipsoidAnswer<double> answer_of(const Pair& pair, const Root& root, bool& proven) {
  const Point& p = root.point;
  const Step& s = root.step;
  const double allowance = rounding(pair.extent);
  // Where f hardly curves the step may lead away.
  const bool refine = root.converged && s.at_maximum && s.gain <= 0x1p-20 * pair.extent &&
                      evaluate(pair, normalized(p.n + s.turn)).f >= p.f - 2 * epsilon * pair.extent;
  const double gap = refine ? p.f + 0.5 * s.gain : p.f;
  const double excess = excess_bound(pair, p, s);
  proven = !root.converged || excess <= largest_extent || pair.ball_gap <= gap + allowance;
  const double upper = proven ? std::min(p.f + excess, pair.ball_gap) : gap;  // (4), (5)
  EllipsoidAnswer<double> r{EllipsoidAnswer<double>::solved,
                            static_cast<double>(root.iterations),
                            gap,
                            p.f - allowance,
                            std::max(upper, gap) + allowance,
                            p.n,
                            s.xa,
                            s.xb};
  if (refine) {
    r.normal = normalized(p.n + s.turn);
    r.inner_a += s.shift_a;
    r.inner_b += s.shift_b;
  }
  return r;
}

}  // namespace

EllipsoidAnswer<double> climb_ellipsoids(const EllipsoidPair<double>& bodies, const Vec3d& start, bool stop_at_proof,
                                         Certainty& certainty) {
  Pair pair;
  pair.a = columns_scaled(bodies.rotation_a, bodies.axes_a);
  pair.b = columns_scaled(bodies.rotation_b, bodies.axes_b);
  pair.d = bodies.d;
  const double distance = norm(pair.d), ra = max_abs(bodies.axes_a), rb = max_abs(bodies.axes_b);
  pair.extent = distance + (ra + rb);
  const auto least = [](const Vec3d& v) { return std::min(v.x, std::min(v.y, v.z)); };
  const double ca = least(bodies.axes_a), cb = least(bodies.axes_b);
  pair.least_curvature_radius = ca * (ca / ra) + cb * (cb / rb);
  pair.aspect = std::max(ra / ca, rb / cb);
  pair.ball_gap = distance - (ca + cb);
  const Point first = evaluate(pair, dot(start, start) > 0 ? start : cold_start(pair));
  // The extent is below 4: a rotation that is not finite, or zero.
  if (!(std::abs(first.f) <= 16 && first.ha > 0 && first.hb > 0)) {
    certainty = Certainty::none;
    return {};
  }
  Root root = climb(pair, first, stop_at_proof);
  if (!root.converged || root.point.f + pair.least_curvature_radius <= 0) root = search_deep(pair, bodies, root);
  if (root.proof) {
    certainty = Certainty::proven;
    return {EllipsoidAnswer<double>::proven,
            static_cast<double>(root.iterations),
            root.point.f,
            root.point.f - rounding(pair.extent),
            0,
            root.point.n,
            {},
            {}};
  }
  bool proven = false;
  const EllipsoidAnswer<double> r = answer_of(pair, root, proven);
  certainty = !root.converged ? Certainty::not_converged : (proven ? Certainty::proven : Certainty::best_known);
  return r;
}

}  // namespace contact
