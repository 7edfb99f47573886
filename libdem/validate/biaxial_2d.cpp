// A hexagonal array of discs in biaxial compression across its rows: the ratio of stresses at failure is exactly
// tan 60° tan(60° + atan μ) for rigid discs.
//
// The exact state is uniform: every inclined contact carries N and μN, and the box that the centres span bears the
// stress of the infinite array: the walls' forces belong to its sides. Judged are the walls' forces over these lengths,
// and the contact forces of the middle half (Love's average).
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "libdem/validate/regular_array.h"

namespace dem::validate {

namespace {

double ratio_inside(const World& w, const std::vector<bool>& bodies) {
  const Vec3d stress = stress_of(w, bodies);
  return stress.y / stress.x;
}

double ratio_at_walls(const World& w) {
  const double diameter = 2 * w.particles.motion[0].bounding_radius;
  const Wall &west = wall_named(w, "west"), &east = wall_named(w, "east");
  const Wall &bottom = wall_named(w, "bottom"), &top = wall_named(w, "top");
  const double width = east.position.x - west.position.x - diameter;
  const double height = top.position.y - bottom.position.y - diameter;
  return (top.force.y - bottom.force.y) * height / ((east.force.x - west.force.x) * width);
}

}  // namespace

extern const Validation biaxial_2d;
const Validation biaxial_2d{
    "biaxial_2d", "biaxial_2d.toml", "sigma_yy / sigma_xx at failure is tan 60 tan(60 + atan mu)",
    [](Runs& runs) -> std::vector<Row> {
      constexpr std::uint64_t every = 20;  // steps; the ratio changes by 1e-3 of itself in as many
      std::vector<Row> rows;
      for (const double mu : {0.0, 0.1, 0.2}) {
        const std::vector<std::string> friction{fmt::format("material.disc.friction={}", mu)};
        const std::vector<bool> middle = in_the_middle(runs.build(friction));
        double at_walls = 0, inside = 0, last = 0;
        runs.run(friction, fmt::format("mu_{}", mu), [&](const World& w) {
          if (w.step == 0 || w.step % every != 0) return;
          at_walls = std::max(at_walls, last = ratio_at_walls(w));
          inside = std::max(inside, ratio_inside(w, middle));
        });
        const double lean = std::numbers::pi / 3, exact = std::tan(lean) * std::tan(lean + std::atan(mu));
        rows.push_back(within(fmt::format("peak ratio at the walls, mu = {}", mu), at_walls, exact, 0.03));
        rows.push_back(within(fmt::format("peak ratio in the middle, mu = {}", mu), inside, exact, 0.03));
        rows.push_back(at_most(fmt::format("ratio at the end over its peak, mu = {}", mu), last / at_walls, 0.999));
      }
      return rows;
    }};

}  // namespace dem::validate
