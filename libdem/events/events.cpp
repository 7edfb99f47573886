#include "libdem/events/events.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "libdem/build.h"
#include "libdem/insertion/rain.h"
#include "libdem/walls.h"

namespace dem {
namespace {

template <class List>
auto& named(List& list, const std::string& name) {
  return *std::find_if(list.begin(), list.end(), [&](const auto& x) { return x.name == name; });
}

void set_friction(World& world, const EventSpec& e) {
  const std::size_t n = world.materials.size(), i = material_index(world, e.a, e.where),
                    j = material_index(world, e.b, e.where);
  world.pairs[i * n + j].friction = world.pairs[j * n + i].friction = e.friction;
}

void act(World& world, const EventSpec& e) {
  if (!e.remove_wall.empty()) {
    named(world.walls, e.remove_wall).present = false;
    world.contacts.stale = true;
  }
  if (!e.insert_wall.empty()) {
    Wall& wall = named(world.walls, e.insert_wall);
    wall.unchecked = !wall.present;
    wall.present = true;
    world.contacts.stale = true;
  }
  if (!e.start_motion.empty()) start_motion(named(world.walls, e.start_motion), world.time());
  if (!e.stop_motion.empty()) stop_motion(named(world.walls, e.stop_motion), world.time());
  if (!e.start_rain.empty()) start_rain(world, e.start_rain);
  if (!e.stop_rain.empty()) stop_rain(world, e.stop_rain);
  if (!std::isnan(e.gravity.x)) world.scene.gravity = e.gravity;
  if (!std::isnan(e.friction)) set_friction(world, e);
  if (!e.species.empty()) tag_species(world, {e.species, e.region, e.material, "", e.where});
}

bool due(const World& world, const EventSpec& spec, const EventRecord& e) {
  if (spec.at > 0) return world.time() >= spec.at;
  return e.met > 0 && world.time() >= static_cast<double>(e.met) * world.time_step.dt + spec.delay;
}

Condition condition_of(const std::string& text, const Scene& scene, const Where& where) {
  Condition condition;
  ConditionFault fault;
  if (!text.empty() && !parse_condition(text, scene, condition, fault)) input_error(where, text + ": " + fault.problem);
  return condition;
}

}  // namespace

void prepare_events(World& world) {
  const Scene& scene = world.scene;
  world.until = condition_of(scene.run.until, scene, {scene.path, 0, 0});
  for (const EventSpec& e : scene.events) {
    world.events.push_back({e.name, 0, 0});
    world.conditions.push_back(condition_of(e.when, scene, e.where));
    if (!e.start_motion.empty())
      named(world.walls, e.start_motion).motion.start = std::numeric_limits<double>::infinity();
  }
}

void apply_events(World& world) {
  const bool look = world.step % world.scene.run.check_every == 0;
  if (look)
    for (std::size_t i = 0; i < world.events.size(); ++i)
      if (world.events[i].met == 0 && holds(world, world.conditions[i])) world.events[i].met = world.step;
  const bool at_end = look && holds(world, world.until);
  for (std::size_t i = 0; i < world.events.size(); ++i) {
    EventRecord& e = world.events[i];
    const EventSpec& spec = world.scene.events[i];
    if (e.done > 0 || !due(world, spec, e)) continue;
    e.done = world.step;
    act(world, spec);
    if (spec.stop && world.ended_by == 0) world.ended_by = 2 + i;
  }
  if (at_end && world.ended_by == 0) world.ended_by = 1;
}

void check_inserted_walls(World& world) {
  if (std::none_of(world.walls.begin(), world.walls.end(), [](const Wall& w) { return w.unchecked; })) return;
  const Contacts& c = world.contacts;
  for (const std::uint32_t k : c.wall_records) {
    const Wall& wall = world.walls[c.index_b[k]];
    if (c.touching[k] == 0 || !wall.unchecked) continue;
    const double size = overlap_radius(world, c.index_a[k]), overlap = c.history_of(k).overlap;
    if (overlap > world.scene.run.max_initial_overlap * size)
      throw RunError("step " + std::to_string(world.step) + ": wall \"" + wall.name + "\" was inserted where body " +
                     std::to_string(world.particles.id[c.index_a[k]]) + " is: they overlap by " +
                     std::to_string(100 * overlap / size) + " % of its inscribed radius; allowed: up to " +
                     std::to_string(100 * world.scene.run.max_initial_overlap) + " % (run.max_initial_overlap)");
  }
  for (Wall& w : world.walls) w.unchecked = false;
}

std::string ended_by(const World& world) {
  if (world.ended_by == 0) return "";
  if (world.ended_by == 1) return "run.until: " + world.scene.run.until;
  return "event " + world.events[world.ended_by - 2].name;
}

bool finished(const World& world) { return world.ended_by > 0 || world.step >= total_steps(world); }

}  // namespace dem
