// dem check: what is modelled and what is off, with the reason, as the scene and its format have it.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <set>

#include "libcontact/dispatch.h"
#include "libcontact/methods/polygon_regions.h"
#include "libdem/cli/check_parts.h"
#include "libdem/cli/model_lines.h"
#include "libdem/detection.h"
#include "libdem/law_map.h"
#include "libdem/laws_of_scene.h"
#include "libdem/parts.h"
#include "libdem/render/render.h"
#include "libdem/scene/format_words.h"

namespace dem::cli {

namespace {

struct Lines {
  std::vector<ModelLine> lines;
  void add(std::string name, std::string text) { lines.push_back({std::move(name), std::move(text)}); }
};

void add_deformation(const PeriodicSpec& box, Lines& to) {
  if (box.deform.empty()) to.add("deformation", "off: no [[periodic.deform]]");
  for (const DeformSpec& d : box.deform) {
    std::string text;
    for (int k = 0; k < 3; ++k) {
      if (!box.along(k)) continue;
      if (!text.empty()) text += ", ";
      text += d.follows(k) ? fmt::format("{} to {:.6g} Pa", "xyz"[k], d.target_stress[k])
                           : fmt::format("{} at {:.6g}/s", "xyz"[k], d.strain_rates[k]);
    }
    if (d.stress_axes != "none")
      text += fmt::format("; at most {:.6g}/s{}", d.rate_limit, d.isotropic ? ", one rate for all of them" : "");
    to.add("deformation", fmt::format("from {:.4g} s on: {}", d.start, text));
  }
}

void add_space(const World& world, Lines& to) {
  const Scene& s = world.scene;
  if (s.dimension == 2)
    to.add("space", s.disc_model == DiscModel::sphere
                        ? "2-D: spheres that move in the plane z = 0"
                        : fmt::format("2-D: prisms of {:.4g} m that move in the plane z = 0", s.thickness));
  else
    to.add("space", "3-D");
  std::string box;
  for (int k = 0; k < 3; ++k)
    if (world.cell.lattice.length[k] > 0)
      box += fmt::format("{} {} from {:.6g} to {:.6g} m", box.empty() ? "on:" : ",", "xyz"[k], world.cell.lower[k],
                         world.cell.lower[k] + world.cell.lattice.length[k]);
  to.add("periodic", box.empty() ? "off: periodic.axes is none" : box);
  if (!box.empty()) add_deformation(s.periodic, to);
  to.add("gravity", s.gravity == Vec3d{}
                        ? "off: world.gravity is zero"
                        : fmt::format("{:.6g} {:.6g} {:.6g} m/s^2", s.gravity.x, s.gravity.y, s.gravity.z));
  to.add("drag", s.drag.law == "none" ? "off: drag.law is none"
                                      : fmt::format("{}, the flow is not changed by the bodies", s.drag.law));
}

// Kinds that contacts see: a body of parts is its parts.
std::set<shapes::Kind> kinds_in_contact(const World& world) {
  std::set<shapes::Kind> kinds;
  std::set<std::uint32_t> seen;
  for (std::size_t i = 0; i < world.particles.count(); ++i) {
    if (!seen.insert(world.particles.shape[i]).second) continue;
    for (std::uint32_t part = 0; part < part_count(world, i); ++part) kinds.insert(part_kind(world, i, part));
  }
  return kinds;
}

void add_law(const World& world, Lines& to) {
  const LawSpec& law = world.scene.law;
  const contact::LawNames names = law_names(law);
  // Pairs of materials that can meet in this scene: those of two bodies, or of a body and a wall.
  const std::size_t n = world.materials.size();
  std::set<std::uint32_t> bodies(world.particles.material.begin(), world.particles.material.end()), all = bodies;
  for (const Wall& w : world.walls) all.insert(w.material);
  std::size_t pairs = 0, rough = 0, damped = 0;
  for (const std::uint32_t a : bodies)
    for (const std::uint32_t b : all) {
      if (b < a && bodies.count(b) > 0) continue;
      const PairParameters& q = world.pairs[a * n + b];
      ++pairs;
      rough += q.friction > 0 ? 1 : 0;
      damped += q.restitution < 1 ? 1 : 0;
    }
  const auto share = [&](std::size_t some, const char* what, const char* off) {
    if (some == 0) return std::string(off);
    return some == pairs ? fmt::format("on ({})", what)
                         : fmt::format("on ({}) in {} of {} pairs of materials", what, some, pairs);
  };
  to.add("law", law_title(law));
  to.add("normal force", names.normal);
  if (rough == 0)
    to.add("tangential", "off: without friction nothing holds it");
  else
    to.add("tangential",
           world.law.hertzian ? fmt::format("{}, rescale {}", names.tangential, law.rescale) : names.tangential);
  to.add("map", law.map == LawMap::edge_radius ? fmt::format("edge_radius, {} m", law.edge_radius) : name_of(law.map));
  to.add("rolling", names.rolling == "none" ? "off: no law named" : names.rolling);
  to.add("cohesion",
         names.cohesion == "none" ? world.law.lingers ? "of the normal law" : "off: no law named" : names.cohesion);
  const std::size_t words = record_words(world);
  to.add("memory", words == 0 ? std::string("64 bytes per contact, in one fused kernel")
                              : fmt::format("{} bytes per contact, one kernel per law", 64 + 8 * words));
  to.add("friction", share(rough, "Coulomb", "off: every pair of materials has friction 0"));
  to.add("damping",
         share(damped, law.clip ? "dashpot, contacts end at zero force" : "dashpot, contacts end at zero overlap",
               "off: every pair has restitution 1"));
  const std::set<shapes::Kind> kinds = kinds_in_contact(world);
  const bool flat = std::any_of(kinds.begin(), kinds.end(), [](shapes::Kind k) {
    return k == shapes::Kind::polyhedron || k == shapes::Kind::rounded_polyhedron || k == shapes::Kind::polygon;
  });
  if (flat) to.add("patches", "on: faces on faces resist rolling and twisting by the area that they share");
  const auto& bodies_of = world.particles.kind;
  if (std::find(bodies_of.begin(), bodies_of.end(), shapes::Kind::compound) != bodies_of.end())
    to.add("parts", "on: contacts of parts that join share one stiffness and one history; inner faces give none");
  const bool regions =
      std::any_of(world.particles.shape.begin(), world.particles.shape.end(),
                  [&](std::uint32_t shape) { return world.shapes[shape].meets_in_regions(); }) ||
      std::any_of(world.walls.begin(), world.walls.end(), [](const Wall& w) { return w.meets_in_regions(); });
  if (regions)
    to.add("regions", fmt::format("on: polygons that are not convex touch in up to {} places of a pair; cuts give none",
                                  contact::max_regions));
}

// What some scenes need and the format may not have. Asked of the format, so that a line goes when a key comes.
void add_absent(Lines& to) {
  constexpr std::array<std::array<const char*, 2>, 6> wanted{{{"rolling", "rolling"},
                                                              {"cohesion", "cohesion"},
                                                              {"liquid", "liquid"},
                                                              {"fluid", "fluid"},
                                                              {"heat", "temperature"},
                                                              {"breakage", "strength"}}};
  std::vector<std::string> absent;
  for (const auto& [name, stem] : wanted)
    if (!some_key_holds(stem)) absent.emplace_back(name);
  if (!absent.empty())
    to.add("not modelled", fmt::format("{}: the scene format has no key for them", fmt::join(absent, ", ")));
}

void add_drivers(const World& world, Lines& to) {
  std::vector<std::string> moving, gates;
  for (const Wall& w : world.walls) {
    if (w.motion.motion != WallMotion::fixed) moving.push_back(w.name);
    if (std::isfinite(w.motion.remove_at)) gates.push_back(fmt::format("{} at {:.4g} s", w.name, w.motion.remove_at));
  }
  const char* none = world.walls.empty() ? "off: no [[wall]]" : "off: every wall.motion is fixed";
  to.add("moving walls", moving.empty() ? none : fmt::format("{}", fmt::join(moving, ", ")));
  if (!gates.empty()) to.add("gates", fmt::format("{}", fmt::join(gates, ", ")));
  to.add("outlets", world.scene.outlets.empty() ? "off: no [[outlet]]" : fmt::format("{}", world.scene.outlets.size()));
}

// Which method answers which pair of kinds that the scene has.
void add_detection(const World& world, Lines& to) {
  const std::set<shapes::Kind> bodies = kinds_in_contact(world);
  std::set<shapes::Kind> all = bodies;
  for (const Wall& w : world.walls) all.insert(w.kind);
  std::vector<std::pair<std::string, std::vector<std::string>>> methods;
  for (const shapes::Kind a : bodies)
    for (const shapes::Kind b : all) {
      if (b < a) continue;
      const contact::MethodInfo* m = detection::choose(a, b, world.scene);
      if (m == nullptr) continue;
      const std::string name(m->name), pair = fmt::format("{}-{}", shapes::name_of(a), shapes::name_of(b));
      auto at = std::find_if(methods.begin(), methods.end(), [&](const auto& x) { return x.first == name; });
      if (at == methods.end()) at = methods.insert(at, {name, {}});
      at->second.push_back(pair);
    }
  bool first = true;
  for (const auto& [name, pairs] : methods) {
    to.add(first ? "detection" : "", fmt::format("{}: {}", name, fmt::join(pairs, ", ")));
    first = false;
  }
  if (world.scene.tolerance > 0)
    to.add("tolerance", fmt::format("{:.3g} of the smaller circumradius: wider gaps go on to a dearer method",
                                    world.scene.tolerance));
}

void add_output(const World& world, Lines& to) {
  const OutputSpec& o = world.scene.output;
  const char* files = o.vtk && o.hdf5 ? "frames.pvd, record.h5" : o.vtk ? "frames.pvd" : o.hdf5 ? "record.h5" : nullptr;
  to.add("frames", files == nullptr ? "off: output.vtk and output.hdf5 are false"
                   : o.interval > 0 ? fmt::format("every {:.4g} s ({})", o.interval, files)
                                    : fmt::format("first and last: output.interval is 0 ({})", files));
  const AnalysisSpec& a = world.scene.analysis;
  to.add("analysis", a.what.empty() ? "off: no [analysis]"
                     : a.interval > 0
                         ? fmt::format("every {:.4g} s: {} (analysis_*.csv)", a.interval, fmt::join(a.what, ", "))
                         : fmt::format("with the frames: {} (analysis_*.csv)", fmt::join(a.what, ", ")));
  to.add("picture", !o.picture             ? "off: output.picture is false"
                    : !render::available() ? "off: built without Embree"
                                           : "final.png");
}

}  // namespace

std::vector<ModelLine> model_lines(const World& world) {
  Lines to;
  add_space(world, to);
  add_law(world, to);
  add_drivers(world, to);
  add_absent(to);
  add_detection(world, to);
  add_output(world, to);
  return std::move(to.lines);
}

void print_model(const World& world) {
  head("model");
  for (const auto& [name, text] : model_lines(world)) line(name, text);
}

}  // namespace dem::cli
