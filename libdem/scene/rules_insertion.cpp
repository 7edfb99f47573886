// Rules that join several keys of [[region]], [[fill]], [[rain]], [[outlet]], [[species]], [[event]] and run.until.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "libdem/events/condition.h"
#include "libdem/scene/rules.h"

namespace dem {

namespace {

bool given(const RuleContext& c, const char* table, std::size_t i, std::initializer_list<const char*> keys,
           std::size_t least, std::size_t most, const std::string& problem) {
  std::size_t found = 0;
  const char* last = nullptr;
  for (const char* key : keys)
    if (c.node(table, i, key)) {
      ++found;
      last = key;
    }
  if (found < least || found > most) return c.wrong(table, i, found > most ? last : nullptr, problem), false;
  return true;
}

void ordered(const RuleContext& c, const char* table, std::size_t i, const Vec3d& lower, const Vec3d& upper) {
  for (int k = 0; k < c.scene.dimension; ++k)
    if (!(lower[k] < upper[k]))
      return c.wrong(
          table, i, "upper",
          fmt::format("allowed {0}.upper > {0}.lower in x{1}", table, c.scene.dimension == 2 ? " and y" : ", y and z"));
}

// The share of a lognormal distribution between its cuts.
double share_between(const FillItem& item) {
  const auto below = [&](double x) {
    return 0.5 * std::erfc(-std::log(x / item.median) / item.sigma / std::sqrt(2.0));
  };
  return below(item.scale_max) - below(item.scale_min);
}

void items(const RuleContext& c, const char* table, std::size_t i, const std::vector<FillItem>& list) {
  for (const FillItem& item : list) {
    if (item.distribution != SizeDistribution::lognormal) continue;
    if (!(item.scale_min < item.scale_max))
      return c.wrong(table, i, "items",
                     "a lognormal distribution needs scale = [min, max] with min < max: it is cut off there");
    if (const double share = share_between(item); share < 0.001)
      return c.wrong(table, i, "items",
                     fmt::format("the lognormal distribution has next to nothing between the scales {} and {}: a share "
                                 "of {:.2g}, needed 0.001",
                                 item.scale_min, item.scale_max, share));
  }
}

void region(const RuleContext& c, std::size_t i) {
  const RegionSpec& r = c.scene.regions[i];
  if (r.kind == "box") ordered(c, "region", i, r.lower, r.upper);
  if (r.kind == "cylinder") c.nonzero("region", i, "axis", r.axis);
  const bool planar = c.scene.dimension == 2;
  if (r.kind == "disc" && !planar) c.wrong("region", i, "kind", "is for 2-D scenes: set world.dimension = 2");
  if (planar && r.kind != "box" && r.kind != "disc")
    c.wrong("region", i, "kind", "a 2-D scene allows box (a rectangle) and disc");
}

// A written scene states keys that do not count with their zeros, so what counts is the value.
void fill(const RuleContext& c, std::size_t i) {
  const FillSpec& f = c.scene.fills[i];
  const bool box = !(f.lower == Vec3d{} && f.upper == Vec3d{});
  if (box == !f.region.empty()) return c.wrong("fill", i, box ? "region" : nullptr, "give region, or lower and upper");
  if (box) {
    if (!given(c, "fill", i, {"lower", "upper"}, 2, 2, "give lower and upper")) return;
    ordered(c, "fill", i, f.lower, f.upper);
  }
  const bool regular = f.arrangement >= Arrangement::cubic;
  given(c, "fill", i, {"count", "solid_fraction", "mass"}, regular ? 0 : 1, 1,
        regular ? "give one of count, solid_fraction and mass, or none for every site of the lattice"
                : "give one of count, solid_fraction and mass");
  items(c, "fill", i, f.items);
  if (c.scene.dimension == 2 && f.arrangement == Arrangement::fcc)
    c.wrong("fill", i, "arrangement", "is a lattice of space; a 2-D scene allows cubic (squares) and hexagonal");
}

void rain(const RuleContext& c, std::size_t i) {
  const RainSpec& r = c.scene.rains[i];
  given(c, "rain", i, {"rate", "mass_rate"}, 1, 1, "give rate or mass_rate");
  if (!(r.start < r.stop)) c.wrong("rain", i, "stop", fmt::format("allowed rain.stop > rain.start = {}", r.start));
  items(c, "rain", i, r.items);
}

void outlet(const RuleContext& c, std::size_t i) {
  const OutletSpec& o = c.scene.outlets[i];
  const bool none = !c.node("outlet", i, "point") && !c.node("outlet", i, "normal");
  if (o.region.empty() ? none : !(o.point == Vec3d{} && o.normal == Vec3d{}))
    return c.wrong("outlet", i, none ? nullptr : "region", "give region, or point and normal");
  if (o.region.empty() && given(c, "outlet", i, {"point", "normal"}, 2, 2, "give point and normal"))
    c.nonzero("outlet", i, "normal", o.normal);
  if (!(o.velocity == Vec3d{}) && o.recycle_to.empty())
    c.wrong("outlet", i, "velocity", "applies only where recycle_to is given");
  if (!o.recycle_to.empty() && o.recycle_to == o.region)
    c.wrong("outlet", i, "recycle_to", "must not be the region of the outlet itself");
}

void condition(const RuleContext& c, const char* table, std::size_t i, const char* key) {
  const Node* node = c.node(table, i, key);
  Condition parsed;
  ConditionFault fault;
  if (!node || parse_condition(node->text, c.scene, parsed, fault)) return;
  Position at = node->position;
  if (at.line > 0) at.column += 1 + static_cast<int>(fault.at);  // behind the quote
  c.errors.add(at, fmt::format("{}.{} = {}: {}", table, key, to_toml(*node), fault.problem));
}

void event(const RuleContext& c, std::size_t i) {
  const EventSpec& e = c.scene.events[i];
  if (!given(c, "event", i, {"at", "when"}, 1, 1, "give at (s) or when (a condition)")) return;
  condition(c, "event", i, "when");
  if (e.delay > 0 && e.when.empty()) c.wrong("event", i, "delay", "counts from a condition: add it to event.at");
  bool acts = e.stop || !std::isnan(e.gravity.x) || !std::isnan(e.friction);
  for (const std::string* name :
       {&e.remove_wall, &e.insert_wall, &e.start_motion, &e.stop_motion, &e.start_rain, &e.stop_rain, &e.species})
    acts = acts || !name->empty();
  if (!acts)
    c.wrong("event", i, nullptr,
            fmt::format("\"{}\" does nothing: give remove_wall, insert_wall, start_motion, stop_motion, start_rain, "
                        "stop_rain, gravity, friction, species or stop",
                        e.name));
  const bool friction = !std::isnan(e.friction), pair = !e.a.empty() && !e.b.empty();
  if (friction != pair || e.a.empty() != e.b.empty())
    c.wrong("event", i,
            friction      ? "friction"
            : e.a.empty() ? "b"
                          : "a",
            "friction, and the materials a and b between which it acts, go together");
  if (e.species.empty() && !(e.region.empty() && e.material.empty()))
    c.wrong("event", i, e.region.empty() ? "material" : "region", "says which bodies get a species: give species");
  if (!e.insert_wall.empty() && e.insert_wall == e.remove_wall)
    c.wrong("event", i, "insert_wall", "is the wall that this event removes");
  for (const std::string& name : {e.start_motion, e.stop_motion})
    for (const WallSpec& w : c.scene.walls)
      if (w.name == name && w.motion == WallMotion::fixed)
        c.wrong("event", i, name == e.start_motion ? "start_motion" : "stop_motion",
                fmt::format("wall \"{}\" has no motion: give it wall.motion", name));
}

// What an event starts has no start of its own.
void waiting(const RuleContext& c) {
  for (const EventSpec& e : c.scene.events) {
    for (std::size_t w = 0; w < c.scene.walls.size(); ++w)
      if (const WallSpec& wall = c.scene.walls[w]; !e.start_motion.empty() && wall.name == e.start_motion) {
        if (wall.start > 0)
          c.wrong("wall", w, "start", fmt::format("event \"{}\" starts this wall: leave start out", e.name));
        if (std::isfinite(wall.stop))
          c.wrong("wall", w, "stop", fmt::format("event \"{}\" starts this wall: stop it by an event too", e.name));
      }
    for (std::size_t w = 0; w < c.scene.walls.size(); ++w)
      if (c.scene.walls[w].name == e.insert_wall && std::isfinite(c.scene.walls[w].remove_at))
        c.wrong("wall", w, "remove_at",
                fmt::format("event \"{}\" inserts this wall: remove it by an event too", e.name));
    for (std::size_t r = 0; r < c.scene.rains.size(); ++r)
      if (c.scene.rains[r].name == e.start_rain && c.scene.rains[r].start > 0)
        c.wrong("rain", r, "start", fmt::format("event \"{}\" starts this rain: leave start out", e.name));
  }
}

}  // namespace

void check_insertion_rules(const RuleContext& c) {
  for (std::size_t i = 0; i < c.scene.regions.size(); ++i) region(c, i);
  for (std::size_t i = 0; i < c.scene.fills.size(); ++i) fill(c, i);
  for (std::size_t i = 0; i < c.scene.rains.size(); ++i) rain(c, i);
  for (std::size_t i = 0; i < c.scene.outlets.size(); ++i) outlet(c, i);
  for (std::size_t i = 0; i < c.scene.species.size(); ++i)
    if (c.scene.species[i].name == "none") c.wrong("species", i, "name", "is what bodies without a species have");
  for (std::size_t i = 0; i < c.scene.events.size(); ++i) event(c, i);
  condition(c, "run", 0, "until");
  waiting(c);
}

}  // namespace dem
