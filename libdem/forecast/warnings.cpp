#include "libdem/forecast/warnings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace dem::forecast {
namespace {

using Warnings = std::vector<std::string>;

struct Sizes {
  double smallest = std::numeric_limits<double>::infinity(), largest = 0;  // equivalent radii, m
  Vec3d lower{}, upper{};                                                  // of the centres, m
  double fastest = 0;                                                      // m/s
};
Sizes sizes_of(const World& world) {
  Sizes s;
  const auto& motion = world.particles.motion;
  for (std::size_t i = 0; i < motion.size(); ++i) {
    const Motion& m = motion[i];
    s.smallest = std::min(s.smallest, m.equivalent_radius);
    s.largest = std::max(s.largest, m.equivalent_radius);
    s.fastest = std::max(s.fastest, norm(m.velocity));
    for (int k = 0; k < 3; ++k) {
      s.lower[k] = i == 0 ? m.position[k] : std::min(s.lower[k], m.position[k]);
      s.upper[k] = i == 0 ? m.position[k] : std::max(s.upper[k], m.position[k]);
    }
  }
  return s;
}

void body_hints(const World& world, const Sizes& s, Warnings& hints) {
  if (s.largest > 1)
    hints.push_back(fmt::format("bodies of radius {:.3g} m: are lengths in mm? They must be in m", s.largest));
  if (s.smallest < 1e-7)
    hints.push_back(fmt::format("bodies of radius {:.3g} m are smaller than any grain: are lengths in m?", s.smallest));
  if (s.largest > 100 * s.smallest)
    hints.push_back(fmt::format("the largest body is {:.3g} times the smallest: the neighbour search will be slow",
                                s.largest / s.smallest));
  if (s.fastest > 1000)
    hints.push_back(fmt::format("a body starts at {:.3g} m/s: are speeds in mm/s? They must be in m/s", s.fastest));
  if (const double h = world.scene.thickness; h > 0 && (h > 100 * s.largest || h < 0.01 * s.smallest))
    hints.push_back(fmt::format("world.thickness {:.3g} m beside radii of {:.3g} to {:.3g} m: are both in m?", h,
                                s.smallest, s.largest));
}

// The parts of a rigid body usually hang together; where they do not, a place is wrong.
void part_hints(const World& world, Warnings& hints) {
  for (const ShapeEntry& s : world.shapes) {
    if (!s.compound) continue;
    std::vector<std::uint32_t> reached{0};
    for (std::size_t k = 0; k < reached.size(); ++k)
      for (const std::uint32_t next : s.compound->parts[reached[k]].neighbours)
        if (std::find(reached.begin(), reached.end(), next) == reached.end()) reached.push_back(next);
    if (reached.size() < s.compound->parts.size())
      hints.push_back(fmt::format("\"{}\": {} of its {} parts touch none of the others: are their places right?",
                                  s.name, s.compound->parts.size() - reached.size(), s.compound->parts.size()));
  }
}

void material_hints(const World& world, Warnings& hints) {
  for (const MaterialSpec& m : world.scene.materials) {
    if (m.density > 3e4)
      hints.push_back(fmt::format("\"{}\": density {:.3g} kg/m^3 is more than any solid's", m.name, m.density));
    if (m.density > 0 && m.density < 10)
      hints.push_back(
          fmt::format("\"{}\": density {:.3g} kg/m^3: is it in g/cm^3? Then multiply by 1000", m.name, m.density));
    if (m.young > 0 && m.young < 1e4)
      hints.push_back(fmt::format("\"{}\": young {:.3g} Pa: is it in GPa or MPa? It must be in Pa", m.name, m.young));
    if (m.young > 2e12) hints.push_back(fmt::format("\"{}\": young {:.3g} Pa is more than diamond's", m.name, m.young));
    if (m.friction > 3 && std::isfinite(m.friction))
      hints.push_back(fmt::format("\"{}\": friction {:.3g}: is it an angle in degrees? It must be its tangent", m.name,
                                  m.friction));
  }
}

void wall_hints(const World& world, const Sizes& s, Warnings& hints) {
  const double reach = norm(s.upper - s.lower) + 2 * s.largest;
  for (const Wall& w : world.walls) {
    const double moved = (norm(w.velocity) + norm(w.spin) * w.extent) * world.time_step.dt;
    if (moved > 0.1 * s.smallest)
      hints.push_back(
          fmt::format("wall \"{}\" moves by {:.2g} of the smallest radius in one step", w.name, moved / s.smallest));
    if (w.motion.motion == WallMotion::rotation && std::abs(w.motion.rate) > 2 * std::numbers::pi * 100)
      hints.push_back(fmt::format("wall \"{}\" turns {:.3g} times a second: is its rate in rad/s?", w.name,
                                  std::abs(w.motion.rate) / (2 * std::numbers::pi)));
    if (!w.mesh) continue;
    Vec3d lower = w.mesh->vertices.front(), upper = lower;
    for (const Vec3d& v : w.mesh->vertices)
      for (int k = 0; k < 3; ++k) {
        lower[k] = std::min(lower[k], v[k]);
        upper[k] = std::max(upper[k], v[k]);
      }
    const double size = norm(upper - lower);
    if (size > 300 * reach)
      hints.push_back(
          fmt::format("wall \"{}\" is {:.3g} m large, the bodies lie within {:.3g} m: is its mesh in mm? Then "
                      "wall.scale = 0.001",
                      w.name, size, reach));
    if (size < s.largest)
      hints.push_back(
          fmt::format("wall \"{}\" is {:.3g} m large, smaller than a body of radius {:.3g} m: are both in m?", w.name,
                      size, s.largest));
  }
}

}  // namespace

Warnings dynamic_warnings(const World& world, const Loads& loads, const std::vector<PairForecast>& pairs) {
  Warnings list;
  const TimeStep& t = world.time_step;
  if (world.particles.count() == 0) list.emplace_back("there are no bodies");
  if (t.dt > t.limit)
    list.push_back(fmt::format("run.dt is {:.3g} times the stability limit: the run will stop", t.dt / t.limit));
  else if (t.dt > 0.5 * t.limit)
    list.push_back(fmt::format("run.dt is {:.3g} of the stability limit: expect inaccurate impacts", t.dt / t.limit));
  double impact = 0, press = 0, duration = std::numeric_limits<double>::infinity();
  for (const PairForecast& p : pairs) {
    impact = std::max(impact, p.impact_overlap);
    press = std::max(press, p.press_overlap);
    duration = std::min(duration, p.duration);
  }
  // A contact's stiffness at the limit is that of run.dt_overlap: a harder impact is shorter.
  if (t.dt > 0.1 * duration && t.dt <= 0.5 * t.limit)
    list.push_back(
        fmt::format("the fastest collision takes {:.2g} steps; 20 are recommended: lower run.dt_fraction (run.dt)",
                    duration / t.dt));
  if (impact > 0.1)
    list.push_back(
        fmt::format("impacts at {:.3g} m/s overlap by {:.2g} radii: bodies are soft for their speed: raise the "
                    "stiffness, or check the units",
                    loads.impact, impact));
  if (press > 0.05)
    list.push_back(
        fmt::format("contacts under load overlap by {:.2g} radii: bodies are soft for it: raise the stiffness, "
                    "or check the units",
                    press));
  const double expected = press > 0 ? press : impact, tolerance = world.scene.tolerance;
  if (expected > 0 && tolerance > 0.05 * expected)
    list.push_back(
        fmt::format("contact.tolerance {:.2g} is {:.2g} of the overlap that is to be expected, {:.2g} radii: "
                    "forces will be wrong by as much; keep below 0.05 of it",
                    tolerance, tolerance / expected, expected));
  if (loads.unsupported > 0 && norm(world.scene.gravity) > 0 && world.outlets.empty() && !world.cell.periodic)
    list.push_back(fmt::format("{} of {} bodies have no wall below them: they fall for ever, past any other wall",
                               loads.unsupported, world.particles.count()));
  return list;
}

Warnings unit_hints(const World& world) {
  Warnings hints;
  if (world.particles.count() > 0) {
    const Sizes sizes = sizes_of(world);
    body_hints(world, sizes, hints);
    wall_hints(world, sizes, hints);
  }
  part_hints(world, hints);
  material_hints(world, hints);
  const double g = norm(world.scene.gravity);
  if (g > 0 && (g < 1 || g > 30))
    hints.push_back(fmt::format("gravity {:.3g} m/s^2; the Earth's is 9.81, the Moon's 1.62", g));
  if (total_steps(world) > 1000000000)
    hints.push_back(fmt::format("{:.2g} steps: softer materials, larger bodies or a shorter run.time make it less",
                                static_cast<double>(total_steps(world))));
  return hints;
}

Warnings cost_warnings(const Cost& cost) {
  Warnings list;
  if (const double most = memory_of_machine(); most > 0 && cost.memory.total() + cost.picture_memory > 0.8 * most)
    list.push_back(fmt::format("the run needs {:.3g} GB of memory, this machine has {:.3g} GB",
                               1e-9 * (cost.memory.total() + cost.picture_memory), 1e-9 * most));
  if (cost.disk > 1e11)
    list.push_back(
        fmt::format("the run will write {:.3g} GB: a longer output.interval makes it less", 1e-9 * cost.disk));
  if (cost.frames > 100000) list.push_back(fmt::format("{} frames: is output.interval in s?", cost.frames));
  if (cost.total > 60 && cost.output > 0.5 * cost.total)
    list.push_back(fmt::format("writing frames takes {:.0f} % of the time: a longer output.interval makes it less",
                               100 * cost.output / cost.total));
  if (cost.total_on_threads > 30 * 86400.0)
    list.push_back(fmt::format("the run takes {:.3g} days", cost.total_on_threads / 86400));
  return list;
}

}  // namespace dem::forecast
