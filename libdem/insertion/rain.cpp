#include "libdem/insertion/rain.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "libdem/build.h"
#include "libdem/insertion/occupancy.h"
#include "libdem/insertion/place.h"

namespace dem {
namespace {

RainRecord& record(World& world, const std::string& name) {
  return *std::find_if(world.rains.begin(), world.rains.end(), [&](const RainRecord& r) { return r.name == name; });
}

void begin(RainRecord& r, double time) {
  r.active = 1;
  r.since = time;
  r.count_before = r.count;
  r.mass_before = r.mass;
}

// Whether body r.count, of mass m, is due now; false for ever once the rain has reached its limits.
bool due(const RainSpec& spec, const RainRecord& r, double time, double m) {
  if (r.active == 0 || time < r.since) return false;
  if (spec.count > 0 && r.count >= spec.count) return false;
  if (spec.mass > 0 && r.mass + m > spec.mass) return false;
  const double elapsed = std::min(time, spec.stop) - r.since;
  if (spec.rate > 0)
    return static_cast<double>(r.count_before) + spec.rate * elapsed >= static_cast<double>(r.count + 1);
  return r.mass_before + spec.mass_rate * elapsed >= r.mass + m;
}

class Pourer {
 public:
  Pourer(World& world, std::size_t rain)
      : world_(world),
        spec_(world.scene.rains[rain]),
        record_(world.rains[rain]),
        recipe_(world, spec_.items, spec_.where),
        stream_(rain_streams + 2 * rain) {}

  void pour() {
    std::optional<Region> region;
    std::optional<Occupancy> taken;
    while (record_.active != 0) {
      Random random(world_.scene.run.seed, stream_, record_.count);
      const Draft body = recipe_.draw(random);
      if (!due(spec_, record_, world_.time(), recipe_.mass(body))) return;
      if (!region || !taken) {
        region.emplace(region_of(world_, spec_.region));
        taken.emplace(world_, region->lower(), region->upper());
      }
      if (!place(body, random, *region, *taken)) return;
    }
  }

 private:
  bool place(const Draft& body, Random& random, const Region& region, Occupancy& taken) {
    const double r = recipe_.radius(body);
    for (int k = 0; k < spec_.tries; ++k) {
      Random place(world_.scene.run.seed, stream_ + 1, record_.tries++);
      const Vec3d x = region.sample(place, r);
      if (taken.blocked(x, r)) continue;
      const Quatd q = spec_.turned == Turned::given ? spec_.orientation : random_orientation(world_, random);
      add_particle(world_, body.shape, body.material, body.scale, x, q, spec_.velocity, {});
      world_.particles.species.back() = body.species;
      taken.add(x, r);
      book(world_.particles.mass.back());
      return true;
    }
    ++record_.waits;
    return false;
  }

  void book(double mass) {
    ++record_.count;
    record_.mass += mass;
    Balance& b = world_.balance;
    ++b.inserted_count;
    b.inserted_mass += mass;
    b.present.add(mass);
    for (int k = 0; k < 3; ++k) b.inserted_momentum[static_cast<std::size_t>(k)].add(mass * spec_.velocity[k]);
    world_.contacts.stale = true;
  }

  World& world_;
  const RainSpec& spec_;
  RainRecord& record_;
  Recipe recipe_;
  std::uint64_t stream_;
};

}  // namespace

void prepare_rain(World& world) {
  for (const RainSpec& spec : world.scene.rains) {
    RainRecord r;
    r.name = spec.name;
    begin(r, spec.start);
    for (const EventSpec& e : world.scene.events)
      if (e.start_rain == spec.name) r.active = 0;
    world.rains.push_back(r);
    const Recipe recipe(world, spec.items, spec.where);
    if (!region_of(world, spec.region).has_room_for(recipe.largest_radius()))
      input_error(spec.where, "rain \"" + spec.name + "\": region \"" + spec.region +
                                  "\" has no room for its largest body, of bounding diameter " +
                                  std::to_string(2 * recipe.largest_radius()) + " m");
  }
}

void start_rain(World& world, const std::string& name) {
  RainRecord& r = record(world, name);
  if (r.active == 0) begin(r, world.time());
}

void stop_rain(World& world, const std::string& name) { record(world, name).active = 0; }

void insert_rain(World& world) {
  for (std::size_t i = 0; i < world.rains.size(); ++i)
    if (world.rains[i].active != 0) Pourer(world, i).pour();
}

std::vector<Draft> coming_bodies(const World& world) {
  std::vector<Draft> list;
  for (const RainSpec& spec : world.scene.rains)
    for (const Draft& d : Recipe(world, spec.items, spec.where).smallest()) list.push_back(d);
  return list;
}

}  // namespace dem
