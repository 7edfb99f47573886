#include "libcontact/laws/mix.h"

#include <algorithm>
#include <cmath>
#include <limits>
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
  const auto compliance_twist = [](const Material& m) { return m.rigid ? 0.0 : 2 * (1 + m.poisson) / m.young; };
  // What a rigid partner has no part in.
  const auto of_the_soft = [&](double Material::*x, auto&& both) {
    return a.rigid ? b.*x : b.rigid ? a.*x : both(a.*x, b.*x);
  };
  const auto in_series = [](double x, double y) { return x > 0 && y > 0 ? 2 * x * y / (x + y) : 0.0; };
  const auto mean = [](double x, double y) { return 0.5 * (x + y); };
  const auto weaker = [](double x, double y) { return std::min(x, y); };
  const auto endless = [](double x) { return x > 0 ? x : std::numeric_limits<double>::infinity(); };
  PairParameters p;
  p.young_eff = 1 / (compliance_e(a) + compliance_e(b));
  p.shear_eff = 1 / (compliance_g(a) + compliance_g(b));
  p.shear_twist = 1 / (compliance_twist(a) + compliance_twist(b));
  p.stiffness_n = of_the_soft(&Material::stiffness, in_series);
  // 1/κ = 4 G*/E*; for like solids 2(1−ν)/(2−ν). Without moduli (linear law) the mean Poisson ratio serves.
  const bool moduli = (a.rigid || a.young > 0) && (b.rigid || b.young > 0);
  const double nu = 0.5 * (a.poisson + b.poisson);
  p.stiffness_t = p.stiffness_n * (moduli ? 4 * p.shear_eff / p.young_eff : 2 * (1 - nu) / (2 - nu));
  p.friction = std::min(a.friction, b.friction);
  p.plastic_stiffness = of_the_soft(&Material::plastic_stiffness, in_series);
  p.adhesive_stiffness = of_the_soft(&Material::adhesive_stiffness, in_series);
  p.plastic_depth = of_the_soft(&Material::plastic_depth, mean);
  p.viscous_time = of_the_soft(&Material::viscous_time, mean);
  // The softer one yields.
  p.yield_pressure = std::min(a.rigid ? std::numeric_limits<double>::infinity() : endless(a.yield_pressure),
                              b.rigid ? std::numeric_limits<double>::infinity() : endless(b.yield_pressure));
  p.work_of_adhesion = std::sqrt(a.work_of_adhesion) * std::sqrt(b.work_of_adhesion);  // Berthelot
  p.rolling_friction = weaker(a.rolling_friction, b.rolling_friction);
  p.rolling_viscosity = weaker(a.rolling_viscosity, b.rolling_viscosity);
  p.rolling_damping = weaker(a.rolling_damping, b.rolling_damping);
  p.twisting_friction = weaker(a.twisting_friction, b.twisting_friction);
  p.cohesion = weaker(a.cohesion, b.cohesion);
  p.contact_angle = mean(a.contact_angle, b.contact_angle);
  p.wetting = mean(std::cos(a.contact_angle), std::cos(b.contact_angle));
  set_restitution(p, std::min(a.restitution, b.restitution), clip);
  return p;
}

void set_restitution(PairParameters& p, double restitution, bool clip) {
  p.restitution = restitution;
  p.damping = damping_of(restitution, clip);
  p.loading_ratio = restitution * restitution;
}

}  // namespace contact
