// Work over closed paths in the overlap, both directions of slip and the relative rotation: from apart and back, and
// again and again within a contact. What a law gives back more than it was given it has created.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "bench/laws/contacts.h"
#include "bench/laws/report.h"
#include "shapes/math/random.h"

namespace laws {
namespace {

constexpr int harmonics = 3, motions = 6;  // overlap, slip x, y, rotation x, y, z
constexpr double depth_unit = 1e-5, radius = 1e-3;

// A closed path by numbers between −1 and 1.
struct Loop {
  std::array<double, 3 + 2 * harmonics * motions> number;
  bool within = false;  // the bodies stay in contact

  explicit Loop(std::uint64_t seed) {
    shapes::Random random(seed, 3, 0);
    for (double& x : number) x = random.uniform(-1, 1);
    within = seed % 2 == 0;
  }
  struct Place {
    double overlap;
    Vec3d slip, turn;
  };
  Place at(double u) const {
    const double depth = depth_unit * std::exp(1.5 * number[0]);
    const double slip = depth * std::exp(-1.5 + 2 * number[1]), turn = depth / radius * std::exp(-1 + 2 * number[2]);
    double wave[motions] = {};
    std::size_t n = 3;
    for (double& w : wave)
      for (int j = 1; j <= harmonics; ++j) {
        const double amplitude = number[n++] / j, phase = std::numbers::pi * number[n++];
        w += amplitude * (std::sin(2 * std::numbers::pi * j * u + phase) - std::sin(phase));
      }
    const double rise = std::sin(std::numbers::pi * u);
    const double overlap = within ? depth * (1 + 0.8 * std::tanh(wave[0])) : depth * rise * rise * std::exp(wave[0]);
    return {overlap, Vec3d{wave[1], wave[2], 0} * slip, Vec3d{wave[3], wave[4], wave[5]} * turn};
  }
};

// Least of work − gain in stored energy, of each lap; over the largest energy stored.
double gain(const LawContact& c, const Loop& loop, int steps) {
  Drive drive(c);
  double least = 1e300, largest = 0;
  Loop::Place now = loop.at(0);
  Move move;
  if (loop.within) {
    move.overlap = now.overlap;
    drive.step(move);
  }
  for (int lap = 0; lap < (loop.within ? 3 : 1); ++lap) {
    double work = 0, kept = drive.answer().energy;
    for (int i = 1; i <= steps; ++i) {
      const Loop::Place next = loop.at(i == steps ? 0 : static_cast<double>(i) / steps);
      move.dt = 1.0 / steps;
      move.overlap = next.overlap;
      const Vec3d slip = next.slip - now.slip;
      move.velocity = Vec3d{slip.x, slip.y, next.overlap - now.overlap} * (1 / move.dt);
      move.relative_spin = (next.turn - now.turn) * (1 / move.dt);
      now = next;
      const dem::law_driver::Answer before = drive.answer();
      const dem::law_driver::Answer& after = drive.step(move);
      work -= 0.5 * move.dt *
              (dot(before.force + after.force, move.velocity) + dot(before.moment + after.moment, move.relative_spin));
      largest = std::max(largest, std::abs(after.energy));
    }
    least = std::min(least, work - (drive.answer().energy - kept));
  }
  return largest > 0 ? least / largest : 1e300;  // they never met
}

// The worst of 400 random loops, then made worse by small changes.
Loop worst_loop(const LawContact& c, int& tried) {
  const int rough = 400;
  Loop worst(1);
  double least = 1e300;
  for (std::uint64_t seed = 1; seed <= 400; ++seed, ++tried) {
    const Loop loop(seed);
    const double g = gain(c, loop, rough);
    if (g < least) least = g, worst = loop;
  }
  shapes::Random random(11, 0, 0);
  double reach = 0.3;
  for (int i = 0; i < 600; ++i, ++tried) {
    Loop next = worst;
    for (double& x : next.number)
      if (random.uniform() < 0.3) x = std::clamp(x + reach * random.uniform(-1, 1), -1.0, 1.0);
    const double g = gain(c, next, rough);
    if (g < least)
      least = g, worst = next;
    else
      reach = std::max(0.01, 0.99 * reach);
  }
  return worst;
}

}  // namespace

void loops(Report& r) {
  r.heading("400 random loops and 600 that make the worst one worse: least work of a lap, less the gain of stored");
  r.heading("energy, over the largest energy stored; at a step where halving changes it by less than 1e-10, or stated");
  for (const LawNames& n : every_law()) {
    for (const bool varied : {false, true}) {
      // What is not the default: a spring that is not shortened, Box 9.1 with its deficit.
      LawOptions options = wet();
      const bool coulomb =
          n.normal == "hertz" && n.tangential == "coulomb_spring" && n.rolling == "none" && n.cohesion == "none";
      const bool box = n.tangential == "mindlin_deresiewicz";
      if (varied && !coulomb && !box) continue;
      if (varied && coulomb) options.rescale = false;
      if (varied && box) options.deficit = !options.deficit;
      Material m = stone();
      m.restitution = 1;
      m.viscous_time = 0;
      LawContact c = contact_of(n, m, m, options);
      c.pair.loading_ratio = 0.36;
      c.radius_eff = radius;
      c.mass_eff = 1e-5;
      int tried = 0;
      const Loop loop = worst_loop(c, tried);
      double value = gain(c, loop, 1000), change = 1;
      int steps = 1000;
      while (steps < 2000000) {
        steps *= 2;
        const double finer = gain(c, loop, steps);
        change = std::abs(finer - value);
        value = finer;
        if (change < 1e-10 || std::abs(value) > 100 * change) break;
      }
      const std::string item = fmt::format(
          "{}{}, {} steps, halving changes it by {:.0e}", title(n),
          varied ? coulomb ? ", rescale = false" : fmt::format(", deficit = {}", options.deficit) : "", steps, change);
      // Box 9.1, by itself or after peeling, is kept as its source has it: told.
      if (varied || box || n.tangential == "thornton_peeling")
        r.note(item, value);
      else
        r.at_least(item, -std::max(1e-10, 2 * change), value);
    }
  }
}

}  // namespace laws
