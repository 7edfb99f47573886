#include "libcontact/methods/ellipsoid_support.h"

#include <algorithm>
#include <cmath>

#include "libcontact/methods/point_ellipsoid.h"

namespace contact {

double EllipsoidAt::least_axis() const { return std::min({semi_axes.x, semi_axes.y, semi_axes.z}); }

double EllipsoidAt::least_curvature_radius() const {
  const double c = least_axis(), a = std::max({semi_axes.x, semi_axes.y, semi_axes.z});
  return c * (c / a);
}

double EllipsoidAt::point_separation(const Vec3d& p, Vec3d& m) const {
  m = -(axes * nearest_on_ellipsoid(semi_axes, transposed_times(axes, p - centre)).normal);
  return dot(m, centre - p) - support(m).height;
}

ArcMaximum maximise_on_arc(const EllipsoidAt& body, const Vec3d& p, const Vec3d& e, const Vec3d& n0, const Vec3d& n1,
                           const Vec3d& start) {
  constexpr int iteration_limit = 40;
  const Vec3d turn = normalized(e), w = body.centre - p;
  const auto value_at = [&](const Vec3d& m) { return dot(m, w) - body.support(m).height; };
  const auto clamped = [&](const Vec3d& m) {
    // Past an end when the turn from n0, or to n1, is the wrong way round; the arc is shorter than half a circle.
    const bool before = dot(cross(n0, m), turn) < 0, after = dot(cross(m, n1), turn) < 0;
    if (!before && !after) return m;
    return dot(m, n0) > dot(m, n1) ? n0 : n1;
  };
  ArcMaximum best{value_at(start), start, 0};
  for (int& i = best.iterations; i < iteration_limit; ++i) {
    const Vec3d side = cross(turn, best.m);
    const EllipsoidAt::Support s = body.support(best.m);
    const Vec3d stretched = scaled(body.semi_axes, transposed_times(body.axes, side));
    const double arm = dot(side, s.arm), slope = dot(side, w) - arm;
    const double rho = (dot(stretched, stretched) - arm * arm) / s.height, bend = best.value + rho;  // (1)
    double step = bend > 0 ? slope / bend : slope / rho;
    step = std::clamp(step, -0.5, 0.5);
    bool climbed = false;
    for (int halving = 0; halving < 30 && !climbed; ++halving, step *= 0.5) {
      const Vec3d m = clamped(normalized(best.m + step * side));
      const double value = value_at(m);
      if (value > best.value) best.value = value, best.m = m, climbed = true;
      if (std::abs(step) < 4 * epsilon) break;
    }
    if (!climbed) break;
  }
  return best;
}

Vec3d ascend(const EllipsoidAt& body, const Vec3d& p, const Vec3d& start) {
  constexpr int iteration_limit = 100;
  const Vec3d w = body.centre - p;
  Vec3d m = start;
  double value = dot(m, w) - body.support(m).height;
  for (int i = 0; i < iteration_limit; ++i) {
    const EllipsoidAt::Support s = body.support(m);
    const Vec3d gradient = w - s.arm, slope = gradient - dot(m, gradient) * m;
    const double steepness = norm(slope);
    if (!(steepness > epsilon * (s.height + norm(w)))) break;
    const Vec3d side = slope * (1 / steepness);
    const Vec3d stretched = scaled(body.semi_axes, transposed_times(body.axes, side));
    const double arm = dot(side, s.arm), rho = (dot(stretched, stretched) - arm * arm) / s.height;
    double step = std::min(steepness / (value + rho > 0 ? value + rho : rho), 0.5);
    bool climbed = false;
    for (int halving = 0; halving < 20 && !climbed; ++halving, step *= 0.5) {
      const Vec3d trial = normalized(m + step * side);
      const double v = dot(trial, w) - body.support(trial).height;
      if (v > value) value = v, m = trial, climbed = true;
    }
    if (!climbed) break;
  }
  return m;
}

}  // namespace contact
