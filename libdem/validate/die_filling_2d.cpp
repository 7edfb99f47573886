// A shoe that moves over a die: up to a critical speed v_c the die is full afterwards, above it the fill goes down as
// (v_c / v)^n. Published n of powders lie between 0.9 and 1.7; the band is wider by a tenth, for few and coarse grains.
//
// Fill is the mass in the die below its rim, over that which a shoe at 0.05 m/s leaves, the slowest of the range. Full
// is a fill of 0.95 or more: a row of grains across the die is 4 % of it (ten of 225), and a surface is even to a
// grain. The power law is fitted to every speed at which the die is not full; none is left out.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "libdem/validate/validation.h"

namespace dem::validate {

namespace {

constexpr double width = 0.04, depth = 0.09;  // of the die in the scene, from x = 0 on and from y = 0 down, m
constexpr double way = 0.14, settling = 0.2;  // of the shoe: m, s after it has stopped
constexpr double full = 0.95;                 // fill from which on the die is full

// Area of the grains whose centre is in the die, over that of the die.
double solid_fraction(const World& w) {
  double area = 0;
  for (std::size_t i = 0; i < w.particles.count(); ++i) {
    const Vec3d& x = w.particles.motion[i].position;
    if (!(x.x > 0 && x.x < width && x.y > -depth && x.y < 0)) continue;
    const double scale = w.particles.size[i].x;
    area += w.shapes[w.particles.shape[i]].volume / w.scene.thickness * scale * scale;
  }
  return area / (width * depth);
}

// Of what a shoe of this speed, m/s, leaves in the die; mean over seeds.
double solid_fraction_after(Runs& runs, double speed, int seeds) {
  const double departure = wall_named(runs.build(), "shoe rear").motion.start, stop = departure + way / speed;
  double sum = 0;
  for (int seed = 1; seed <= seeds; ++seed) {
    std::vector<std::string> overrides{fmt::format("run.seed={}", seed), fmt::format("run.time={}", stop + settling)};
    for (const char* plate : {"shoe rear", "shoe front"}) {
      overrides.push_back(fmt::format("wall.{}.velocity=[{}, 0, 0]", plate, speed));
      overrides.push_back(fmt::format("wall.{}.stop={}", plate, stop));
    }
    sum += solid_fraction(runs.run(overrides, fmt::format("v_{}_seed_{}", speed, seed)));
  }
  return sum / seeds;
}

}  // namespace

extern const Validation die_filling_2d;
const Validation die_filling_2d{
    "die_filling_2d", "die_filling_2d.toml", "a slow shoe fills the die, a fast one as a power of its speed",
    [](Runs& runs) -> std::vector<Row> {
      const double reference = solid_fraction_after(runs, 0.05, 1);
      std::vector<Row> rows{for_information("solid fraction in the die at 0.05 m/s", reference)};
      double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;  // of the line through log fill against log speed
      double fastest_full = 0.05, slowest_short = 1;   // speeds, m/s
      const std::vector<double> speeds{0.1, 0.2, 0.35, 0.5, 0.7, 1};
      for (const double speed : speeds) {
        const double fill = solid_fraction_after(runs, speed, speed < 0.3 ? 1 : 2) / reference;
        rows.push_back(for_information(fmt::format("fill at {} m/s", speed), fill));
        if (fill >= full) {
          fastest_full = speed;
          continue;
        }
        slowest_short = std::min(slowest_short, speed);
        const double x = std::log(speed), y = std::log(fill);
        n += 1;
        sx += x;
        sy += y;
        sxx += x * x;
        sxy += x * y;
      }
      const double slope = (n * sxy - sx * sy) / (n * sxx - sx * sx);
      rows.push_back(is_true("full at every speed below those at which it is not, and at 0.1 m/s",
                             fastest_full >= 0.1 && fastest_full < slowest_short, "full, then not",
                             fmt::format("full up to {} m/s, not from {} m/s", fastest_full, slowest_short)));
      rows.push_back(at_least("number of speeds at which it is not full", n, 3));
      rows.push_back(in_band("slope of log fill against log speed at these", slope, -1.8, -0.8));
      rows.push_back(
          for_information("v_c, where their line is at a full die", std::exp((sx * slope - sy) / (n * slope)), "m/s"));
      return rows;
    }};

}  // namespace dem::validate
