// Five boxes on a plane: flat faces on flat faces come to rest, and the floor carries their weight.
#include <algorithm>
#include <cmath>

#include "libdem/validate/validation.h"

namespace dem::validate {

extern const Validation box_stack;
const Validation box_stack{
    "box_stack", "box_stack.toml", "five boxes come to rest, stay upright, and the floor carries their weight",
    [](Runs& runs) -> std::vector<Row> {
      const World start = runs.build();
      const World w = runs.run();
      double mass = 0, tilt = 0, speed = 0, shift = 0, size = 0;
      for (std::size_t i = 0; i < w.particles.count(); ++i) {
        mass += w.particles.mass[i];
        size = std::max(size, w.particles.motion[i].equivalent_radius);
        speed = std::max(speed, norm(w.particles.motion[i].velocity));
        tilt =
            std::max(tilt, std::acos(std::min(1.0, shapes::rotation_matrix(w.particles.orientation[i]).column(2).z)));
      }
      const auto before = order_by_id(start), after = order_by_id(w);
      for (std::size_t k = 0; k < after.size(); ++k) {
        const Vec3d d = w.particles.motion[after[k]].position - start.particles.motion[before[k]].position;
        shift = std::max(shift, std::hypot(d.x, d.y));
      }
      const double g = norm(w.scene.gravity);
      return {within("force on the floor", -w.walls[0].force.z, mass * g, 1e-3, "N"),
              at_most("largest speed over that of a fall through one size", speed / std::sqrt(2 * g * size), 1e-3),
              at_most("largest tilt", tilt * 180 / 3.14159265358979, 0.1, "degrees"),
              at_most("largest shift sideways over size", shift / size, 0.01)};
    }};

}  // namespace dem::validate
