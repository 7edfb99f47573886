// What coordination.h and constraints.h find, as numbers and tables.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "libdem/analysis/constraints.h"
#include "libdem/analysis/coordination.h"
#include "libdem/analysis/grid.h"
#include "libdem/analysis/table.h"

namespace dem::analysis {

namespace {

void add_if(Result& r, const char* name, const std::optional<double>& value) {
  if (value) r.add(name, "1", *value);
}

double share(double part, double of) { return of > 0 ? part / of : 0; }

void add_backbone(Result& r, const Snapshot& s, const Pairs& pairs, const Coordination& c, std::uint32_t least,
                  const char* kind) {
  const Backbone b = backbone_of(s, pairs, c, least);
  const std::string name = kind;
  r.add("rattlers_" + name, "1", share(static_cast<double>(b.rattlers), static_cast<double>(c.bodies)));
  add_if(r, ("coordination_backbone_" + name).c_str(), b.mean);
  add_if(r, ("coordination_backbone_" + name + "_with_walls").c_str(), b.mean_with_walls);
}

Table distribution(const Coordination& c) {
  std::map<std::uint32_t, double> bodies;
  for (std::size_t i = 0; i < c.counted.size(); ++i)
    if (c.counted[i] != 0) ++bodies[c.of_body[i]];
  Table t = table_of("distribution", "Bodies by number of contacts with other bodies",
                     {{"contacts", "1"}, {"bodies", "1"}, {"share", "1"}});
  for (std::uint32_t k = 0; !bodies.empty() && k <= bodies.rbegin()->first; ++k) {
    const double n = bodies.contains(k) ? bodies[k] : 0;
    add_row(t, k, n, n / static_cast<double>(c.bodies));
  }
  return t;
}

// Mean number of contacts of a body of species a with bodies of species b.
Table by_species(const Snapshot& s, const Pairs& pairs, const Coordination& c) {
  std::map<std::uint32_t, double> bodies;
  std::map<std::pair<std::uint32_t, std::uint32_t>, double> met;
  for (std::size_t i = 0; i < s.count(); ++i)
    if (c.counted[i] != 0) ++bodies[s.species[i]];
  for (const Pair& p : pairs.bodies) {
    met[{s.species[p.a], s.species[p.b]}] += c.counted[p.a];
    met[{s.species[p.b], s.species[p.a]}] += c.counted[p.b];
  }
  Table t = table_of("species", "Mean number of contacts of a body of one species with those of another",
                     {{"species", "1"}, {"with_species", "1"}, {"bodies", "1"}, {"coordination", "1"}});
  for (const auto& [a, n] : bodies)
    for (const auto& [b, unused] : bodies) {
      add_row(t, a, b, n, met.contains({a, b}) ? met[{a, b}] / n : 0);
    }
  return t;
}

Table by_box(const Snapshot& s, const Settings& settings, const Coordination& c) {
  const Grid grid = grid_of(s, settings);
  std::vector<double> bodies(grid.size(), 0), contacts(grid.size(), 0), walls(grid.size(), 0);
  for (std::size_t i = 0; i < s.count(); ++i) {
    const std::size_t at = grid.index(s.position[i]);
    if (at == Grid::none) continue;
    ++bodies[at];
    contacts[at] += c.of_body[i];
    walls[at] += c.walls_of_body[i];
  }
  Table t = table_of(
      "boxes", "Contacts per body, of the bodies whose centres are in a box",
      {{"x", "m"}, {"y", "m"}, {"z", "m"}, {"bodies", "1"}, {"coordination", "1"}, {"coordination_with_walls", "1"}});
  for (std::size_t at = 0; at < grid.size(); ++at) {
    if (bodies[at] <= 0) continue;
    const Vec3d x = grid.centre(at);
    add_row(t, x.x, x.y, x.z, bodies[at], contacts[at] / bodies[at], (contacts[at] + walls[at]) / bodies[at]);
  }
  return t;
}

void add_constraints(Result& r, Table& bodies, const Snapshot& s, const Pairs& pairs, const Coordination& c) {
  const Constraints found = constraints_of(s, pairs);
  std::vector<double> of_body(s.count(), 0);
  std::array<double, 7> kinds{};
  double total = 0, freedom = 0;
  for (std::size_t k = 0; k < pairs.bodies.size(); ++k) {
    of_body[pairs.bodies[k].a] += found.of_pair[k];
    of_body[pairs.bodies[k].b] += found.of_pair[k];
    ++kinds[found.of_pair[k]];
  }
  for (std::size_t k = 0; k < pairs.walls.size(); ++k) of_body[pairs.walls[k].a] += found.of_wall[k];
  for (std::size_t i = 0; i < s.count(); ++i) {
    if (c.counted[i] == 0) continue;
    total += of_body[i];
    freedom += degrees_of_freedom(s, i);
  }
  const auto np = static_cast<double>(c.bodies), nc = static_cast<double>(pairs.bodies.size());
  r.add("constraints_per_body", "1", share(total, np));
  r.add("isostatic_constraints_per_body", "1", share(2 * freedom, np));
  const auto simple = static_cast<std::size_t>(s.dimension);  // what one flat patch can have
  const char* names[] = {"point_contacts", "edge_contacts", "face_contacts"};
  double several = nc;
  for (std::size_t k = 0; k < simple; ++k) {
    r.add(names[k], "1", share(kinds[k + 1], nc));
    several -= kinds[k + 1];
  }
  r.add("several_contacts", "1", share(several, nc));
  r.notes.emplace_back(
      s.dimension == 3
          ? "constraints: of frictionless contacts, face 3, edge 2, point 1, several patches more; walls too"
          : "constraints: of frictionless contacts, side 2, corner 1, several patches more; walls too");
  if (found.from_points)
    r.notes.emplace_back(
        "constraints of bodies of parts and of non-convex polygons: by the points of their records alone");
  bodies.columns.push_back({"constraints", "1", std::move(of_body)});
}

void add_lines(Result& r, const Snapshot& s, const Settings& settings, const Coordination& c) {
  double solid = 0;
  for (std::size_t i = 0; i < s.count(); ++i)
    if (c.counted[i] != 0) solid += s.volume[i];
  const double space = Grid(s, region_of(s, settings), {1, 1, 1}).box_volume();
  const double d = space > 0 ? solid / space : 0;
  if (!(d > 0 && d < 1)) return;
  r.add("solid_fraction_by_centres", "1", d);
  r.add("line_9_44", "1", line_of_ordered(d));
  r.add("line_9_45", "1", line_of_random(d));
  r.notes.emplace_back(
      "(9.44) and (9.45): Z expected at the density of the bodies whose centres are in the region; (9.45) fits random "
      "packings, not lattices");
}

}  // namespace

Result report_coordination(const Snapshot& s, const Settings& settings) {
  Result r;
  if (lacks_contacts(s, r)) return r;
  const Pairs pairs = pairs_of(s);
  const Coordination c = coordination_of(s, pairs, settings.region);
  r.add("bodies", "1", static_cast<double>(c.bodies));
  r.add("contacts", "1", static_cast<double>(pairs.bodies.size()));
  r.add("wall_contacts", "1", static_cast<double>(pairs.walls.size()));
  if (c.bodies == 0) {
    r.notes.emplace_back("no bodies in the region");
    return r;
  }
  r.add("coordination", "1", c.mean);
  r.add("coordination_with_walls", "1", c.mean_with_walls);
  add_if(r, "mechanical_coordination", c.mechanical);
  add_if(r, "mechanical_coordination_both_ends", c.mechanical_both_ends);
  if (!c.mechanical) r.notes.emplace_back("(9.43) has no value: no body has two contacts");
  add_backbone(r, s, pairs, c, 2, "friction");
  const auto least = static_cast<std::uint32_t>(s.dimension) + 1;
  add_backbone(r, s, pairs, c, least, "frictionless");
  r.notes.push_back(
      fmt::format("rattlers: removed again and again, walls count as contacts; with friction below 2 contacts, without "
                  "below {} (spheres without weight: weight replaces one contact, a flat face up to three)",
                  least));
  if (std::any_of(pairs.bodies.begin(), pairs.bodies.end(),
                  [](const Pair& p) { return p.tangential > 1e-9 * norm(p.force); }))
    r.notes.emplace_back("tangential forces act: the rattlers without friction do not apply to these bodies");
  Table bodies = table_of("bodies", "Contacts of each body",
                          {{"id", "1"}, {"contacts", "1"}, {"wall_contacts", "1"}, {"rattler", "1"}});
  const Backbone held = backbone_of(s, pairs, c, 2);
  for (std::size_t i = 0; i < s.count(); ++i) {
    add_row(bodies, s.id[i], c.of_body[i], c.walls_of_body[i], held.rattles[i]);
  }
  add_constraints(r, bodies, s, pairs, c);
  add_lines(r, s, settings, c);
  r.tables.push_back(distribution(c));
  r.tables.push_back(by_species(s, pairs, c));
  r.tables.push_back(by_box(s, settings, c));
  r.tables.push_back(std::move(bodies));
  return r;
}

}  // namespace dem::analysis
