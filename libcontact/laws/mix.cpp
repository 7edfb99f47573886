#include "libcontact/laws/mix.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace contact {

double clipped_restitution(double beta) {
  if (beta <= 0) return 1;
  const double d = (1 - beta) * (1 + beta);
  // Near β = 1 both branches lose digits: acos(β)/sqrt(1−β²) = 1 + (1−β)/3 + 2(1−β)²/15·… is analytic there.
  const double x = 1 - beta;
  double ratio;
  if (std::abs(x) < 1e-3)
    ratio = 1 + x * (1.0 / 3 + x * (2.0 / 15 + x * (2.0 / 35 + x * (8.0 / 315 + x * (8.0 / 693)))));
  else if (beta < 1)
    ratio = std::acos(beta) / std::sqrt(d);
  else
    ratio = std::acosh(beta) / std::sqrt(-d);
  return std::exp(-2 * beta * ratio);
}

double clipped_damping(double restitution) {
  if (restitution >= 1) return 0;
  double low = 0, high = 1;
  while (clipped_restitution(high) > restitution) high *= 2;
  for (int i = 0; i < 200 && high - low > 0x1p-52 * high; ++i) {
    const double middle = 0.5 * (low + high);
    (clipped_restitution(middle) > restitution ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

double unclipped_damping(double restitution) {
  if (restitution <= 0) return 1;
  const double l = -std::log(restitution);
  return l / std::hypot(std::numbers::pi, l);
}

PairParameters mix(const Material& a, const Material& b, bool clip) {
  const auto compliance_e = [](const Material& m) { return m.rigid ? 0.0 : (1 - m.poisson * m.poisson) / m.young; };
  const auto compliance_g = [](const Material& m) {
    return m.rigid ? 0.0 : (2 - m.poisson) * 2 * (1 + m.poisson) / m.young;
  };
  PairParameters p;
  p.young_eff = 1 / (compliance_e(a) + compliance_e(b));
  p.shear_eff = 1 / (compliance_g(a) + compliance_g(b));
  if (a.rigid || b.rigid)
    p.stiffness_n = a.rigid ? b.stiffness : a.stiffness;
  else
    p.stiffness_n =
        a.stiffness > 0 && b.stiffness > 0 ? 2 * a.stiffness * b.stiffness / (a.stiffness + b.stiffness) : 0;
  // 1/κ = 4 G*/E*; for like solids 2(1−ν)/(2−ν). Without moduli (linear law) the mean Poisson ratio serves.
  const bool moduli = (a.rigid || a.young > 0) && (b.rigid || b.young > 0);
  const double nu = 0.5 * (a.poisson + b.poisson);
  p.stiffness_t = p.stiffness_n * (moduli ? 4 * p.shear_eff / p.young_eff : 2 * (1 - nu) / (2 - nu));
  p.friction = std::min(a.friction, b.friction);
  p.restitution = std::min(a.restitution, b.restitution);
  p.damping = damping_of(p.restitution, clip);
  return p;
}

}  // namespace contact
