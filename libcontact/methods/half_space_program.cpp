#include "libcontact/methods/half_space_program.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace contact {

namespace {

constexpr int pivot_limit = 400;
constexpr double largest_decrement = 0x1p100;  // beyond is not a number

struct Row {  // a·x + t <= b
  Vec3d a;
  double b;
  int body;  // 0, 1; −1: of the tetrahedron
};

// Four linear equations by elimination with row exchanges. False when they are singular.
bool solve(double (&m)[4][5], double (&x)[4]) {
  for (int k = 0; k < 4; ++k) {
    int pivot = k;
    for (int i = k + 1; i < 4; ++i)
      if (std::abs(m[i][k]) > std::abs(m[pivot][k])) pivot = i;
    if (!(std::abs(m[pivot][k]) > 0x1p-50)) return false;
    if (pivot != k)
      for (int j = k; j < 5; ++j) std::swap(m[k][j], m[pivot][j]);
    for (int i = k + 1; i < 4; ++i) {
      const double f = m[i][k] / m[k][k];
      for (int j = k + 1; j < 5; ++j) m[i][j] -= f * m[k][j];
    }
  }
  for (int i = 3; i >= 0; --i) {
    double sum = m[i][4];
    for (int j = i + 1; j < 4; ++j) sum -= m[i][j] * x[j];
    x[i] = sum / m[i][i];
  }
  return true;
}

class Basis {
 public:
  explicit Basis(double size) {
    const double s = 1 / std::sqrt(3.0);
    const Vec3d corners[4] = {{s, s, s}, {s, -s, -s}, {-s, s, -s}, {-s, -s, s}};
    for (int i = 0; i < 4; ++i) row_[i] = {corners[i], 8 * size, -1}, lambda_[i] = 0.25;
  }
  const Row& row(int i) const { return row_[i]; }
  double lambda(int i) const { return lambda_[i]; }

  bool point(Vec3d& x, double& t) const {
    double m[4][5], v[4];
    for (int i = 0; i < 4; ++i) {
      const Row& r = row_[i];
      const double values[5] = {r.a.x, r.a.y, r.a.z, 1, r.b};
      std::copy(values, values + 5, m[i]);
    }
    if (!solve(m, v)) return false;
    x = {v[0], v[1], v[2]};
    t = v[3];
    return true;
  }

  bool enter(const Row& r) {
    double m[4][5], mu[4];
    for (int i = 0; i < 4; ++i) {
      m[0][i] = row_[i].a.x;
      m[1][i] = row_[i].a.y;
      m[2][i] = row_[i].a.z;
      m[3][i] = 1;
    }
    const double values[4] = {r.a.x, r.a.y, r.a.z, 1};
    for (int i = 0; i < 4; ++i) m[i][4] = values[i];
    if (!solve(m, mu)) return false;
    int leaves = -1;
    double step = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 4; ++i) {
      if (!(mu[i] > 0x1p-40)) continue;
      const double ratio = lambda_[i] / mu[i];
      // Of ties the largest μ, for the sake of the next basis.
      if (ratio < step || (ratio == step && mu[i] > mu[leaves])) step = ratio, leaves = i;
    }
    if (leaves < 0) return false;
    for (int i = 0; i < 4; ++i) lambda_[i] = std::max(0.0, lambda_[i] - step * mu[i]);
    row_[leaves] = r;
    lambda_[leaves] = step;
    return true;
  }

 private:
  Row row_[4];
  double lambda_[4];
};

struct Violation {
  double slack = std::numeric_limits<double>::infinity();  // b − a·x
  std::size_t face = 0;
  int body = 0;
};

// The plane of a body that x comes closest to, or passes farthest.
void tightest(const shapes::Polyhedron& p, double scale, const Vec3d& x, int body, Violation& v) {
  for (std::size_t i = 0; i < p.faces.size(); ++i) {
    const double slack = scale * p.nd[i] - (p.nx[i] * x.x + p.ny[i] * x.y + p.nz[i] * x.z);
    if (slack < v.slack) v = {slack, i, body};
  }
}

Violation tightest(const PolyhedronPair& pair, const Vec3d& x) {
  Violation v;
  tightest(*pair.self, pair.self_scale, x, 0, v);
  if (pair.other != nullptr) {
    tightest(*pair.other, pair.other_scale, transposed_times(pair.other_to_self, x - pair.offset), 1, v);
  } else if (const double slack = dot(pair.other_to_self.column(2), pair.offset - x); slack < v.slack) {
    v = {slack, 0, 1};
  }
  return v;
}

Row row_of(const PolyhedronPair& pair, const Violation& v) {
  if (v.body == 0) {
    const auto& face = pair.self->faces[v.face];
    return {face.normal, pair.self_scale * face.offset, 0};
  }
  if (pair.other == nullptr) {
    const Vec3d a = pair.other_to_self.column(2);
    return {a, dot(a, pair.offset), 1};
  }
  const auto& face = pair.other->faces[v.face];
  const Vec3d a = pair.other_to_self * face.normal;
  return {a, pair.other_scale * face.offset + dot(a, pair.offset), 1};
}

}  // namespace

HalfSpaceOptimum largest_ball(const PolyhedronPair& pair, double size) {
  HalfSpaceOptimum best;
  best.lower = -std::numeric_limits<double>::infinity();
  best.upper = std::numeric_limits<double>::infinity();
  Basis basis(size);
  const double rounding = 8 * epsilon * size;
  for (; best.pivots < pivot_limit; ++best.pivots) {
    Vec3d x;
    double t;
    if (!basis.point(x, t)) return best;
    const Violation v = tightest(pair, x);
    if (v.slack > best.lower) best.lower = v.slack, best.x = x;
    if (!(v.slack < t - rounding)) {
      best.converged = true;
      double bound = 0;
      for (int i = 0; i < 4; ++i) {
        const Row& r = basis.row(i);
        bound += basis.lambda(i) * r.b;
        if (r.body == 0) best.normal += basis.lambda(i) * r.a;
      }
      best.upper = bound;
      best.x = x;
      best.lower = v.slack;
      return best;
    }
    if (!basis.enter(row_of(pair, v))) return best;
  }
  return best;
}

namespace {

// use(slack at x, normal of the plane in the pair's frame) for the planes of both bodies.
template <class Use>
void for_each_plane(const PolyhedronPair& pair, const Vec3d& x, Use&& use) {
  for (const auto& face : pair.self->faces) use(pair.self_scale * face.offset - dot(face.normal, x), face.normal);
  if (pair.other == nullptr) {
    const Vec3d a = pair.other_to_self.column(2);
    return use(dot(a, pair.offset - x), a);
  }
  const Vec3d y = transposed_times(pair.other_to_self, x - pair.offset);
  for (const auto& face : pair.other->faces)
    use(pair.other_scale * face.offset - dot(face.normal, y), pair.other_to_self * face.normal);
}

// How far to go along a direction of descent of −Σ log s: most of the way to the nearest plane if the function still
// falls there, so that a thin overlap is crossed in a few steps; never less than `safe`.
double step_length(const PolyhedronPair& pair, const Vec3d& x, const Vec3d& step, double safe) {
  double most = std::numeric_limits<double>::infinity();
  for_each_plane(pair, x, [&](double s, const Vec3d& a) {
    if (const double rate = dot(a, step); rate > 0) most = std::min(most, s / rate);
  });
  if (!(most <= 0x1p100)) return safe;  // no plane ahead: a rotation that is none
  for (double t = 0.9 * most; t > safe; t *= 0.5) {
    double slope = 0;
    for_each_plane(pair, x, [&](double s, const Vec3d& a) {
      const double rate = dot(a, step);
      slope += rate / (s - t * rate);
    });
    if (slope <= 0) return t;
  }
  return safe;
}

// Newton's step of −Σ log s, and its length in the norm of the second derivative H = Σ a aᵀ/s²; `least` slack.
struct NewtonStep {
  Vec3d step{};
  double decrement = std::numeric_limits<double>::quiet_NaN(), least = std::numeric_limits<double>::infinity();
};

// By H = L Lᵀ. No number where H has lost a direction: of a slab it is singular to rounding.
NewtonStep step_by_products(const PolyhedronPair& pair, const Vec3d& x) {
  NewtonStep n;
  Vec3d g{};
  double h[6] = {};
  for_each_plane(pair, x, [&](double s, const Vec3d& normal) {
    n.least = std::min(n.least, s);
    const Vec3d a = (1 / s) * normal;
    g += a;
    h[0] += a.x * a.x, h[1] += a.y * a.y, h[2] += a.z * a.z;
    h[3] += a.x * a.y, h[4] += a.x * a.z, h[5] += a.y * a.z;
  });
  const double l00 = std::sqrt(h[0]), l10 = h[3] / l00, l20 = h[4] / l00, d11 = h[1] - l10 * l10;
  const double l11 = std::sqrt(d11), l21 = (h[5] - l20 * l10) / l11, d22 = h[2] - l20 * l20 - l21 * l21;
  if (!(d11 > 0x1p-26 * h[1] && d22 > 0x1p-26 * h[2])) return n;
  const double l22 = std::sqrt(d22);
  const double u0 = g.x / l00, u1 = (g.y - l10 * u0) / l11, u2 = (g.z - l20 * u0 - l21 * u1) / l22;
  n.decrement = std::sqrt(u0 * u0 + u1 * u1 + u2 * u2);
  n.step.z = -u2 / l22;
  n.step.y = (-u1 - l21 * n.step.z) / l11;
  n.step.x = (-u0 - l10 * n.step.y - l20 * n.step.z) / l00;
  return n;
}

// The same as the least squares of (a/s)·step = −1, plane by plane turned into a triangle: without the square.
void step_by_rotations(const PolyhedronPair& pair, const Vec3d& x, NewtonStep& n) {
  double r[3][4] = {};
  for_each_plane(pair, x, [&](double s, const Vec3d& normal) {
    const Vec3d scaled = (1 / s) * normal;
    double a[4] = {scaled.x, scaled.y, scaled.z, 1};
    for (int k = 0; k < 3; ++k) {
      if (a[k] == 0) continue;
      const double length = std::sqrt(r[k][k] * r[k][k] + a[k] * a[k]), c = r[k][k] / length, w = a[k] / length;
      for (int j = k; j < 4; ++j) {
        const double top = r[k][j];
        r[k][j] = c * top + w * a[j];
        a[j] = c * a[j] - w * top;
      }
    }
  });
  n.decrement = std::sqrt(r[0][3] * r[0][3] + r[1][3] * r[1][3] + r[2][3] * r[2][3]);
  n.step.z = -r[2][3] / r[2][2];
  n.step.y = (-r[1][3] - r[1][2] * n.step.z) / r[1][1];
  n.step.x = (-r[0][3] - r[0][1] * n.step.y - r[0][2] * n.step.z) / r[0][0];
}

}  // namespace

bool analytic_centre(const PolyhedronPair& pair, Vec3d& x, int& steps) {
  double last = std::numeric_limits<double>::infinity();
  for (steps = 0; steps < 60; ++steps) {
    NewtonStep n = step_by_products(pair, x);
    if (!(n.least > 0)) return false;
    if (!(n.decrement < largest_decrement)) step_by_rotations(pair, x, n);
    if (!(n.decrement < largest_decrement)) return false;
    // Below 1/4 it falls by its square, but for the rounding of the slacks of a thin overlap.
    if (n.decrement < 0.25 && n.decrement >= 0.5 * last) return true;
    last = n.decrement;
    x += (n.decrement < 0.25 ? 1 : step_length(pair, x, n.step, 1 / (1 + n.decrement))) * n.step;
    if (n.decrement < 0x1p-24) return true;  // the step just made leaves its square
  }
  return false;
}

}  // namespace contact
