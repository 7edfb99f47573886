#include "libcontact/methods/perram_wertheim.h"

#include <algorithm>
#include <cmath>

#include "libcontact/methods/unit_ball_space.h"
#include "libcontact/scale.h"

namespace contact {

namespace {

constexpr int iteration_limit = 120;

// The root of (2), and whether it was found.
double best_ratio(const Vec3d& sigma, const Vec3d& e, int& iterations, bool& found) {
  const double most = max_abs(sigma), least = std::min(sigma.x, std::min(sigma.y, sigma.z));
  double low = 1 / most, high = 1 / least, t = std::sqrt(low) * std::sqrt(high);
  for (iterations = 1; iterations <= iteration_limit; ++iterations) {
    double value = 0, slope = 0;
    for (int i = 0; i < 3; ++i) {
      const double st = sigma[i] * t, p = 1 / (1 + sigma[i] * st), q = e[i] * p;
      value += q * q * (1 - st * st);
      slope -= 2 * (q * sigma[i]) * (q * sigma[i]) * p * (1 + t);
    }
    (value > 0 ? low : high) = t;
    double next = t - value / slope;
    if (!(next > low && next < high)) next = std::sqrt(low) * std::sqrt(high);
    const double change = std::abs(next - t);
    t = next;
    if (change <= 0x1p-40 * t || high - low <= 4 * epsilon * high) {
      found = true;
      return t;
    }
  }
  found = false;
  return t;
}

QuadricMeasure measure(const QuadricPair& pair) {
  QuadricMeasure m;
  const UnitBallSpace s = unit_ball_space(pair);
  if (!s.valid) return m;
  const double size = max_abs(s.e);  // the root does not depend on it
  const Vec3d e = s.e * (1 / size);
  const double t = best_ratio(s.sigma, e, m.iterations, m.converged);
  Vec3d p;
  double sum = 0;
  for (int i = 0; i < 3; ++i) {
    p[i] = e[i] / (1 + s.sigma[i] * (s.sigma[i] * t));
    sum += e[i] * p[i];
  }
  const double growth = size * std::sqrt(t / (1 + t) * sum);  // (1)
  const Vec3d in_a = s.turn * p;  // (3): along D_A⁻¹ of it the normal, along D_A the point
  const Vec3d& a = pair.axes_a;
  length_and_direction(pair.rotation_a * Vec3d{in_a.x / a.x, in_a.y / a.y, in_a.z / a.z}, m.normal);
  m.own_normal = m.normal;
  m.own_point = size * (s.to_world * p);
  m.own_overlap = pair.distance * (1 / growth - 1);  // (4)
  m.found = growth > 0;
  return m;
}

}  // namespace

Contact PerramWertheim::query(const Placed<shapes::Ellipsoid>& a, const Placed<shapes::Ellipsoid>& b,
                              const Vec3d& offset, const Options& options, Cache*) {
  return by_quadric_method(a, b, offset, options, measure);
}

Contact PerramWertheim::query(const Placed<shapes::Ellipse>& a, const Placed<shapes::Ellipse>& b, const Vec3d& offset,
                              const Options& options, Cache*) {
  return by_quadric_method(a, b, offset, options, measure);
}

}  // namespace contact
