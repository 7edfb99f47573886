// A face-centred cubic array in axisymmetric compression: the ratio of stresses at failure is exactly
// 2 (1 + μ) / (1 − μ) for rigid spheres (Thornton, Géotechnique 29, 1979).
//
// The exact state is uniform: every inclined contact carries N and μN. Spheres along the horizontal edges have one such
// contact each, so nothing balances the torque of μN there: they roll, and the walls of a small array see a little less
// than the inside of it (the error goes down as one over the number of planes). Both are judged: forces on walls over
// areas, and contact forces of the middle half (Love's average), as published checks of this answer do.
#include <fmt/format.h>

#include <algorithm>

#include "libdem/validate/regular_array.h"

namespace dem::validate {

namespace {

// sigma_zz / sigma_xx from the contacts of some bodies.
double ratio_inside(const World& w, const std::vector<bool>& bodies) {
  const Vec3d stress = stress_of(w, bodies);
  return 2 * stress.z / (stress.x + stress.y);
}

// The same from the walls.
double ratio_at_walls(const World& w) {
  double force[3], length[3];
  const char* const names[3][2] = {{"west", "east"}, {"south", "north"}, {"bottom", "top"}};
  for (int k = 0; k < 3; ++k) {
    const Wall &low = wall_named(w, names[k][0]), &high = wall_named(w, names[k][1]);
    force[k] = 0.5 * (high.force[k] - low.force[k]);
    length[k] = high.position[k] - low.position[k];
  }
  const double volume = length[0] * length[1] * length[2];
  const auto stress = [&](int k) { return force[k] * length[k] / volume; };
  return 2 * stress(2) / (stress(0) + stress(1));
}

}  // namespace

extern const Validation triaxial_fcc;
const Validation triaxial_fcc{
    "triaxial_fcc", "triaxial_fcc.toml", "sigma_zz / sigma_xx at failure is 2 (1 + mu) / (1 - mu)",
    [](Runs& runs) -> std::vector<Row> {
      constexpr std::uint64_t every = 50;  // steps; the ratio changes by 1e-3 of itself in as many
      std::vector<Row> rows;
      for (const double mu : {0.2, 0.3}) {
        const std::vector<std::string> friction{fmt::format("material.ball.friction={}", mu)};
        const std::vector<bool> middle = in_the_middle(runs.build(friction));
        double at_walls = 0, inside = 0, last = 0;
        runs.run(friction, fmt::format("mu_{}", mu), [&](const World& w) {
          if (w.step == 0 || w.step % every != 0) return;
          at_walls = std::max(at_walls, last = ratio_at_walls(w));
          inside = std::max(inside, ratio_inside(w, middle));
        });
        const double exact = 2 * (1 + mu) / (1 - mu);
        rows.push_back(within(fmt::format("peak ratio at the walls, mu = {}", mu), at_walls, exact, 0.03));
        rows.push_back(within(fmt::format("peak ratio in the middle, mu = {}", mu), inside, exact, 0.03));
        rows.push_back(at_most(fmt::format("ratio at the end over its peak, mu = {}", mu), last / at_walls, 0.999));
      }
      return rows;
    }};

}  // namespace dem::validate
