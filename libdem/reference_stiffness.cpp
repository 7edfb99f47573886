#include "libdem/reference_stiffness.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "libdem/build.h"
#include "libdem/insertion/rain.h"

namespace dem {

double reference_stiffness(double young_eff, double radius_eff, double mass_eff, double speed) {
  constexpr double duration = 2.868265699;  // of Hertz' impact over (m*²/(R* E*² v))^(1/5)
  constexpr double ratio = std::numbers::pi / duration;
  return ratio * ratio * std::pow(std::sqrt(mass_eff) * radius_eff * young_eff * young_eff * speed, 0.4);
}

void set_reference_stiffness(PairParameters& pair, double radius_eff, double mass_eff, double speed) {
  pair.stiffness_n = reference_stiffness(pair.young_eff, radius_eff, mass_eff, speed);
  pair.stiffness_t = pair.stiffness_n * 4 * pair.shear_eff / pair.young_eff;
}

void set_reference_stiffness(World& world) {
  const std::size_t n = world.materials.size();
  struct Largest {
    double radius = 0, mass = 0;
  };
  std::vector<Largest> largest(n);
  const auto see = [&](std::uint32_t material, double radius, double mass) {
    Largest& l = largest[material];
    if (radius > l.radius) l = {radius, mass};
  };
  const Particles& p = world.particles;
  for (std::size_t i = 0; i < p.count(); ++i) see(p.material[i], p.motion[i].equivalent_radius, p.mass[i]);
  for (const Draft& d : coming_bodies(world)) {
    const ShapeEntry& s = world.shapes[d.shape];
    const double power = s.mass_power == 3 ? d.scale * d.scale * d.scale : d.scale * d.scale;
    see(d.material, s.equivalent_radius * d.scale, world.materials[d.material].density * s.volume * power);
  }
  std::vector<char> given(n * n);
  for (const MaterialPairSpec& spec : world.scene.pairs) {
    if (std::isnan(spec.stiffness)) continue;
    const std::size_t i = material_index(world, spec.a, spec.where), j = material_index(world, spec.b, spec.where);
    given[i * n + j] = given[j * n + i] = 1;
  }
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) {
      const Largest &a = largest[i], &b = largest[j];
      PairParameters& q = world.pairs[i * n + j];
      if (given[i * n + j] != 0 || !(a.radius + b.radius > 0) || !std::isfinite(q.young_eff)) continue;
      const double radius =
          a.radius > 0 && b.radius > 0 ? a.radius * b.radius / (a.radius + b.radius) : a.radius + b.radius;
      const double mass = a.mass > 0 && b.mass > 0 ? a.mass * b.mass / (a.mass + b.mass) : a.mass + b.mass;
      set_reference_stiffness(q, radius, mass, world.scene.law.reference_speed);
    }
}

}  // namespace dem
