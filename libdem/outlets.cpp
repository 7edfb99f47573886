#include "libdem/outlets.h"

#include <algorithm>

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

}  // namespace

void remove_behind_outlets(World& world) {
  if (world.scene.outlets.empty()) return;
  Particles& p = world.particles;
  std::vector<std::pair<std::uint32_t, std::size_t>> behind;  // particle, outlet
  for (std::uint32_t i = 0; i < p.count(); ++i)
    for (std::size_t o = 0; o < world.outlets.size(); ++o) {
      const OutletSpec& spec = world.scene.outlets[o];
      if (!(dot(spec.normal, p.motion[i].position - spec.point) < 0)) continue;
      behind.emplace_back(i, o);
      break;
    }
  if (behind.empty()) return;
  std::sort(behind.begin(), behind.end(), [&](const auto& a, const auto& b) { return p.id[a.first] < p.id[b.first]; });
  std::vector<std::uint8_t> leaves(p.count());
  for (const auto& [i, o] : behind) {
    leaves[i] = 1;
    OutletRecord& record = world.outlets[o];
    ++record.count;
    record.mass += p.mass[i];
    ++world.counters.deleted;
    world.balance.removed_mass += p.mass[i];
    for (int k = 0; k < 3; ++k)
      world.balance.removed_momentum[static_cast<std::size_t>(k)].add(p.mass[i] * p.motion[i].velocity[k]);
    world.discharge.push_back({world.time(), world.counters.deleted, world.balance.removed_mass});
  }
  keep(p.id, leaves);
  keep(p.shape, leaves);
  keep(p.kind, leaves);
  keep(p.material, leaves);
  keep(p.size, leaves);
  keep(p.motion, leaves);
  keep(p.orientation, leaves);
  keep(p.rotation, leaves);
  keep(p.angular_momentum, leaves);
  keep(p.inertia, leaves);
  keep(p.mass, leaves);
  keep(p.force, leaves);
  keep(p.torque, leaves);
  world.balance.present_mass = 0;
  for (const std::uint32_t i : order_by_id(world)) world.balance.present_mass += p.mass[i];
  world.contacts.stale = true;
}

}  // namespace dem
