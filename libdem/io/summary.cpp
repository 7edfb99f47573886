// summary.json: what a run did, in one page. Keys: title, version, end, steps, time, dt, dt_limit, dt_limited_by,
// threads, particles, particle_steps_per_s, seconds, contacts_per_particle, counters, pairs (since the start or the
// last resume), energies, momentum, momentum_balance, mass_balance, cell (periodic scenes), outlets, materials and
// published_friction with their sources, walls, state_hash. SI units.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "libdem/deformation.h"
#include "libdem/io/files.h"
#include "libdem/io/io.h"

namespace dem::io {

namespace {

using Json = nlohmann::ordered_json;

Json list(const Vec3d& v) { return {v.x, v.y, v.z}; }
Vec3d value(const std::array<Accumulator, 3>& a) { return {a[0].value(), a[1].value(), a[2].value()}; }

double total_mass(const World& world) {
  Accumulator mass;
  for (const std::uint32_t i : order_by_id(world)) mass.add(world.particles.mass[i]);
  return mass.value();
}

// p + p_removed − p_initial − p_inserted = ∫F dt over the run. The error is relative to the largest momentum in play:
// any term of the balance, Σ m|v|, or the impulse of the weight (which a bed at rest takes up without moving).
Json momentum_balance(const World& world, double mass) {
  const auto& start = world.balance.initial_momentum;
  const Vec3d initial{start[0], start[1], start[2]};
  const Vec3d impulse = value(world.balance.impulse), removed = value(world.balance.removed_momentum);
  const Vec3d inserted = value(world.balance.inserted_momentum);
  const Vec3d current = momentum(world);
  Accumulator moving;
  for (const std::uint32_t i : order_by_id(world))
    moving.add(world.particles.mass[i] * norm(world.particles.motion[i].velocity));
  const double scale = std::max({norm(initial), norm(impulse), norm(removed), norm(inserted), norm(current),
                                 moving.value(), mass * norm(world.scene.gravity) * world.time()});
  const double difference = norm(current + removed - initial - inserted - impulse);
  return {{"initial", list(initial)},
          {"impulse", list(impulse)},
          {"removed", list(removed)},
          {"inserted", list(inserted)},
          {"current", list(current)},
          {"scale", scale},
          {"relative_error", scale > 0 ? difference / scale : 0.0}};
}

Json mass_balance(const World& world, double mass) {
  const Balance& b = world.balance;
  const std::size_t present = world.particles.count();
  const double difference = std::abs(mass + b.removed_mass - b.initial_mass - b.inserted_mass),
               all = b.initial_mass + b.inserted_mass;
  return {{"initial", b.initial_mass},
          {"present", mass},
          {"removed", b.removed_mass},
          {"inserted", b.inserted_mass},
          {"relative_error", all > 0 ? difference / all : 0.0},
          {"initial_count", present + world.counters.deleted - b.inserted_count},
          {"inserted_count", b.inserted_count},
          {"present_count", present},
          {"removed_count", world.counters.deleted}};
}

// The box; where it is periodic along every axis, what it bears and holds too.
Json cell(const World& world) {
  const Cell& c = world.cell;
  Json box{{"lower", list(c.lower)}, {"lengths", list(c.lattice.length)}};
  if (!is_whole(world)) return box;
  const Mat3d s = cell_stress(world);
  const Coordination z = coordination(world);
  box["rates"] = list(c.lattice.rate);
  box["stress"] = {list(s.row[0]), list(s.row[1]), list(s.row[2])};
  box["solid_fraction"] = solid_fraction(world);
  box["coordination"] = z.all;
  box["rattlers"] = z.rattlers;
  box["coordination_backbone"] = z.backbone;
  box["work"] = c.work.value();
  return box;
}

Json outlet(const World& world, std::size_t o) {
  const OutletRecord& r = world.outlets[o];
  Json out{{"name", r.name}, {"count", r.count}, {"mass", r.mass}};
  if (world.scene.species.empty()) return out;
  for (std::size_t s = 0; s < r.by_species.size(); ++s)
    out["by_species"][species_name(world, static_cast<std::uint32_t>(s))] = r.by_species[s];
  return out;
}

// What became of the candidates, by pair of kinds.
Json coherence(const Profile& profile) {
  Json out = Json::array();
  const auto add = [&out](const std::string& pair, const Tally& t) {
    if (t.candidates == 0) return;
    out.push_back({{"pair", pair},
                   {"candidates", t.candidates},
                   {"refused_by_displacement", t.by_displacement},
                   {"refused_by_spheres", t.by_spheres},
                   {"refused_by_axis", t.by_axis},
                   {"touching", t.touching},
                   {"uncertified", t.uncertified},
                   {"handed_over", t.handed_over},
                   {"not_converged", t.not_converged}});
  };
  for (std::size_t a = 0; a < shapes::kind_count; ++a)
    for (std::size_t b = 0; b < shapes::kind_count; ++b)
      add(fmt::format("{}, {}", shapes::name_of(static_cast<shapes::Kind>(a)),
                      shapes::name_of(static_cast<shapes::Kind>(b))),
          profile.pairs[a][b]);
  add("bodies of parts", profile.parts);
  return out;
}

Json species_counts(const World& world) {
  std::vector<std::uint64_t> count(world.scene.species.size() + 1);
  for (const std::uint32_t s : world.particles.species) ++count[s];
  Json out;
  for (std::size_t s = 0; s < count.size(); ++s) out[species_name(world, static_cast<std::uint32_t>(s))] = count[s];
  return out;
}

}  // namespace

void write_summary(const std::string& path, const World& world, const std::string& end, int threads) {
  const double mass = total_mass(world);
  const PhaseTimes& t = world.times;
  const Counters& c = world.counters;
  const Energies e = energies(world);

  Json summary;
  summary["title"] = world.scene.title;
  summary["version"] = version;
  summary["end"] = end;
  summary["steps"] = world.step;
  summary["time"] = world.time();
  summary["dt"] = world.time_step.dt;
  summary["dt_limit"] = world.time_step.limit;
  summary["dt_limited_by"] = world.time_step.limited_by;
  summary["threads"] = threads;
  summary["particles"] = world.particles.count();
  summary["particle_steps_per_s"] = t.loop > 0 ? static_cast<double>(t.particle_steps) / t.loop : 0.0;
  summary["seconds"] = {{"broad_phase", t.broad}, {"query", t.query},   {"integrate", t.integrate},
                        {"walls", t.walls},       {"output", t.output}, {"loop", t.loop}};
  summary["contacts_per_particle"] = contacts_per_particle(world);
  summary["counters"] = {{"rebuilds", c.rebuilds},
                         {"candidates", c.candidates},
                         {"queries", c.queries},
                         {"contact_steps", c.contact_steps},
                         {"not_converged", c.not_converged},
                         {"uncertified", c.uncertified},
                         {"handed_over", c.handed_over},
                         {"deleted", c.deleted},
                         {"inserted", c.inserted}};
  summary["pairs"] = coherence(world.profile);
  summary["energies"] = {{"translational", e.translational},
                         {"rotational", e.rotational},
                         {"potential", e.potential},
                         {"elastic", e.elastic}};
  summary["momentum"] = list(momentum(world));
  summary["momentum_balance"] = momentum_balance(world, mass);
  summary["mass_balance"] = mass_balance(world, mass);
  if (world.cell.periodic) summary["cell"] = cell(world);
  summary["outlets"] = Json::array();
  for (std::size_t o = 0; o < world.outlets.size(); ++o) summary["outlets"].push_back(outlet(world, o));
  if (!world.scene.species.empty()) summary["species"] = species_counts(world);
  summary["rain"] = Json::array();
  for (const RainRecord& r : world.rains)
    summary["rain"].push_back({{"name", r.name}, {"count", r.count}, {"mass", r.mass}, {"waited_steps", r.waits}});
  summary["events"] = Json::array();
  for (const EventRecord& e : world.events)
    summary["events"].push_back(
        {{"name", e.name},
         {"time", e.done > 0 ? Json(static_cast<double>(e.done) * world.time_step.dt) : Json(nullptr)}});
  summary["materials"] = Json::array();
  for (const MaterialSpec& m : world.scene.materials)
    summary["materials"].push_back({{"name", m.name}, {"like", m.like}, {"source", m.source}});
  summary["published_friction"] = Json::array();
  for (const MaterialPairSpec& p : world.scene.pairs)
    if (!p.source.empty())
      summary["published_friction"].push_back({{"a", p.a}, {"b", p.b}, {"friction", p.friction}, {"source", p.source}});
  summary["walls"] = Json::array();
  for (const Wall& w : world.walls)
    summary["walls"].push_back({{"name", w.name}, {"force", list(w.force)}, {"torque", list(w.torque)}});
  summary["state_hash"] = fmt::format("{:016x}", state_hash(world));
  write_file(path, summary.dump(2) + "\n");
}

}  // namespace dem::io
