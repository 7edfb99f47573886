// A face-centred cubic array in axisymmetric compression: the ratio of stresses at failure is exactly
// 2 (1 + μ) / (1 − μ) for rigid spheres (Thornton, Géotechnique 29, 1979).
//
// The exact state is uniform: every inclined contact carries N and μN. Spheres along the horizontal edges have one such
// contact each, so nothing balances the torque of μN there: they roll, and the walls of a small array see a little less
// than the inside of it (the error goes down as one over the number of planes). Both are judged: forces on walls over
// areas, and contact forces of the middle half (Love's average), as published checks of this answer do.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "libdem/validate/validation.h"

namespace dem::validate {

namespace {

struct Box {
  Vec3d lower, upper;
};

// Of the centres, at the start: the middle half along each axis.
std::vector<bool> in_the_middle(const World& w) {
  const double most = std::numeric_limits<double>::max();
  Box all{{most, most, most}, {-most, -most, -most}};
  for (const contact::Motion& m : w.particles.motion)
    for (int k = 0; k < 3; ++k) {
      all.lower[k] = std::min(all.lower[k], m.position[k]);
      all.upper[k] = std::max(all.upper[k], m.position[k]);
    }
  const Vec3d centre = (all.lower + all.upper) * 0.5, quarter = (all.upper - all.lower) * 0.25;
  std::vector<bool> middle(w.particles.count());
  for (std::size_t i = 0; i < middle.size(); ++i) {
    bool inside = true;
    for (int k = 0; k < 3; ++k)
      inside = inside && std::abs(w.particles.motion[i].position[k] - centre[k]) < 1.05 * quarter[k];
    middle[w.particles.id[i]] = inside;
  }
  return middle;
}

// sigma_zz / sigma_xx from the contacts of some bodies: stress is the sum of force times arm over a volume.
double ratio_inside(const World& w, const std::vector<bool>& bodies) {
  Vec3d sum{};
  for (const ContactReport& c : touching_contacts(w)) {
    const int sides = (bodies[c.a] ? 1 : 0) + (!c.wall && bodies[c.b] ? 1 : 0);
    for (int k = 0; k < 3; ++k) sum[k] += sides * c.force[k] * c.normal[k];
  }
  return 2 * sum.z / (sum.x + sum.y);
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
