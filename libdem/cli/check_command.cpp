// dem check: what a scene is and what running it would cost.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>

#include "libdem/cli/commands.h"
#include "libdem/cli/progress.h"
#include "libdem/render/render.h"

namespace dem::cli {

namespace {

void head(const std::string& title) { fmt::print("\n{}\n", title); }
void line(const std::string& name, const std::string& text) { fmt::print("  {:<14}{}\n", name, text); }

void print_bodies(const World& world) {
  const Particles& p = world.particles;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> groups;
  double smallest = std::numeric_limits<double>::infinity(), largest = 0, mass = 0;
  for (std::size_t i = 0; i < p.count(); ++i) {
    ++groups[{p.shape[i], p.material[i]}];
    smallest = std::min(smallest, p.motion[i].equivalent_radius);
    largest = std::max(largest, p.motion[i].equivalent_radius);
    mass += p.mass[i];
  }
  head(fmt::format("bodies: {}", p.count()));
  for (const auto& [group, count] : groups) {
    const ShapeEntry& s = world.shapes[group.first];
    std::string kind = shapes::name_of(s.kind);
    if (s.polyhedron)
      kind += fmt::format(", {} vertices, {} faces", s.polyhedron->vertices.size(), s.polyhedron->faces.size());
    if (s.polygon) kind += fmt::format(", {} vertices", s.polygon->vertices.size());
    line(s.name, fmt::format("{} of {} ({})", count, world.scene.materials[group.second].name, kind));
  }
  line("size", fmt::format("volume-equivalent radius {:.4g} to {:.4g} m", smallest, largest));
  line("mass", fmt::format("{:.6g} kg", mass));
}

void print_materials(const World& world) {
  head("materials");
  for (const MaterialSpec& m : world.scene.materials) {
    std::string text = world.scene.law.name == LawName::hertz_mindlin
                           ? fmt::format("young {:.4g} Pa, poisson {:.4g}", m.young, m.poisson)
                           : fmt::format("stiffness {:.4g} N/m", m.stiffness);
    if (m.rigid) text = "rigid";
    line(m.name, fmt::format("{}, density {:.4g} kg/m^3, restitution {:.4g}, friction {:.4g}", text, m.density,
                             m.restitution, m.friction));
    if (!m.source.empty()) line("", fmt::format("like {}: {}", m.like, m.source));
  }
}

void print_pairs(const World& world) {
  for (const MaterialPairSpec& p : world.scene.pairs)
    if (!p.source.empty()) line("friction", fmt::format("{} on {}: {}", p.a, p.b, p.source));
}

void print_walls(const World& world) {
  head(fmt::format("walls: {}", world.walls.size()));
  const char* const motions[] = {"fixed", "translation", "rotation", "oscillation", "table", "servo"};
  for (const Wall& w : world.walls) {
    std::string text = fmt::format("{}, {}", w.motion.kind, motions[static_cast<std::size_t>(w.motion.motion)]);
    if (w.motion.motion == WallMotion::servo) text += fmt::format(" that keeps {:.4g} N", w.target);
    if (w.mesh) text += fmt::format(", {} triangles in {} facets", w.mesh->triangles.size() / 3, w.mesh->facets.size());
    if (std::isfinite(w.motion.remove_at)) text += fmt::format(", removed at {:.4g} s", w.motion.remove_at);
    line(w.name, text);
  }
}

// What is on, and what is off with its reason.
void print_model(const World& world) {
  const Scene& s = world.scene;
  const auto any = [&](auto member, double off) {
    return std::any_of(world.pairs.begin(), world.pairs.end(),
                       [&](const PairParameters& q) { return q.*member != off; });
  };
  head("model");
  const bool hertz = s.law.name == LawName::hertz_mindlin;
  line("normal force", hertz ? "Hertz" : "linear spring");
  line("tangential", hertz ? fmt::format("Mindlin, no slip, rescale {}", s.law.rescale) : "linear spring");
  line("friction",
       any(&PairParameters::friction, 0.0) ? "on (Coulomb)" : "off: every pair of materials has friction 0");
  line("damping", any(&PairParameters::restitution, 1.0) ? "on (dashpot)" : "off: every pair has restitution 1");
  line("gravity", s.gravity == Vec3d{}
                      ? "off: world.gravity is zero"
                      : fmt::format("{:.6g} {:.6g} {:.6g} m/s^2", s.gravity.x, s.gravity.y, s.gravity.z));
  line("outlets", s.outlets.empty() ? "off: no [[outlet]]" : fmt::format("{}", s.outlets.size()));
  std::string box;
  for (int k = 0; k < 3; ++k)
    if (s.periodic.along(k))
      box += fmt::format("{} {} from {:.6g} to {:.6g} m", box.empty() ? "on:" : ",", "xyz"[k], s.periodic.lower[k],
                         s.periodic.upper[k]);
  line("periodic", box.empty() ? "off: periodic.axes is none" : box);
  const auto& deform = s.periodic.deform;
  if (!box.empty())
    line("deformation", deform.empty() ? "off: no [[periodic.deform]]" : fmt::format("on: {} entries", deform.size()));
  line("detection", s.method);
  for (const char* absent : {"rolling", "cohesion"}) line(absent, "off: not in this version");
  line("frames", s.output.interval > 0 ? fmt::format("every {:.4g} s", s.output.interval)
                                       : "first and last: output.interval is 0");
  line("picture", !s.output.picture      ? "off: output.picture is false"
                  : !render::available() ? "off: built without Embree"
                                         : "final.png");
}

template <class T>
std::size_t bytes(const std::vector<T>& v) {
  return v.capacity() * sizeof(T);
}

std::size_t memory(const World& world) {
  const Particles& p = world.particles;
  const Contacts& c = world.contacts;
  return bytes(p.id) + bytes(p.shape) + bytes(p.material) + bytes(p.size) + bytes(p.motion) + bytes(p.orientation) +
         bytes(p.rotation) + bytes(p.angular_momentum) + bytes(p.inertia) + bytes(p.mass) + bytes(p.force) +
         bytes(p.torque) + bytes(c.key) + bytes(c.index_a) + bytes(c.index_b) + bytes(c.history) + bytes(c.touching) +
         bytes(c.slot) + bytes(c.cache);
}

struct Cost {
  double seconds_per_step;
  std::size_t bytes;
};

// Measured, not modelled: a copy of the world takes a few steps on one thread. The first one pays for fresh memory.
Cost measure(World world) {
  constexpr int steps = 20;
  constexpr double longest = 3;  // s: a large scene is judged by fewer steps
  using Clock = std::chrono::steady_clock;
  advance(world, 1);
  const auto start = Clock::now();
  const auto elapsed = [&] { return std::chrono::duration<double>(Clock::now() - start).count(); };
  int done = 0;
  while (done < steps && elapsed() < longest) {
    advance(world, 1);
    ++done;
  }
  return {elapsed() / done, memory(world)};
}

// Numbers that no scene in SI units is likely to have.
void unit_hints(const World& world, std::vector<std::string>& hints) {
  const Particles& p = world.particles;
  double smallest = std::numeric_limits<double>::infinity(), largest = 0;
  for (const Motion& m : p.motion) {
    smallest = std::min(smallest, m.equivalent_radius);
    largest = std::max(largest, m.equivalent_radius);
  }
  if (largest > 1)
    hints.push_back(fmt::format("bodies of radius {:.3g} m: are lengths in mm? They must be in m", largest));
  if (p.count() > 0 && smallest < 1e-7)
    hints.push_back(fmt::format("bodies of radius {:.3g} m are smaller than any grain: are lengths in m?", smallest));
  if (p.count() > 0 && largest > 100 * smallest)
    hints.push_back(fmt::format("the largest body is {:.3g} times the smallest: the neighbour search will be slow",
                                largest / smallest));
  for (const MaterialSpec& m : world.scene.materials) {
    if (m.density > 3e4)
      hints.push_back(fmt::format("\"{}\": density {:.3g} kg/m^3 is more than any solid's", m.name, m.density));
    if (m.density > 0 && m.density < 10)
      hints.push_back(
          fmt::format("\"{}\": density {:.3g} kg/m^3: is it in g/cm^3? Then multiply by 1000", m.name, m.density));
    if (m.young > 0 && m.young < 1e4)
      hints.push_back(fmt::format("\"{}\": young {:.3g} Pa: is it in GPa or MPa? It must be in Pa", m.name, m.young));
    if (m.young > 2e12) hints.push_back(fmt::format("\"{}\": young {:.3g} Pa is more than diamond's", m.name, m.young));
  }
  const double g = norm(world.scene.gravity);
  if (g > 0 && (g < 1 || g > 30))
    hints.push_back(fmt::format("gravity {:.3g} m/s^2; the Earth's is 9.81, the Moon's 1.62", g));
  if (total_steps(world) > 1000000000)
    hints.push_back(fmt::format("{:.2g} steps: softer materials, larger bodies or a shorter run.time make it less",
                                static_cast<double>(total_steps(world))));
  for (const Wall& w : world.walls) {
    const double moved = (norm(w.velocity) + norm(w.spin) * w.extent) * world.time_step.dt;
    if (p.count() > 0 && moved > 0.1 * smallest)
      hints.push_back(
          fmt::format("wall \"{}\" moves by {:.2g} of the smallest radius in one step", w.name, moved / smallest));
  }
}

// What the run would regret.
void print_warnings(const World& world) {
  const Particles& p = world.particles;
  const TimeStep& t = world.time_step;
  std::vector<std::string> warnings;
  if (t.dt > t.limit)
    warnings.push_back(fmt::format("run.dt is {:.3g} times the stability limit: the run will stop", t.dt / t.limit));
  else if (t.dt > 0.5 * t.limit)
    warnings.push_back(
        fmt::format("run.dt is {:.3g} of the stability limit: expect inaccurate impacts", t.dt / t.limit));
  // Fall through the height of the scene: deepest impact overlap of the largest body, 2 R* = its radius.
  Vec3d lower{}, upper{};
  double largest = 0, mass = 0, speed = 0;
  std::uint32_t material = 0;
  for (std::size_t i = 0; i < p.count(); ++i) {
    const Motion& m = p.motion[i];
    for (int k = 0; k < 3; ++k) {
      lower[k] = i ? std::min(lower[k], m.position[k]) : m.position[k];
      upper[k] = i ? std::max(upper[k], m.position[k]) : m.position[k];
    }
    speed = std::max(speed, norm(m.velocity));
    if (m.equivalent_radius > largest) {
      largest = m.equivalent_radius;
      mass = p.mass[i];
      material = p.material[i];
    }
  }
  const Vec3d extent = upper - lower, g = world.scene.gravity;
  const double drop = std::abs(g.x) * extent.x + std::abs(g.y) * extent.y + std::abs(g.z) * extent.z;
  speed = std::sqrt(speed * speed + 2 * drop);
  const PairParameters& q = world.pairs[material * world.materials.size() + material];
  const double energy = 0.25 * mass * speed * speed;  // two equal bodies: m_eff = m/2
  const double overlap = world.scene.law.name == LawName::hertz_mindlin
                             ? std::pow(energy * 15 / (8 * q.young_eff * std::sqrt(0.5 * largest)), 0.4)
                             : std::sqrt(2 * energy / q.stiffness_n);
  const double share = overlap / largest;
  line("impact", fmt::format("at {:.3g} m/s the largest bodies overlap by {:.2g} of their radius", speed, share));
  if (share > 0.1) warnings.push_back("bodies are soft for their speed: raise the stiffness, or check the units");
  if (p.count() == 0) warnings.push_back("there are no bodies");
  unit_hints(world, warnings);
  head(warnings.empty() ? "warnings: none" : "warnings");
  for (const std::string& w : warnings) fmt::print("  {}\n", w);
}

}  // namespace

int check_command(const CheckArguments& arguments) {
  const World world = build_world(load_scene(arguments.scene, arguments.overrides));
  fmt::print("{}{}{}\n", arguments.scene, world.scene.title.empty() ? "" : ": ", world.scene.title);
  print_bodies(world);
  print_materials(world);
  print_pairs(world);
  print_walls(world);
  print_model(world);
  head("time");
  const TimeStep& t = world.time_step;
  const std::uint64_t steps = total_steps(world);
  line("dt",
       fmt::format("{:.6g} s ({}{:.3g} of the limit)", t.dt, world.scene.run.dt_auto ? "auto, " : "", t.dt / t.limit));
  line("limit", fmt::format("{:.6g} s: {}", t.limit, t.limited_by));
  line("steps", fmt::format("{} to t = {:.6g} s", steps, static_cast<double>(steps) * t.dt));
  line("skin", fmt::format("{:.4g} m", world.skin));
  head("cost");
  const Cost cost = measure(world);
  line("memory", rate_text(static_cast<double>(cost.bytes)) + "B for bodies and contacts as they begin");
  line("time",
       fmt::format("{} on one thread, from {:.3g} ms per step measured now; a bed that packs costs more",
                   duration_text(cost.seconds_per_step * static_cast<double>(steps)), 1e3 * cost.seconds_per_step));
  print_warnings(world);
  return success;
}

}  // namespace dem::cli
