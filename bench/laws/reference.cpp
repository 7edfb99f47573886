#include "bench/laws/reference.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "bench/laws/micro_slip.h"

namespace laws {
// Scaled: m* = 1, E* R*^½ 4/3 = K = 1, vn = 1. κ = E*/(4G*): kt = 8 G* a = (3/2) K sqrt(δ)/κ.
Oblique oblique_impact(Across law, double theta, double poisson, double friction) {
  const double kappa = (2 - poisson) / (2 * (1 - poisson)), slip_before = theta * friction;
  const double depth_max = std::pow(1.25, 0.4);  // of ½ = (2/5) δ^{5/2}
  const double duration = 0.8 * std::sqrt(std::numbers::pi) * std::tgamma(0.4) / std::tgamma(0.9) * depth_max;
  const double linear = std::pow(std::numbers::pi / duration, 2);  // kn with m* = 1, (9.22)
  const int steps = 10000;
  const double dt = duration / steps;
  MicroSlip<double> exact(kappa, friction);
  double depth = 0, speed = 1, s = slip_before, ft = 0, before = 0, fn = 0, impulse = 0;
  for (int i = 0; i < 2 * steps; ++i) {
    speed -= 0.5 * dt * fn;
    s -= 0.5 * dt * 3.5 * ft;
    depth += dt * speed;
    impulse += 0.5 * dt * ft;
    if (!(depth > 0)) break;
    const double slip = s * dt;
    if (law == Across::linear) {
      fn = linear * depth;
      ft = std::clamp(ft + linear / kappa * slip, -friction * fn, friction * fn);
    } else {
      const double root = std::sqrt(depth);
      fn = depth * root;
      if (law == Across::exact) {
        ft = exact.move(depth, slip);
      } else {
        if (law == Across::hertz_rescaled && depth < before) ft *= root / std::sqrt(before);
        ft = std::clamp(ft + 1.5 * root / kappa * slip, -friction * fn, friction * fn);
      }
    }
    before = depth;
    impulse += 0.5 * dt * ft;
    speed -= 0.5 * dt * fn;
    s -= 0.5 * dt * 3.5 * ft;
  }
  return {s / friction, -2.5 * impulse / friction, 1 - impulse / slip_before};
}

}  // namespace laws
