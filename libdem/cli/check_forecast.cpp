// dem check: the time step against its limits, the loads, the cost.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "libdem/cli/check_parts.h"
#include "libdem/cli/progress.h"

namespace dem::cli {

namespace {

using forecast::PairForecast;

std::string pair_name(const World& world, const std::vector<BodyGroup>& groups, const PairLimit& l) {
  const auto name = [&](const BodyGroup& g) {
    const std::string& shape = world.shapes[g.shape].name;
    return world.scene.materials.size() > 1 ? shape + " of " + world.scene.materials[g.material].name : shape;
  };
  return name(groups[l.group]) + " on " + (l.wall ? "wall " + world.walls[l.partner].name : name(groups[l.partner]));
}

std::string seconds_text(double s) { return std::isfinite(s) ? fmt::format("{:.3e}", s) : std::string("-"); }
std::string radii_text(double share) {
  return share < 1e-4 ? fmt::format("{:.1e}", share) : fmt::format("{:.2g}", share);
}

}  // namespace

void print_time_step(const World& world, const std::vector<BodyGroup>& groups, const forecast::Loads& loads,
                     const std::vector<PairForecast>& pairs) {
  head("time");
  const TimeStep& t = world.time_step;
  const std::uint64_t steps = total_steps(world);
  line("dt",
       fmt::format("{:.6g} s ({}{:.3g} of the limit)", t.dt, world.scene.run.dt_auto ? "auto, " : "", t.dt / t.limit));
  line("limit",
       std::isfinite(t.limit) ? fmt::format("{:.6g} s: {}", t.limit, t.limited_by) : "none: nothing can touch");
  line("steps", fmt::format("{} to t = {:.6g} s", steps, static_cast<double>(steps) * t.dt));
  line("skin", fmt::format("{:.4g} m{}", world.skin,
                           world.scene.run.skin >= 0 ? "" : ", auto: of bodies at rest; more where they move"));
  for (const forecast::RayleighTime& r : forecast::rayleigh_times(world))
    line("Rayleigh", fmt::format("{:.4g} s for {} of radius {:.3g} m; dt is {:.2g} of it", r.time,
                                 world.scene.materials[r.material].name, r.radius, t.dt / r.time));

  constexpr std::size_t shown = 10;
  std::vector<PairForecast> sorted = pairs;
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const PairForecast& a, const PairForecast& b) { return a.limit.limit() < b.limit.limit(); });
  if (sorted.empty()) return;
  head(fmt::format("limits of the step, s, tightest first (stiffness at {} radii, {} contacts a body)",
                   world.scene.run.dt_overlap, world.scene.run.dt_contacts));
  std::size_t width = 4;
  const std::size_t rows = std::min(shown, sorted.size());
  for (std::size_t i = 0; i < rows; ++i) width = std::max(width, pair_name(world, groups, sorted[i].limit).size());
  const std::string impact = loads.impact > 0 ? fmt::format("collision at {:.3g} m/s", loads.impact) : "collision";
  fmt::print("  {:<{}}  {:<10} {:<10} {:<24} {}\n", "pair", width, "normal", "tangential", impact, "dt / limit");
  for (std::size_t i = 0; i < rows; ++i) {
    const PairForecast& p = sorted[i];
    fmt::print("  {:<{}}  {:<10} {:<10} {:<24} {:.3g}\n", pair_name(world, groups, p.limit), width,
               seconds_text(p.limit.normal), seconds_text(p.limit.tangential), seconds_text(p.duration),
               t.dt / p.limit.limit());
  }
  if (sorted.size() > shown)
    fmt::print("  and {} pairs more, from {:.3e} s\n", sorted.size() - shown, sorted[shown].limit.limit());
}

void print_loads(const World& world, const forecast::Loads& loads, const std::vector<PairForecast>& pairs) {
  head("loads to expect");
  if (loads.fall > 0)
    line("fall", fmt::format("up to {:.3g} m{}", loads.fall,
                             loads.fall_time > 0 ? fmt::format(", for {:.3g} s", loads.fall_time) : std::string()));
  if (loads.wall_speed > 0) line("walls", fmt::format("up to {:.3g} m/s", loads.wall_speed));
  if (loads.flow_speed > 0) line("box", fmt::format("neighbours in its flow up to {:.3g} m/s", loads.flow_speed));
  double impact = 0, press = 0;
  for (const PairForecast& p : pairs) {
    impact = std::max(impact, p.impact_overlap);
    press = std::max(press, p.press_overlap);
  }
  if (loads.impact > 0)
    line("impact", fmt::format("at {:.3g} m/s, undamped: overlap up to {} radii", loads.impact, radii_text(impact)));
  else
    line("impact", "none: nothing moves or is moved");
  for (const forecast::Pressure& p : loads.pressures) {
    const bool weight = &p == loads.pressures.data() && norm(world.scene.gravity) > 0;
    line("pressure", fmt::format("{:.3g} Pa by the {}{}", p.value, p.source,
                                 weight ? fmt::format(", {:.3g} m high at a solid fraction of {}", loads.bed_height,
                                                      loads.solid_fraction)
                                        : std::string()));
  }
  if (!loads.pressures.empty())
    line("under it", fmt::format("overlap {} radii in the mean of the contacts", radii_text(press)));
}

void print_cost(const forecast::Cost& c, double base) {
  head("cost, measured now on copies of the scene");
  const auto ms = [](double s) { return fmt::format("{:.3g} ms", 1e3 * s); };
  line("step", c.packs ? fmt::format("{} as it begins, {} packed; rebuild of the list {}, {:.3g} times",
                                     ms(c.beginning.step), ms(c.packed.step), ms(c.packed.rebuild), c.rebuilds)
                       : fmt::format("{}; rebuild of the list {}, {:.3g} times", ms(c.beginning.step),
                                     ms(c.beginning.rebuild), c.rebuilds));
  line("output", fmt::format("{} frames of {}, {} checkpoints of {}, picture {}", c.frames, ms(c.frame), c.checkpoints,
                             ms(c.checkpoint), ms(c.picture)));
  std::string time = fmt::format("{} on one thread", duration_text(c.total));
  if (c.threads > 1) time += fmt::format(", {} on {}", duration_text(c.total_on_threads), c.threads);
  line("time", time);
  line("memory", rate_text(base + c.memory.total() + c.picture_memory) + "B");
  line("disk", rate_text(c.disk) + "B");
}

}  // namespace dem::cli
