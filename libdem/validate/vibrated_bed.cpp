// A sphere on a vibrating plate leaves it when the plate's downward acceleration passes gravity: at the phase
// asin(1/Γ), Γ = amplitude ω²/g; never when Γ < 1.
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "libdem/validate/validation.h"

namespace dem::validate {

namespace {

// Body i lives on plate i. Its overlap there, m; below 0: the gap.
double overlap(const World& w, std::size_t plate, std::uint32_t body) {
  const contact::Motion& m = w.particles.motion[body];
  return w.walls[plate].position.z - (m.position.z - m.bounding_radius);
}

}  // namespace

extern const Validation vibrated_bed;
const Validation vibrated_bed{
    "vibrated_bed", "vibrated_bed.toml", "no flight below 1 g; above it take-off at the phase asin(1/G)",
    [](Runs& runs) -> std::vector<Row> {
      const std::size_t plates = runs.build().walls.size();
      std::vector<double> before(plates), left(plates, -1);  // overlap a step ago; time of the first take-off, s
      const World w = runs.run({}, "", [&](const World& now) {
        const auto body = order_by_id(now);
        for (std::size_t i = 0; i < plates; ++i) {
          const double here = overlap(now, i, body[i]);
          if (left[i] < 0 && here <= 0)  // straight in between
            left[i] = now.time() - now.time_step.dt * (before[i] > here ? -here / (before[i] - here) : 0);
          before[i] = here;
        }
      });
      std::vector<Row> rows;
      const double degrees = 180 / std::numbers::pi;
      for (std::size_t i = 0; i < plates; ++i) {
        const WallSpec& plate = w.scene.walls[i];
        const double omega = 2 * std::numbers::pi * plate.frequency;
        const double strength = plate.amplitude.z * omega * omega / -w.scene.gravity.z;
        if (strength < 1) {
          rows.push_back(is_true(fmt::format("no flight at G = {:.2f}", strength), left[i] < 0, "none",
                                 left[i] < 0 ? "none" : fmt::format("at {:.4f} s", left[i])));
          continue;
        }
        rows.push_back(near(fmt::format("take-off phase at G = {:.2f}", strength),
                            (omega * left[i] + plate.phase) * degrees, std::asin(1 / strength) * degrees, 0.5, "deg"));
      }
      // What the compliance of the contact may add: omega / omega_c.
      const double contact = std::sqrt(w.scene.materials[0].stiffness / w.particles.mass[0]);
      rows.push_back(at_most("phase by which a soft contact separates late",
                             2 * std::numbers::pi * w.scene.walls[0].frequency / contact * degrees, 0.1, "deg"));
      return rows;
    }};

}  // namespace dem::validate
