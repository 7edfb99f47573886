// What a world says about itself: contacts, energies, momentum, hash.
#include <algorithm>
#include <cstring>
#include <numeric>

#include "libdem/build.h"

namespace dem {
namespace {

std::vector<std::uint32_t> touching_by_key(const Contacts& c) {
  std::vector<std::uint32_t> list;
  for (std::size_t k = 0; k < c.count(); ++k)
    if (c.touching[k] != 0) list.push_back(static_cast<std::uint32_t>(k));
  std::sort(list.begin(), list.end(), [&](std::uint32_t a, std::uint32_t b) { return c.key[a] < c.key[b]; });
  return list;
}

}  // namespace

// Contacts in lanes do not keep it: it is midway in the overlap.
Vec3d contact_point(const World& world, std::size_t k) {
  const Contacts& c = world.contacts;
  const Particles& p = world.particles;
  const Motion& a = p.motion[c.index_a[k]];
  if (!c.centre.empty() && !(c.centre[k] == Vec3d{})) return a.position + c.centre[k];
  const auto smooth = [&](std::uint32_t i) {
    return p.kind[i] == shapes::Kind::ellipsoid || p.kind[i] == shapes::Kind::ellipse;
  };
  if (c.key[k].b < wall_base && smooth(c.index_a[k]) && smooth(c.index_b[k])) {
    const Vec3d& n = c.history_of(k).normal;
    const auto support = [&](std::uint32_t i) {  // point farthest along n from the centre
      const Mat3d r = shapes::rotation_matrix(p.orientation[i]);
      const Vec3d u = scaled(p.size[i], transposed_times(r, n));
      return r * scaled(p.size[i], u * (1 / norm(u)));
    };
    const Vec3d apart = p.motion[c.index_b[k]].position - a.position;
    const Vec3d d = world.cell.periodic ? world.cell.lattice.nearest(apart) : apart;
    return a.position + 0.5 * (support(c.index_a[k]) + (d - support(c.index_b[k])));
  }
  return a.position + c.history_of(k).normal * (a.bounding_radius - 0.5 * c.history_of(k).overlap);
}

std::vector<std::uint32_t> order_by_id(const World& world) {
  std::vector<std::uint32_t> order(world.particles.count());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t a, std::uint32_t b) { return world.particles.id[a] < world.particles.id[b]; });
  return order;
}

std::vector<ContactReport> touching_contacts(const World& world) {
  const Contacts& c = world.contacts;
  const Particles& p = world.particles;
  std::vector<ContactReport> list;
  for (const std::uint32_t k : touching_by_key(c)) {
    ContactReport r;
    r.wall = c.key[k].b >= wall_base;
    r.a = p.id[c.index_a[k]];
    r.b = r.wall ? c.index_b[k] : p.id[c.index_b[k]];
    r.part = c.key[k].part;
    r.part_a = c.key[k].part_a;
    r.overlap = c.history_of(k).overlap;
    r.normal = c.history_of(k).normal;
    r.point = contact_point(world, k);
    r.force = c.slot[c.slot_of(k)].force;
    r.tangential = r.force - r.normal * dot(r.normal, r.force);
    list.push_back(r);
  }
  return list;
}

Energies energies(const World& world) {
  const Particles& p = world.particles;
  const Contacts& c = world.contacts;
  Energies e;
  for (const std::uint32_t i : order_by_id(world)) {
    const Motion& m = p.motion[i];
    e.translational += 0.5 * p.mass[i] * dot(m.velocity, m.velocity);
    e.rotational += 0.5 * dot(m.spin, p.angular_momentum[i]);
    e.potential -= p.mass[i] * dot(world.scene.gravity, m.position);
  }
  // Elastic energy of the normal springs and of the tangential ones at their present stiffness.
  const double share = world.law.hertzian ? 4.0 / 15.0 : 0.5;  // of kn δ²
  for (const std::uint32_t k : touching_by_key(c)) {
    if (c.words > 0) {  // laws in stages leave their energy
      e.elastic += c.memory[(k + 1) * c.words - 1];
      continue;
    }
    const contact::History& h = c.history_of(k);
    const Stiffness s = contact_stiffness(world, k);
    e.elastic += share * s.n * h.overlap * h.overlap;
    if (s.t > 0) e.elastic += 0.5 * dot(h.force_t, h.force_t) / s.t;
  }
  return e;
}

std::array<double, contact::mechanism_count> dissipated(const World& world) {
  const Contacts& c = world.contacts;
  auto lost = world.balance.lost;
  if (!c.ledger.empty())
    for (const std::uint32_t k : touching_by_key(c))
      for (std::size_t m = 0; m < lost.size(); ++m) lost[m].add(c.ledger[k].lost[m]);
  std::array<double, contact::mechanism_count> sum{};
  for (std::size_t m = 0; m < lost.size(); ++m) sum[m] = lost[m].value();
  return sum;
}

Vec3d momentum(const World& world) {
  Vec3d sum{};
  for (const std::uint32_t i : order_by_id(world)) sum += world.particles.motion[i].velocity * world.particles.mass[i];
  return sum;
}

double contacts_per_particle(const World& world) {
  const Contacts& c = world.contacts;
  std::size_t n = 0;
  std::pair<std::uint64_t, std::uint64_t> last{wall_base, wall_base};  // parts of one pair follow one another
  for (std::size_t k = 0; k < c.count(); ++k) {
    const std::pair pair(c.key[k].a, c.key[k].b);
    if (c.touching[k] == 0 || pair.second >= wall_base || pair == last) continue;
    last = pair;
    ++n;
  }
  return world.particles.count() > 0 ? static_cast<double>(n) / static_cast<double>(world.particles.count()) : 0;
}

// FNV-1a over ids, positions, orientations, velocities, spins, accumulated rotations in id order, then over the history
// of touching contacts in key order; first the box and its stress where it deforms.
std::uint64_t state_hash(const World& world) {
  std::uint64_t hash = 0xcbf29ce484222325u;
  const auto add = [&hash](const auto& value) {
    unsigned char bytes[sizeof value];
    std::memcpy(bytes, &value, sizeof value);
    for (const unsigned char b : bytes) hash = (hash ^ b) * 0x100000001b3u;
  };
  const Particles& p = world.particles;
  if (world.cell.deforms) {
    add(world.cell.lattice);
    add(world.cell.virial);
    add(world.cell.work);
  }
  for (const std::uint32_t i : order_by_id(world)) {
    add(p.id[i]);
    add(p.motion[i].position);
    add(p.orientation[i]);
    add(p.motion[i].velocity);
    add(p.motion[i].spin);
    add(p.rotation[i]);
  }
  const Contacts& c = world.contacts;
  for (const std::uint32_t k : touching_by_key(c)) {
    add(c.key[k].a);
    add(c.key[k].b);
    add(c.key[k].part);
    if (c.key[k].part_a != 0) add(c.key[k].part_a);
    add(c.history_of(k));
    for (std::size_t j = 0; j < c.words; ++j) add(c.memory[k * c.words + j]);
  }
  return hash;
}

}  // namespace dem
