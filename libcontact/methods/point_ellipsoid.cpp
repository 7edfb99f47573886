#include "libcontact/methods/point_ellipsoid.h"

#include <algorithm>
#include <cmath>

#include "libcontact/contact.h"

namespace contact {

namespace {

constexpr int iteration_limit = 100;  // slowest near the rim of the medial disc: about 40 at |y_k| = 2^-60
constexpr double last_step =
    0x1p-27;  // a relative change of s whose square is below rounding: q may follow to first order
constexpr double on_disc = 0x1p-60;  // a shift of the point far below the rounding of its coordinates

EllipsoidFoot foot_of(const double* a, const shapes::Vec3d& y, const double* q, double g, int iterations) {
  const double root = std::sqrt(g), inverse_root = 1 / root;
  EllipsoidFoot result;
  for (int i = 0; i < 3; ++i) {
    const double signed_q = (y[i] < 0 ? -q[i] : q[i]) * inverse_root;
    result.foot[i] = a[i] * signed_q;  // (2)
    result.normal[i] = signed_q / a[i];
  }
  result.normal = normalized(result.normal);
  result.residual = std::abs(root - 1);
  result.iterations = iterations;
  return result;
}

}  // namespace

EllipsoidFoot nearest_on_ellipsoid(const shapes::Vec3d& semi_axes, const shapes::Vec3d& y) {
  const double a[3] = {semi_axes.x, semi_axes.y, semi_axes.z};
  const double* smallest = std::min_element(a, a + 3);
  const auto k = smallest - a;
  const double c = *smallest;
  double z[3], pole[3];
  double s = 0, square = 0, farthest_pole = 0;
  for (int i = 0; i < 3; ++i) {
    pole[i] = (a[i] - c) * (a[i] + c);
    z[i] = a[i] * std::abs(y[i]);
    if (pole[i] == 0 && std::abs(y[i]) < on_disc) z[i] = 0;
    s = std::max(s, z[i] - pole[i]);  // each term of G alone is at most 1 at the root
    square += z[i] * z[i];
    farthest_pole = std::max(farthest_pole, pole[i]);
  }
  s = std::max(s, std::sqrt(square) - farthest_pole);

  double q[3] = {}, inverse[3] = {}, g = 0;
  int iterations = 0;
  for (; iterations < iteration_limit; ++iterations) {
    double slope = 0;
    g = 0;
    for (int i = 0; i < 3; ++i) {
      if (z[i] == 0) continue;  // at s = 0 its denominator may vanish too
      inverse[i] = 1 / (s + pole[i]);
      q[i] = z[i] * inverse[i];  // (1)
      g += q[i] * q[i];
      slope += q[i] * q[i] * inverse[i];
    }
    if (g <= 1 + 4 * epsilon) break;
    const double step = (std::sqrt(g) - 1) * g / slope;
    if (!(s + step > s)) break;
    if (step <= last_step * s) {
      g = 0;
      for (int i = 0; i < 3; ++i) {
        q[i] -= q[i] * (inverse[i] * step);
        g += q[i] * q[i];
      }
      break;
    }
    s += step;
  }
  if (s == 0 && g < 1) {
    q[k] = std::sqrt(1 - g);  // (3)
    g = 1;
  }
  return foot_of(a, y, q, g, iterations);
}

bool second_foot(const shapes::Vec3d& semi_axes, const shapes::Vec3d& y, EllipsoidFoot& foot) {
  const double a[3] = {semi_axes.x, semi_axes.y, semi_axes.z};
  const auto k = std::min_element(a, a + 3) - a;
  double z[3], pole[3], limit = 0;
  for (int i = 0; i < 3; ++i) {
    pole[i] = (a[i] - a[k]) * (a[i] + a[k]);
    z[i] = a[i] * std::abs(y[i]);
    if (i != k) limit = limit == 0 ? pole[i] : std::min(limit, pole[i]);
    if (i != k && pole[i] == 0) return false;
  }
  double q[3] = {}, g = 0, r = z[k];  // r = −s; the term of a_k alone is 1 there
  for (int iterations = 0; iterations < iteration_limit; ++iterations) {
    if (!(r < limit)) return false;
    double slope = 0;
    g = 0;
    for (int i = 0; i < 3; ++i) {
      if (i == k || z[i] == 0) continue;
      q[i] = z[i] / (pole[i] - r);
      g += q[i] * q[i];
      slope += q[i] * q[i] / (pole[i] - r);
    }
    if (g >= 1) return false;  // and grows with r
    if (r == 0) {
      q[k] = std::sqrt(1 - g);
    } else {
      q[k] = z[k] / r;
      g += q[k] * q[k];
      slope -= q[k] * q[k] / r;
    }
    const double step = r == 0 ? 0 : (1 - g) / (2 * slope);
    if (r == 0 || g <= 1 + 4 * epsilon || !(r + step > r)) {
      q[k] = -q[k];
      foot = foot_of(a, y, q, r == 0 ? 1 : g, iterations);
      return true;
    }
    if (!(slope < 0)) return false;
    r += step;
  }
  return false;
}

}  // namespace contact
