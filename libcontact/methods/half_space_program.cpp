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
  tightest(*pair.other, pair.other_scale, transposed_times(pair.other_to_self, x - pair.offset), 1, v);
  return v;
}

Row row_of(const PolyhedronPair& pair, const Violation& v) {
  if (v.body == 0) {
    const auto& face = pair.self->faces[v.face];
    return {face.normal, pair.self_scale * face.offset, 0};
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

}  // namespace

bool analytic_centre(const PolyhedronPair& pair, Vec3d& x, int& steps) {
  for (steps = 0; steps < 60; ++steps) {
    // Gradient g = Σ a/s and Hessian H = Σ a aᵀ/s² of −Σ log s.
    Vec3d g{};
    double h[6] = {}, least = std::numeric_limits<double>::infinity();
    for_each_plane(pair, x, [&](double s, const Vec3d& normal) {
      least = std::min(least, s);
      const Vec3d a = (1 / s) * normal;
      g += a;
      h[0] += a.x * a.x, h[1] += a.y * a.y, h[2] += a.z * a.z;
      h[3] += a.x * a.y, h[4] += a.x * a.z, h[5] += a.y * a.z;
    });
    if (!(least > 0)) return false;
    // H = L Lᵀ.
    const double l00 = std::sqrt(h[0]), l10 = h[3] / l00, l20 = h[4] / l00, l11 = std::sqrt(h[1] - l10 * l10),
                 l21 = (h[5] - l20 * l10) / l11, l22 = std::sqrt(h[2] - l20 * l20 - l21 * l21);
    const double u0 = g.x / l00, u1 = (g.y - l10 * u0) / l11, u2 = (g.z - l20 * u0 - l21 * u1) / l22;
    const double decrement = std::sqrt(u0 * u0 + u1 * u1 + u2 * u2);
    if (!(decrement < largest_decrement)) return false;
    Vec3d step;
    step.z = -u2 / l22;
    step.y = (-u1 - l21 * step.z) / l11;
    step.x = (-u0 - l10 * step.y - l20 * step.z) / l00;
    x += (decrement < 0.25 ? 1 : step_length(pair, x, step, 1 / (1 + decrement))) * step;
    if (decrement < 0x1p-24) return true;  // the step just made leaves its square
  }
  return false;
}

}  // namespace contact
