// Oblique impact of two spheres that slide throughout: velocities and spins after it follow from the impulses alone
// (see the scene), but for the turn of the line of centres during the impact.
#include <algorithm>
#include <cmath>

#include "libdem/validate/validation.h"

namespace dem::validate {

extern const Validation two_bodies;
const Validation two_bodies{
    "two_bodies", "two_bodies.toml",
    "velocities and spins after an oblique impact in the sliding regime: impulse balance",
    [](Runs& runs) -> std::vector<Row> {
      const World start = runs.build();
      const World w = runs.run();
      const MaterialSpec& m = w.scene.materials[0];
      const double e = m.restitution, mu = m.friction, radius = w.shapes[0].size.x;
      const auto of = [](const World& world, std::size_t id) { return world.particles.motion[order_by_id(world)[id]]; };
      const double v = of(start, 0).velocity.x - of(start, 1).velocity.x;  // closing speed, m/s
      const double slip = of(start, 0).velocity.y - of(start, 1).velocity.y;
      const double normal = 0.5 * (1 + e) * v;  // impulse over mass, m/s
      std::vector<Row> rows;
      rows.push_back(
          is_true("slides throughout", slip > 3.5 * mu * (1 + e) * v, "slip > 3.5 mu (1 + e) v", "by the scene"));
      const contact::Motion a = of(w, 0), b = of(w, 1);
      rows.push_back(within("restitution", (b.velocity.x - a.velocity.x) / v, e, 0.02));
      rows.push_back(within("slip velocity after", a.velocity.y - b.velocity.y, slip - 2 * mu * normal, 0.02, "m/s"));
      rows.push_back(within("spin", -a.spin.z, 2.5 * mu * normal / radius, 0.02, "rad/s"));
      const double difference = norm(a.spin - b.spin) / norm(a.spin);
      rows.push_back(at_most("difference of the two spins", difference, 1e-9));
      const Vec3d p = momentum(w);
      rows.push_back(at_most("momentum, relative", norm(p) / (w.particles.mass[0] * norm(a.velocity)), 1e-12));
      return rows;
    }};

}  // namespace dem::validate
