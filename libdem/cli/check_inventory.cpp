// dem check: bodies, materials, walls.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "libdem/cli/check_parts.h"

namespace dem::cli {

namespace {

std::string describe(const ShapeEntry& s) {
  std::string kind = shapes::name_of(s.kind);
  if (s.polyhedron)
    kind += fmt::format(", {} vertices, {} faces", s.polyhedron->vertices.size(), s.polyhedron->faces.size());
  if (s.potential)
    kind += fmt::format(", {} planes, k {:.4g}, r {:.4g} m, R {:.4g} m", s.potential->planes.size(), s.potential->k,
                        s.potential->r, s.potential->R);
  if (s.compound) kind += fmt::format(", {} parts", s.compound->parts.size());
  if (s.polygon) kind += fmt::format(", {} vertices", s.polygon->vertices.size());
  if (s.meets_in_regions()) kind += fmt::format(", not convex: {} convex parts", s.polygon->parts.size());
  if (s.kind == shapes::Kind::rounded_polyhedron) kind += fmt::format(" rounded by {:.4g} m", s.size.y);
  return kind;
}

// Variants of one shape: what they have in common.
std::string describe(const World& world, const std::set<std::uint32_t>& variants) {
  std::size_t fewest = std::numeric_limits<std::size_t>::max(), most = 0;
  for (const std::uint32_t v : variants) {
    fewest = std::min(fewest, world.shapes[v].polyhedron->vertices.size());
    most = std::max(most, world.shapes[v].polyhedron->vertices.size());
  }
  return fmt::format("{} variants of kind {}, {} to {} vertices", variants.size(),
                     shapes::name_of(world.shapes[*variants.begin()].kind), fewest, most);
}

void print_bodies(const World& world) {
  const Particles& p = world.particles;
  struct Group {
    std::size_t count = 0;
    std::set<std::uint32_t> variants;
  };
  std::map<std::pair<std::uint32_t, std::uint32_t>, Group> groups;  // first variant, material
  std::map<std::string, std::uint32_t> first;
  for (std::uint32_t s = 0; s < world.shapes.size(); ++s) first.emplace(world.shapes[s].family, s);
  double smallest = std::numeric_limits<double>::infinity(), largest = 0, mass = 0;
  for (std::size_t i = 0; i < p.count(); ++i) {
    Group& group = groups[{first[world.shapes[p.shape[i]].family], p.material[i]}];
    ++group.count;
    group.variants.insert(p.shape[i]);
    smallest = std::min(smallest, p.motion[i].equivalent_radius);
    largest = std::max(largest, p.motion[i].equivalent_radius);
    mass += p.mass[i];
  }
  head(fmt::format("bodies: {}", p.count()));
  for (const auto& [of, group] : groups) {
    const ShapeEntry& s = world.shapes[of.first];
    line(s.family, fmt::format("{} of {} ({})", group.count, world.scene.materials[of.second].name,
                               s.family == s.name ? describe(s) : describe(world, group.variants)));
  }
  const char* equal = world.scene.dimension == 2 && world.scene.thickness > 0 ? "area" : "volume";
  line("size", fmt::format("{}-equivalent radius {:.4g} to {:.4g} m", equal, smallest, largest));
  line("mass", fmt::format("{:.6g} kg", mass));
}

void print_materials(const World& world) {
  head("materials");
  for (const MaterialSpec& m : world.scene.materials) {
    std::string text = world.law.hertzian ? fmt::format("young {:.4g} Pa, poisson {:.4g}", m.young, m.poisson)
                                          : fmt::format("stiffness {:.4g} N/m", m.stiffness);
    if (m.rigid) text = "rigid";
    line(m.name, fmt::format("{}, density {:.4g} kg/m^3, restitution {:.4g}, friction {:.4g}", text, m.density,
                             m.restitution, m.friction));
    if (!m.source.empty()) line("", fmt::format("like {}: {}", m.like, m.source));
  }
  for (const MaterialPairSpec& p : world.scene.pairs)
    if (!p.source.empty()) line("friction", fmt::format("{} on {}: {}", p.a, p.b, p.source));
}

void print_walls(const World& world) {
  head(fmt::format("walls: {}", world.walls.size()));
  const char* const motions[] = {"fixed", "translation", "rotation", "oscillation", "table", "servo"};
  for (const Wall& w : world.walls) {
    std::string text = fmt::format("{}, {}", w.motion.kind, motions[static_cast<std::size_t>(w.motion.motion)]);
    if (w.motion.motion == WallMotion::servo) text += fmt::format(" that keeps {:.4g} N", w.target);
    if (w.polygon) text += fmt::format(", {} vertices", w.polygon->vertices.size());
    if (w.meets_in_regions()) text += fmt::format(", not convex: {} convex parts", w.polygon->parts.size());
    if (w.mesh && !w.polygon)
      text += fmt::format(", {} triangles in {} facets", w.mesh->triangles.size() / 3, w.mesh->facets.size());
    if (std::isfinite(w.motion.remove_at)) text += fmt::format(", removed at {:.4g} s", w.motion.remove_at);
    line(w.name, text);
  }
}

}  // namespace

void print_inventory(const World& world) {
  print_bodies(world);
  print_materials(world);
  print_walls(world);
}

}  // namespace dem::cli
