#include "libdem/outlets.h"

#include <algorithm>
#include <map>
#include <optional>

#include "libdem/build.h"
#include "libdem/insertion/occupancy.h"
#include "libdem/insertion/place.h"

namespace dem {
namespace {

// Keeps the entries whose mark is not set, in order.
template <class T>
void keep(std::vector<T>& v, const std::vector<std::uint8_t>& leaves) {
  std::size_t n = 0;
  for (std::size_t i = 0; i < v.size(); ++i)
    if (leaves[i] == 0) v[n++] = v[i];
  v.resize(n);
}

void add_momentum(std::array<Accumulator, 3>& sum, double mass, const Vec3d& velocity) {
  for (int k = 0; k < 3; ++k) sum[static_cast<std::size_t>(k)].add(mass * velocity[k]);
}

class Outlets {
 public:
  explicit Outlets(World& world) : world_(world) {}

  void work() {
    const std::vector<std::pair<std::uint32_t, std::size_t>> found = behind();
    if (found.empty()) return;
    Particles& p = world_.particles;
    std::vector<std::uint8_t> leaves(p.count());
    bool any = false;
    for (const auto& [i, o] : found) {
      if (!world_.scene.outlets[o].recycle_to.empty()) {
        recycle(i, o);
        continue;
      }
      any = true;
      leaves[i] = 1;
      count(i, o);
      ++world_.counters.deleted;
      world_.balance.removed_mass += p.mass[i];
      world_.balance.present.add(-p.mass[i]);
      add_momentum(world_.balance.removed_momentum, p.mass[i], p.motion[i].velocity);
    }
    if (!any) return;
    Particles::each_array(p, [&](auto& array) { keep(array, leaves); });
    world_.contacts.stale = true;
  }

 private:
  // Particle and outlet, in order of id.
  std::vector<std::pair<std::uint32_t, std::size_t>> behind() const {
    const Particles& p = world_.particles;
    std::vector<std::optional<Region>> regions;
    for (const OutletSpec& spec : world_.scene.outlets) {
      regions.emplace_back();
      if (!spec.region.empty()) regions.back().emplace(region_of(world_, spec.region));
    }
    std::vector<std::pair<std::uint32_t, std::size_t>> found;
    for (std::uint32_t i = 0; i < p.count(); ++i)
      for (std::size_t o = 0; o < regions.size(); ++o) {
        const OutletSpec& spec = world_.scene.outlets[o];
        const Vec3d& x = p.motion[i].position;
        const std::optional<Region>& region = regions[o];
        if (!(region ? region->holds(x) : dot(spec.normal, x - spec.point) < 0)) continue;
        found.emplace_back(i, o);
        break;
      }
    std::sort(found.begin(), found.end(), [&](const auto& a, const auto& b) { return p.id[a.first] < p.id[b.first]; });
    return found;
  }

  void count(std::uint32_t i, std::size_t o) {
    const Particles& p = world_.particles;
    OutletRecord& record = world_.outlets[o];
    ++record.count;
    record.mass += p.mass[i];
    ++record.by_species[p.species[i]];
    const bool first = world_.discharge.empty();
    world_.discharge.push_back({world_.time(), first ? 1 : world_.discharge.back().count + 1,
                                (first ? 0 : world_.discharge.back().mass) + p.mass[i], static_cast<std::uint32_t>(o),
                                p.species[i]});
  }

  // The same body, with its id, goes on elsewhere, without spin. While every place tried is taken it goes on where it
  // is and is not counted.
  void recycle(std::uint32_t i, std::size_t o) {
    constexpr int tries = 20;
    const OutletSpec& spec = world_.scene.outlets[o];
    OutletRecord& record = world_.outlets[o];
    Particles& p = world_.particles;
    const Region region = region_of(world_, spec.recycle_to);
    auto taken = taken_.find(o);
    if (taken == taken_.end()) taken = taken_.emplace(o, Occupancy(world_, region.lower(), region.upper())).first;
    const double r = p.motion[i].bounding_radius;
    for (int k = 0; k < tries; ++k) {
      Random random(world_.scene.run.seed, recycle_streams + o, record.tries++);
      const Vec3d x = region.sample(random, r);
      if (taken->second.blocked(x, r)) continue;
      for (auto& other : taken_) other.second.add(x, r);
      count(i, o);
      add_momentum(world_.balance.removed_momentum, p.mass[i], p.motion[i].velocity);
      add_momentum(world_.balance.inserted_momentum, p.mass[i], spec.velocity);
      p.motion[i].position = x;
      p.motion[i].velocity = spec.velocity;
      p.motion[i].spin = p.angular_momentum[i] = {};
      world_.contacts.stale = true;
      return;
    }
    ++record.waits;
  }

  World& world_;
  std::map<std::size_t, Occupancy> taken_;
};

}  // namespace

void remove_behind_outlets(World& world) {
  if (!world.scene.outlets.empty()) Outlets(world).work();
}

}  // namespace dem
