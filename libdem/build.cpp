// build_world: from a resolved scene to the world at t = 0.
#include "libdem/build.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "libcontact/laws/mix.h"
#include "libdem/broad_phase/candidates.h"
#include "libdem/deformation.h"
#include "libdem/detection.h"
#include "libdem/events/events.h"
#include "libdem/fields/drag_force.h"
#include "libdem/forces.h"
#include "libdem/insertion/rain.h"
#include "libdem/insertion/region.h"
#include "libdem/integrators/rotation.h"
#include "libdem/law_map.h"
#include "libdem/laws_of_scene.h"
#include "libdem/parts.h"
#include "libdem/reference_stiffness.h"
#include "libdem/walls.h"

namespace dem {

std::uint32_t shape_index(const World& world, const std::string& name, const Where& where) {
  const std::vector<std::uint32_t> all = shape_indices(world, name, where);
  return all[world.next_id % all.size()];
}

std::vector<std::uint32_t> shape_indices(const World& world, const std::string& name, const Where& where) {
  std::vector<std::uint32_t> family;
  for (std::uint32_t i = 0; i < world.shapes.size(); ++i) {
    if (world.shapes[i].name == name) return {i};
    if (world.shapes[i].family == name) family.push_back(i);
  }
  if (family.empty()) input_error(where, "shape \"" + name + "\" is not defined");
  return family;
}

std::uint32_t material_index(const World& world, const std::string& name, const Where& where) {
  for (std::size_t i = 0; i < world.scene.materials.size(); ++i)
    if (world.scene.materials[i].name == name) return static_cast<std::uint32_t>(i);
  input_error(where, "material \"" + name + "\" is not defined");
}

std::uint32_t species_index(const World& world, const std::string& name, const Where& where) {
  if (name.empty()) return 0;
  for (std::size_t i = 0; i < world.scene.species.size(); ++i)
    if (world.scene.species[i].name == name) return static_cast<std::uint32_t>(i + 1);
  input_error(where, "species \"" + name + "\" is not defined");
}

const std::string& species_name(const World& world, std::uint32_t species) {
  static const std::string none = "none";
  return species == 0 ? none : world.scene.species[species - 1].name;
}

Quatd random_orientation(const World& world, Random& random) {
  return world.scene.dimension == 2 ? random.turn() : random.rotation();
}

void tag_species(World& world, const SpeciesSpec& spec) {
  const std::uint32_t tag = species_index(world, spec.name, spec.where);
  std::optional<Region> region;
  if (!spec.region.empty()) region.emplace(region_of(world, spec.region));
  Particles& p = world.particles;
  for (std::size_t i = 0; i < p.count(); ++i)
    if ((!region || region->holds(p.motion[i].position)) &&
        (spec.material.empty() || world.scene.materials[p.material[i]].name == spec.material) &&
        (spec.shape.empty() || world.shapes[p.shape[i]].family == spec.shape))
      p.species[i] = tag;
}

void add_particle(World& world, std::uint32_t shape, std::uint32_t material, double scale, const Vec3d& position,
                  const Quatd& orientation, const Vec3d& velocity, const Vec3d& spin) {
  const ShapeEntry& s = world.shapes[shape];
  Particles& p = world.particles;
  p.id.push_back(world.next_id++);
  p.shape.push_back(shape);
  p.kind.push_back(s.kind);
  p.material.push_back(material);
  p.size.push_back(s.size * scale);
  p.orientation.push_back(shapes::normalized(orientation));
  p.motion.push_back({.position = position, .velocity = velocity, .spin = spin});
  p.mass.push_back(0);
  p.species.push_back(0);
  for (auto* list : {&p.inertia, &p.rotation, &p.angular_momentum, &p.force, &p.torque}) list->push_back({});
  set_mass(world, p.count() - 1, scale);
  ++world.counters.inserted;
}

double inscribed_radius(const World& world, std::size_t i) {
  const ShapeEntry& e = world.shapes[world.particles.shape[i]];
  return e.inscribed_radius * (world.particles.motion[i].bounding_radius / e.circumradius);
}

void set_mass(World& world, std::size_t i, double scale) {
  Particles& p = world.particles;
  const ShapeEntry& s = world.shapes[p.shape[i]];
  const double density = world.materials[p.material[i]].density;
  const double power = s.mass_power == 3 ? scale * scale * scale : scale * scale;
  Motion& m = p.motion[i];
  p.mass[i] = density * s.volume * power;
  p.inertia[i] = s.inertia * (density * (power * scale * scale));
  m.inverse_mass = 1 / p.mass[i];
  m.bounding_radius = s.circumradius * scale;
  m.equivalent_radius = s.equivalent_radius * scale;
  const shapes::Mat3d r = shapes::rotation_matrix(p.orientation[i]);
  p.angular_momentum[i] = r * shapes::scaled(p.inertia[i], shapes::transposed_times(r, m.spin));
}

double overlap_radius(const World& world, std::size_t i) {
  const ShapeEntry& s = world.shapes[world.particles.shape[i]];
  return s.overlap_radius * (world.particles.motion[i].bounding_radius / s.circumradius);
}

namespace {

void mix_materials(World& world) {
  const LawSpec& law = world.scene.law;
  world.law = law_model_of(law);
  world.law_options = law_options_of(law);
  for (const MaterialSpec& m : world.scene.materials) world.materials.push_back(material_of(m, law));
  const std::size_t n = world.materials.size();
  world.pairs.resize(n * n);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j)
      world.pairs[i * n + j] = contact::mix(world.materials[i], world.materials[j], law.clip);
  for (const MaterialPairSpec& p : world.scene.pairs) {
    const std::size_t i = material_index(world, p.a, p.where), j = material_index(world, p.b, p.where);
    for (contact::PairParameters* q : {&world.pairs[i * n + j], &world.pairs[j * n + i]})
      override_pair(*q, p, law.clip);
  }
}

// Contacts of the scene as given must be shallow: anything else is a mistake that would explode.
void check_initial_overlap(const World& world, const std::vector<const Where*>& where) {
  const Contacts& c = world.contacts;
  for (std::size_t k = 0; k < c.count(); ++k) {
    if (!c.touching[k]) continue;
    const bool wall = c.key[k].b >= wall_base;
    double size = overlap_radius(world, c.index_a[k]);
    if (!wall) size = std::min(size, overlap_radius(world, c.index_b[k]));
    const double overlap = c.history_of(k).overlap, allowed = world.scene.run.max_initial_overlap * size;
    if (overlap <= allowed) continue;
    const std::string other = wall ? "wall \"" + world.walls[c.index_b[k]].name + "\""
                                   : "body " + std::to_string(world.particles.id[c.index_b[k]]);
    input_error(*where[world.particles.id[c.index_a[k]]],
                "body " + std::to_string(world.particles.id[c.index_a[k]]) + " overlaps " + other + " by " +
                    std::to_string(100 * overlap / size) + " % of the smaller inscribed radius; allowed: up to " +
                    std::to_string(100 * world.scene.run.max_initial_overlap) + " % (run.max_initial_overlap)");
  }
}

// Every pair of kinds that can meet must have a method; a pair that nobody answers is refused before the run.
void check_methods(const World& world) {
  std::array<bool, shapes::kind_count> present{};
  const auto with_parts = [&](shapes::Kind kind, const ShapeEntry& shape) {
    if (shape.compound == nullptr)
      present[static_cast<std::size_t>(kind)] = true;
    else
      for (const auto& part : shape.compound->parts) present[static_cast<std::size_t>(kind_of(part.kind))] = true;
  };
  for (std::size_t i = 0; i < world.particles.count(); ++i)
    with_parts(world.particles.kind[i], world.shapes[world.particles.shape[i]]);
  for (const Draft& d : coming_bodies(world)) with_parts(world.shapes[d.shape].kind, world.shapes[d.shape]);
  std::array<bool, shapes::kind_count> other = present;
  for (const Wall& w : world.walls) other[static_cast<std::size_t>(w.kind)] = true;
  // A method that is named must answer one of the pairs; the cheapest exact method takes the others.
  std::string unanswered;
  bool used = world.scene.method == "auto";
  for (std::size_t a = 0; a < shapes::kind_count; ++a)
    for (std::size_t b = a; b < shapes::kind_count; ++b) {
      if (!(present[a] && other[b])) continue;
      const auto ka = static_cast<shapes::Kind>(a), kb = static_cast<shapes::Kind>(b);
      const std::string pair = std::string(shapes::name_of(ka)) + "–" + shapes::name_of(kb);
      if (detection::find(ka, kb, world.scene) == nullptr)
        input_error({world.scene.path, 0, 0}, "no method answers the pair " + pair +
                                                  ", which this scene has; allowed: kinds that dem list pairs shows an "
                                                  "answer for");
      used = used || contact::find(ka, kb, world.scene.method) != nullptr;
      unanswered += (unanswered.empty() ? "" : ", ") + pair;
    }
  if (!used && !unanswered.empty())
    input_error({world.scene.path, 0, 0}, "contact.method = \"" + world.scene.method + "\" does not answer the pair " +
                                              unanswered +
                                              ", all that this scene has; allowed: \"auto\", or see dem list pairs");
}

// Only one image of a body may be within reach of another.
void check_cell(const World& world) {
  double largest = 0;
  for (const Motion& m : world.particles.motion) largest = std::max(largest, m.bounding_radius);
  for (const RainSpec& r : world.scene.rains)
    largest = std::max(largest, Recipe(world, r.items, r.where).largest_radius());
  const double needed = 2 * (2 * largest + world.skin);
  for (int k = 0; k < 3; ++k) {
    const double length = world.cell.lattice.length[k];
    if (length > 0 && length < needed)
      input_error(world.scene.periodic.where,
                  fmt::format("periodic: the box is {} m long in {}, too short for one image of each body at a time; "
                              "allowed: from {} m, 2 · (2 · {} m, the largest bounding radius, + {} m, run.skin)",
                              length, "xyz"[k], needed, largest, world.skin));
  }
}

void check_recycling(const World& world) {
  double largest = 0;
  for (const Motion& m : world.particles.motion) largest = std::max(largest, m.bounding_radius);
  for (const RainSpec& r : world.scene.rains)
    largest = std::max(largest, Recipe(world, r.items, r.where).largest_radius());
  for (const OutletSpec& o : world.scene.outlets)
    if (!o.recycle_to.empty() && !region_of(world, o.recycle_to).has_room_for(largest))
      input_error(o.where, "outlet \"" + o.name + "\": region \"" + o.recycle_to +
                               "\" has no room for the largest body, of bounding diameter " +
                               std::to_string(2 * largest) + " m");
}

double automatic_skin(const World& world) {
  double smallest = 0;
  for (const Motion& m : world.particles.motion)
    smallest = smallest == 0 ? m.equivalent_radius : std::min(smallest, m.equivalent_radius);
  for (const Draft& d : coming_bodies(world)) {
    const double radius = world.shapes[d.shape].equivalent_radius * d.scale;
    smallest = smallest == 0 ? radius : std::min(smallest, radius);
  }
  return 0.2 * smallest;
}

// The widest gap that a contact of the scene holds on across: the list of candidates reaches at least as far, so that
// no bond is lost by a rebuild.
double widest_hold(const World& world) {
  if (!world.law.lingers) return 0;
  double largest = 0, widest = 0;
  for (std::size_t i = 0; i < world.particles.count(); ++i)
    largest = std::max(largest, radius_bound(radius_bound(world, i)));
  for (const Draft& d : coming_bodies(world))
    largest = std::max(largest, radius_bound(radius_bound(world, d.shape, d.scale)));
  for (const PairParameters& q : world.pairs)  // R* of a wall is the largest
    if (std::isfinite(q.young_eff)) widest = std::max(widest, world.law.range(q, world.law_options, largest));
  return widest * (1 + 1e-9);
}

// Bonds need the gap of bodies apart: outlines that touch in several regions have none of each region, and what an
// approximate method measures is not one.
void check_bonds(const World& world) {
  if (!world.law.lingers) return;
  const std::string law = "law " + law_title(world.scene.law) + " holds on across a gap";
  const auto refuse = [&](const Where& where, const std::string& what) {
    input_error(
        where, fmt::format("{}: {}; allowed: convex polygons, or a law that lets go where the bodies part", law, what));
  };
  for (const ShapeSpec& s : world.scene.shapes)
    for (const ShapeEntry& e : world.shapes)
      if (e.family == s.name && e.meets_in_regions())
        refuse(s.where, fmt::format("shape \"{}\" is not convex and may touch in several regions", s.name));
  for (const Wall& w : world.walls)
    if (w.meets_in_regions())
      refuse(w.motion.where, fmt::format("wall \"{}\" is not convex and may be touched in several regions", w.name));
  if (world.scene.method == "auto") return;
  for (std::size_t a = 0; a < shapes::kind_count; ++a)
    for (std::size_t b = a; b < shapes::kind_count; ++b) {
      const contact::MethodInfo* method =
          contact::choose(static_cast<shapes::Kind>(a), static_cast<shapes::Kind>(b), world.scene.method);
      if (method != nullptr && !method->exact)
        input_error({world.scene.path, 0, 0},
                    fmt::format("{}: contact.method = \"{}\" does not measure gaps; allowed: \"auto\", exact methods",
                                law, world.scene.method));
    }
}

}  // namespace

World build_world(const Scene& scene) {
  World world;
  world.scene = scene;
  mix_materials(world);
  for (const ShapeSpec& s : scene.shapes)
    for (ShapeEntry& e : make_shapes(s, scene)) world.shapes.push_back(std::move(e));
  for (const WallSpec& w : scene.walls) world.walls.push_back(make_wall(w, material_index(world, w.material, w.where)));
  if (scene.dimension == 2)
    for (const Wall& w : world.walls)
      for (const auto& row : w.motion.displacements)
        if (row[3] != 0) input_error(w.motion.where, "wall \"" + w.name + "\" leaves the plane z = 0 of a 2-D scene");
  make_cell(world);
  const auto wrap = [&] {
    if (world.cell.periodic)
      for (Motion& m : world.particles.motion) world.cell.wrap(m.position);
  };
  std::vector<const Where*> where;
  const auto mark = [&](const Where& w) { where.resize(world.particles.count(), &w); };
  for (const BodySpec& b : scene.bodies) {
    add_particle(world, shape_index(world, b.shape, b.where), material_index(world, b.material, b.where), b.scale,
                 b.position, b.orientation, b.velocity, b.spin);
    world.particles.species.back() = species_index(world, b.species, b.where);
    mark(b.where);
  }
  for (const CsvSpec& c : scene.csv) {
    add_csv(world, c);
    mark(c.where);
  }
  wrap();
  std::uint64_t stream = 0;
  for (const FillSpec& f : scene.fills) {
    add_fill(world, f, stream++);
    mark(f.where);
  }
  wrap();
  for (const OutletSpec& o : scene.outlets)
    world.outlets.push_back({.name = o.name, .by_species = std::vector<std::uint64_t>(scene.species.size() + 1)});
  for (const SpeciesSpec& s : scene.species)
    if (!s.region.empty() || !s.material.empty() || !s.shape.empty()) tag_species(world, s);
  prepare_rain(world);
  prepare_events(world);
  if (scene.law.reference_speed > 0) set_reference_stiffness(world);
  check_recycling(world);
  for (std::size_t i = 0; i < world.particles.count(); ++i) {
    if (turns_uniformly(world.particles.kind[i])) continue;
    world.particles.motion[i].spin =
        spin_of(world.particles.orientation[i], world.particles.angular_momentum[i], world.particles.inertia[i]);
  }
  check_methods(world);
  check_map(world);
  check_bonds(world);
  world.skin = std::max(scene.run.skin >= 0 ? scene.run.skin : automatic_skin(world), widest_hold(world));
  check_cell(world);
  world.time_step = choose_time_step(world);
  move_walls(world);
  rebuild_candidates(world, 1);
  compute_forces(world, 1, 0.0);  // no time has passed: history of initial contacts begins without slip
  check_initial_overlap(world, where);
  add_drag(world, 1, 0.0);
  const Vec3d p = momentum(world);
  world.balance.initial_momentum = {p.x, p.y, p.z};
  for (const std::uint32_t i : order_by_id(world)) world.balance.initial_mass += world.particles.mass[i];
  world.balance.present.add(world.balance.initial_mass);
  start_cell(world);
  return world;
}

std::uint64_t steps_between(double interval, double dt) {
  constexpr double most = 0x1p53;
  return interval > 0 ? static_cast<std::uint64_t>(std::clamp(std::round(interval / dt), 1.0, most)) : 0;
}

std::uint64_t total_steps(const World& world) {
  const RunSpec& run = world.scene.run;
  return run.steps > 0 ? run.steps : static_cast<std::uint64_t>(std::ceil(run.time / world.time_step.dt - 1e-9));
}

}  // namespace dem
