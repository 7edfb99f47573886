#include "libcontact/methods/common_normal.h"

#include <cmath>

#include "libcontact/methods/quadric_pair.h"
#include "libcontact/methods/round_search.h"

namespace contact {

namespace {

constexpr int iteration_limit = 200;

QuadricMeasure measure(const QuadricPair& pair) {
  const RoundPair<EllipsoidBody, EllipsoidBody> round{
      {pair.axes_a, pair.rotation_a}, {pair.axes_b, pair.rotation_b}, pair.d, pair.extent};
  QuadricMeasure m;
  m.converged = false;
  auto point = round.evaluate(pair.d * (1 / pair.distance));
  double last = std::numeric_limits<double>::infinity();
  for (m.iterations = 1; m.iterations <= iteration_limit; ++m.iterations) {
    const auto step = round.newton_step(point);
    // Residual of (1) at rounding, or no longer falling while the separation is known to rounding.
    if (step.residual <= 8 * epsilon * (pair.extent + step.curvature) ||
        (step.gain <= 64 * epsilon * pair.extent && step.residual >= 0.5 * last)) {
      m.converged = true;
      break;
    }
    last = step.residual;
    Vec3d turn = step.turn;
    if (pair.flat) turn.z = 0;
    const double angle = norm(turn);
    if (!(angle < 1e6)) break;
    auto next = round.evaluate(normalized(point.n + (angle > 0.5 ? 0.5 / angle : 1) * turn));
    // A Newton step on a sharp tip may fall back: it is halved until it does not.
    for (double fraction = angle > 0.5 ? 0.25 / angle : 0.5; next.f < point.f - 2 * epsilon * pair.extent;
         fraction *= 0.5) {
      if (fraction < 0x1p-40) break;
      next = round.evaluate(normalized(point.n + fraction * turn));
    }
    point = next;
  }
  m.found = std::abs(point.f) <= 16;
  m.normal = m.own_normal = point.n;
  m.own_point = 0.5 * (point.a.x + (pair.d + point.b.x));
  m.own_overlap = -point.f;  // (2)
  return m;
}

}  // namespace

Contact CommonNormal::query(const Placed<shapes::Ellipsoid>& a, const Placed<shapes::Ellipsoid>& b, const Vec3d& offset,
                            const Options& options, Cache*) {
  return by_quadric_method(a, b, offset, options, measure);
}

Contact CommonNormal::query(const Placed<shapes::Ellipse>& a, const Placed<shapes::Ellipse>& b, const Vec3d& offset,
                            const Options& options, Cache*) {
  return by_quadric_method(a, b, offset, options, measure);
}

}  // namespace contact
