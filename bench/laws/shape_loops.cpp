// Work over closed paths in the pose of two bodies, or a body and a wall, for each pair of shapes, law and map, through
// the loop's own force pass. What contacts give back more than they were given, they have created.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <set>

#include "bench/laws/report.h"
#include "libdem/scene/where.h"
#include "tests/libdem/loop_laws.h"
#include "tests/libdem/pose_loops.h"
#include "tests/libdem/shape_samples.h"

namespace laws {
namespace {

using namespace dem;
using loops::Arena;
using loops::Loop;
using loops::Style;
using loops::Variant;
using samples::SamplePair;

constexpr int coarse = 64, most_steps = 512, most_steps_conserving = 4096;
constexpr double duration = 2e-3;  // s, of a lap

// Shifts, turns and both, small and large; rolling. Never apart, or apart once.
constexpr Style styles[] = {{true, false, false, false, 0.02}, {false, true, false, false, 0.02},
                            {true, true, false, true, 0.1},    {false, true, true, false, 0.3},
                            {true, true, false, false, 0.3},   {false, true, true, true, 0.3}};

Scene plain_scene(const SamplePair& pair) {
  const auto law = pair.planar() ? LawName::linear_spring : LawName::hertz_mindlin;
  const Variant v = loops::variant_of(static_cast<std::size_t>(law), 0, true);
  return samples::scene_of(pair, v.law, v.material);
}

// `arena`: under the plain law.
std::vector<Loop> loops_of(Arena& arena, const SamplePair& pair, std::uint64_t seed) {
  const bool planar = pair.planar();
  std::vector<Loop> list;
  shapes::Random random(seed, 17, 0);
  for (const Style& style : styles) {
    const auto [along, rest] = loops::random_meeting(planar, pair.resting.is_wall(), random);
    arena.rest(rest);
    const auto path = loops::random_path(arena, along, planar, style, samples::size, random);
    list.emplace_back(path, rest, style.parts, most_steps_conserving);
  }
  return list;
}

struct Cell {
  double created = -1e300;  // over the largest energy stored
  double change = 1e300;    // by halving the step; at least half of that by the halving before
  int steps = 0;
  std::size_t loop = 0;
  int stopped = 0;  // loops that the force pass refused
  bool met() const { return created > -1e300; }
  bool resolved() const { return change < 1e-10 || std::abs(created) > 4 * change; }
  bool creates() const { return resolved() && created > std::max(1e-10, 4 * change); }
};

double created_by(Arena& arena, const Variant& v, const Loop& loop, int steps) {
  const auto lap = loops::go_round(arena, loop, steps, loop.parts || v.conserves ? 1 : 2, duration);
  if (!(lap.stored > 0)) return -1e300;  // they never met
  const double share = lap.created / lap.stored;
  return v.conserves ? std::abs(share) : share;  // backwards it is the other sign
}

void refine(Arena& arena, const Variant& v, const Loop& loop, Cell& c) {
  c.steps *= 2;
  const double finer = created_by(arena, v, loop, c.steps);
  c.change = std::max(std::abs(finer - c.created), 0.5 * c.change);
  c.created = finer;
}

// Where features come and go the force has kinks, and halving the step may change little by chance: four times finer,
// what is real stays.
void confirm(Arena& arena, const Variant& v, const Loop& loop, Cell& c) {
  c.steps *= 4;
  const double finer = created_by(arena, v, loop, c.steps);
  c.change = std::max(std::abs(finer - c.created), c.change);
  c.created = finer;
}

// The worst of the loops, at the first step that resolves it. Those come first that give most beyond what halving
// changes, if any does; else those that may.
Cell measure(Arena& arena, const Variant& v, const std::vector<Loop>& list) {
  std::vector<Cell> cells;
  Cell worst;
  for (std::size_t i = 0; i < list.size(); ++i) {
    try {
      Cell c{created_by(arena, v, list[i], coarse), 0, coarse, i, 0};
      if (!c.met()) continue;
      refine(arena, v, list[i], c);
      cells.push_back(c);
    } catch (const RunError&) {
      ++worst.stopped;
    }
  }
  const auto proven = [](const Cell& c) { return c.created - 2 * c.change; };
  std::sort(cells.begin(), cells.end(), [&](const Cell& a, const Cell& b) {
    const bool known = std::max(proven(a), proven(b)) > 1e-10;
    return known ? proven(a) > proven(b) : a.created > b.created;
  });
  const int stopped = worst.stopped, limit = v.conserves ? most_steps_conserving : most_steps;
  int looked = 0;
  for (Cell& c : cells) {
    if (worst.met() && (!(proven(c) > 1e-10) || ++looked > 2)) break;
    try {
      do refine(arena, v, list[c.loop], c);
      while (!c.resolved() && c.steps < limit);
      if (c.creates() && 4 * c.steps <= most_steps_conserving) confirm(arena, v, list[c.loop], c);
    } catch (const RunError&) {
      continue;
    }
    if (c.created > worst.created || c.creates()) worst = c;
    if (worst.creates()) break;
  }
  worst.stopped = stopped;
  return worst;
}

// Shapes whose contacts have no one potential: why; null: they have.
const char* known(const SamplePair& pair) {
  const bool on_plane = pair.resting.kind == shapes::Kind::plane;
  for (const auto* s : {&pair.moving, &pair.resting}) {
    if (s->kind == shapes::Kind::rounded_polyhedron && !on_plane) return "patches of rounded faces";
    if (s->kind == shapes::Kind::compound) return "parts that share a stiffness";
    if (s->kind == shapes::Kind::mesh) return "facets of a mesh";
  }
  return nullptr;
}

struct Row {  // of a pair and a map
  int cells = 0, creating = 0;
  Cell worst, worst_conserving;
  std::string law;
};

}  // namespace

void shape_loops(Report& r) {
  r.heading(
      fmt::format("{} random loops of pose each, {} to {} steps: work of the worst lap and its gain of stored energy,",
                  std::size(styles), coarse, most_steps));
  r.heading("over the largest energy stored; of laws without friction and loss the larger of both senses, at up to");
  r.heading(fmt::format("{} steps. Creates: by more than 1e-10 and four times what halving the step changes",
                        most_steps_conserving));
  std::ofstream csv;
  if (r.draws()) {
    csv.open(r.path("shape_loops.csv"));
    csv << "moving,resting,law,map,created,change_by_halving,steps,loop,stopped,verdict,known\n";
  }
  int cells = 0, never = 0, unresolved = 0, told = 0, stopped = 0;
  struct Creator {
    double created;
    std::string pair, text;
  };
  std::vector<Creator> creators;
  const std::vector<Variant> variants = loops::every_variant();
  std::uint64_t seed = 0;
  for (const SamplePair& pair : samples::every_pair()) {
    Arena arena(plain_scene(pair));
    const std::vector<Loop> list = loops_of(arena, pair, ++seed);
    for (const LawMap map : loops::every_map) {
      Row row;
      for (Variant v : variants) {
        v.law.map = map;
        v.law.edge_radius = map == LawMap::edge_radius ? 0.1 * samples::size : 0;
        if (v.damped && map != LawMap::automatic && map != LawMap::equivalent_radius) continue;
        if (!loops::worth_measuring(map, law_model_of(v.law), pair.moving.kind, pair.resting.kind)) continue;
        if (!arena.put_under(v.law, v.material)) continue;
        const Cell c = measure(arena, v, list);
        const char* why = v.literal != nullptr ? v.literal : known(pair);
        ++cells;
        ++row.cells;
        stopped += c.stopped;
        if (!c.creates()) {
          ++never;
          if (!c.resolved()) ++unresolved;
        } else {
          ++row.creating;
          if (why != nullptr) ++told;
          creators.push_back({c.created, pair.name() + (why != nullptr ? why : ""),
                              fmt::format("{}, {}, {}, loop {}{}", pair.name(), v.name, name_of(map), c.loop,
                                          why != nullptr ? fmt::format(" [{}]", why) : "")});
        }
        if (c.created > row.worst.created) row.worst = c, row.law = v.name;
        if (v.conserves && c.created > row.worst_conserving.created) row.worst_conserving = c;
        if (csv.is_open())
          csv << fmt::format("{},{},\"{}\",{},{:.6e},{:.2e},{},{},{},{},{}\n", pair.moving.name, pair.resting.name,
                             v.name, name_of(map), c.created, c.change, c.steps, c.loop, c.stopped,
                             c.creates() ? "creates" : (c.resolved() ? "none" : "none seen"),
                             why != nullptr ? why : "");
      }
      if (row.cells == 0) continue;
      r.note(
          fmt::format("{}, {}: {} of {} create; worst {}", pair.name(), name_of(map), row.creating, row.cells, row.law),
          fmt::format("{:.1e} ±{:.0e}; slope {:.1e} ±{:.0e}", row.worst.created, row.worst.change,
                      row.worst_conserving.created, row.worst_conserving.change));
    }
  }
  std::sort(creators.begin(), creators.end(), [](const Creator& a, const Creator& b) { return a.created > b.created; });
  std::set<std::string> listed;  // pairs, and why
  for (const Creator& c : creators)
    if (listed.insert(c.pair).second) r.note(c.text, c.created);
  r.is_true(
      fmt::format(
          "{} cells, {} never create ({} of them as far as the step resolves), {} create as known, {} loops stopped",
          cells, never, unresolved, told, stopped),
      cells == never + told, "0 others", fmt::format("{} others", cells - never - told));
}

}  // namespace laws
