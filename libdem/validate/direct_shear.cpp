// Direct shear under three loads: the strength grows in proportion to the load, so that the line through the stresses
// goes through the origin (no cohesion). Stresses of a box of twenty spheres fluctuate by a tenth: they are means over
// the second half of the way, and of three fillings.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "libdem/validate/validation.h"

namespace dem::validate {

namespace {

struct Stresses {
  double normal = 0, shear = 0;  // Pa, means over the second half of the way
};

// What the contacts carry across the plane between the halves and four more, up to a sphere above and below it, in the
// middle half of the box; mean of the five.
Stresses about_the_plane(const World& w) {
  const WallSpec& box = wall_named(w, "lower").motion;
  const double moved = wall_named(w, "upper").position.x, plane = box.upper.z;
  const double centre = 0.5 * (box.lower.x + box.upper.x + moved), half = 0.25 * (box.upper.x - box.lower.x);
  std::vector<double> height(w.particles.count());
  for (std::size_t i = 0; i < height.size(); ++i) height[w.particles.id[i]] = w.particles.motion[i].position.z - plane;
  const double radius = w.particles.motion[0].bounding_radius, area = 2 * half * (box.upper.y - box.lower.y);
  Stresses s;
  for (const ContactReport& c : touching_contacts(w)) {
    if (c.wall || std::abs(c.point.x - centre) > half) continue;
    for (int k = -2; k <= 2; ++k) {
      const bool above = height[c.a] > k * radius;
      if (above == (height[c.b] > k * radius)) continue;
      const double sign = above ? 1 : -1;  // the force on the sphere above
      s.normal += sign * c.force.z / (5 * area);
      s.shear -= sign * c.force.x / (5 * area);
    }
  }
  return s;
}

Stresses shear(Runs& runs, double pressure, int seed) {
  // The scene's speed is that under its own pressure; the same inertial number, hence the root, under another one.
  const World scene = runs.build();
  const double begin = wall_named(scene, "upper").motion.start;
  const double faster = std::sqrt(pressure / wall_named(scene, "lid").motion.target_pressure);
  const double speed = faster * wall_named(scene, "upper").motion.velocity.x;
  const double end = begin + (scene.scene.run.time - begin) / faster;
  const std::vector<std::string> load{
      fmt::format("run.seed={}", seed), fmt::format("wall.lid.target_pressure={}", pressure),
      fmt::format("run.time={}", end), fmt::format("wall.upper.velocity=[{}, 0, 0]", speed),
      fmt::format("wall.apron.velocity=[{}, 0, 0]", speed)};
  Stresses sum;
  double n = 0;
  runs.run(load, fmt::format("{:.0f}_Pa_{}", pressure, seed), [&](const World& w) {
    if (w.time() < begin + 0.5 * (end - begin) || w.step % 50 != 0) return;
    const Stresses now = about_the_plane(w);
    sum.normal += now.normal;
    sum.shear += now.shear;
    n += 1;
  });
  return {sum.normal / n, sum.shear / n};
}

struct Envelope {
  double slope = 0, cohesion = 0, r_squared = 0;
};

Envelope envelope(const std::array<Stresses, 3>& points) {  // least squares
  double x = 0, y = 0, xx = 0, xy = 0, yy = 0;              // means, and sums about them
  for (const Stresses& p : points) {
    x += p.normal / 3;
    y += p.shear / 3;
  }
  for (const Stresses& p : points) {
    xx += (p.normal - x) * (p.normal - x);
    xy += (p.normal - x) * (p.shear - y);
    yy += (p.shear - y) * (p.shear - y);
  }
  return {xy / xx, y - xy / xx * x, xy * xy / (xx * yy)};
}

}  // namespace

extern const Validation direct_shear;
const Validation direct_shear{
    "direct_shear", "direct_shear.toml", "shear strength is proportional to the load",
    [](Runs& runs) -> std::vector<Row> {
      constexpr std::array<double, 3> loads{5e3, 10e3, 20e3};  // Pa
      std::array<Stresses, 3> mean;
      double least = std::numeric_limits<double>::max(), most = -least;  // cohesion of single fillings, Pa
      for (int seed = 1; seed <= 3; ++seed) {
        std::array<Stresses, 3> points;
        for (std::size_t i = 0; i < 3; ++i) {
          points[i] = shear(runs, loads[i], seed);
          mean[i].normal += points[i].normal / 3;
          mean[i].shear += points[i].shear / 3;
        }
        least = std::min(least, envelope(points).cohesion);
        most = std::max(most, envelope(points).cohesion);
      }
      const Envelope line = envelope(mean);
      return {at_least("R^2 of the straight envelope", line.r_squared, 0.98),
              near("cohesion", line.cohesion, 0, 0.05 * loads[0], "Pa"),
              for_information("cohesion, least of the fillings", least, "Pa"),
              for_information("cohesion, most of the fillings", most, "Pa"),
              for_information("angle of friction", std::atan(line.slope) * 180 / std::numbers::pi, "deg")};
    }};

}  // namespace dem::validate
