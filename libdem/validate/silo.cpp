// A silo whose wall rises slowly: what each level carries against the mass M above it follows Janssen's law
//   M_felt = M_sat (1 − exp(−M / M_sat)),   M_sat = bulk density · π R³ / (2 K μ_w).
// Simulations of narrow silos follow it once friction is mobilised all along the wall; K, the ratio of the stresses
// across and along, is then between 0.5 and 1.1.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "libdem/validate/validation.h"

namespace dem::validate {

namespace {

struct Level {
  double height = 0;           // m
  double above = 0, felt = 0;  // sums over frames: mass of the spheres above, and what of it is not on the wall, kg
};

double volume_above(double height, double centre, double radius) {  // of a sphere, m³
  const double t = std::clamp(centre + radius - height, 0.0, 2 * radius);
  return std::numbers::pi * t * t * (radius - t / 3);
}

void weigh(const World& w, std::vector<Level>& levels) {
  const double g = -w.scene.gravity.z;
  for (const contact::Motion& m : w.particles.motion) {
    const double r = m.bounding_radius, density = 1 / (m.inverse_mass * volume_above(-r, r, r));
    for (Level& level : levels) {
      const double mass = density * volume_above(level.height, m.position.z, r);
      level.above += mass;
      level.felt += mass;
    }
  }
  for (const ContactReport& c : touching_contacts(w))
    if (c.wall && w.walls[c.b].name == "silo")
      for (Level& level : levels)
        if (c.point.z > level.height) level.felt -= c.force.z / g;
}

double janssen(double above, double saturation) { return saturation * (1 - std::exp(-above / saturation)); }

double misfit(const std::vector<Level>& levels, double saturation) {
  double sum = 0;
  for (const Level& l : levels) sum += std::pow(l.felt - janssen(l.above, saturation), 2);
  return sum;
}

// The saturation of least misfit: golden sections of its logarithm, a thousandth to a thousand times the whole mass.
double fitted_saturation(const std::vector<Level>& levels) {
  const double share = (std::sqrt(5.0) - 1) / 2;
  double low = std::log(1e-3 * levels[0].above), high = std::log(1e3 * levels[0].above);
  while (high - low > 1e-6) {
    const double a = high - share * (high - low), b = low + share * (high - low);
    if (misfit(levels, std::exp(a)) < misfit(levels, std::exp(b)))
      high = b;
    else
      low = a;
  }
  return std::exp(0.5 * (low + high));
}

}  // namespace

extern const Validation silo;
const Validation silo{"silo", "silo.toml", "what the levels of a silo feel follows Janssen's law, with K of 0.5 to 1.1",
                      [](Runs& runs) -> std::vector<Row> {
                        std::vector<Level> levels;
                        double frames = 0, next = 0.85, floor = 0;
                        const World w = runs.run({}, "", [&](const World& now) {
                          if (now.time() < next) return;
                          next += 0.005;
                          const double d = 2 * now.particles.motion[0].bounding_radius;
                          if (levels.empty()) {
                            double top = 0;
                            for (const contact::Motion& m : now.particles.motion) top = std::max(top, m.position.z);
                            for (double z = 0; z < top; z += 0.5 * d) levels.push_back({z, 0, 0});
                          }
                          weigh(now, levels);
                          floor -= wall_named(now, "floor").force.z / -now.scene.gravity.z;
                          frames += 1;
                        });
                        double mean = 0, spread = 0;
                        for (Level& l : levels) {
                          l.above /= frames;
                          l.felt /= frames;
                          mean += l.felt / static_cast<double>(levels.size());
                        }
                        for (const Level& l : levels) spread += (l.felt - mean) * (l.felt - mean);
                        const double saturation = fitted_saturation(levels);
                        const double radius = wall_named(w, "silo").motion.radius,
                                     area = std::numbers::pi * radius * radius;
                        // Of the lower half, away from the floor.
                        const Level &low = levels[4], &high = levels[levels.size() / 2];
                        const double density = (low.above - high.above) / (area * (high.height - low.height));
                        const double friction = w.scene.materials[1].friction;
                        const double ratio = density * area * radius / (2 * saturation * friction);
                        return {within("what the floor feels of the mass, against the levels", floor / frames,
                                       levels[0].felt, 0.02, "kg"),
                                at_least("R^2 of Janssen's law", 1 - misfit(levels, saturation) / spread, 0.98),
                                in_band("K", ratio, 0.5, 1.1)};
                      }};

}  // namespace dem::validate
