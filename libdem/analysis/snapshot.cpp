#include "libdem/analysis/snapshot.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

#include "libdem/build.h"

namespace dem::analysis {
namespace {

void add_bodies(const World& world, const std::vector<std::uint32_t>& order, Snapshot& s) {
  const Particles& p = world.particles;
  for (const std::uint32_t i : order) {
    const ShapeEntry& shape = world.shapes[p.shape[i]];
    const Motion& m = p.motion[i];
    s.id.push_back(p.id[i]);
    s.shape.push_back(p.shape[i]);
    s.material.push_back(p.material[i]);
    s.species.push_back(p.species[i]);
    s.size.push_back(p.size[i]);
    s.position.push_back(m.position);
    s.velocity.push_back(m.velocity);
    s.spin.push_back(m.spin);
    s.rotation.push_back(p.rotation[i]);
    s.has_rotation = s.has_rotation && (world.scene.run.turn_spheres || !is_round(p.kind[i]));
    s.orientation.push_back(p.orientation[i]);
    s.mass.push_back(p.mass[i]);
    s.radius.push_back(m.equivalent_radius);
    s.bounding_radius.push_back(m.bounding_radius);
    const double scale = m.equivalent_radius / shape.equivalent_radius;
    if (s.dimension == 3)
      s.volume.push_back(shape.volume * (scale * scale * scale));
    else if (shape.mass_power == 2)
      s.volume.push_back(shape.volume * (scale * scale));
    else
      s.volume.push_back(std::numbers::pi * m.equivalent_radius * m.equivalent_radius * s.thickness);
  }
}

void add_contacts(const World& world, const std::vector<std::uint32_t>& order, Snapshot& s) {
  const Contacts& c = world.contacts;
  std::vector<std::uint32_t> place(order.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) place[order[i]] = i;
  struct Sorted {
    SnapshotContact contact;
    std::uint32_t part_a;
  };
  std::vector<Sorted> list;
  for (std::size_t k = 0; k < c.count(); ++k) {
    if (c.touching[k] == 0) continue;
    SnapshotContact r;
    r.wall = c.key[k].b >= wall_base;
    r.a = place[c.index_a[k]];
    r.b = r.wall ? c.index_b[k] : place[c.index_b[k]];
    r.part = c.key[k].part;
    r.normal = c.history_of(k).normal;
    r.point = contact_point(world, k);
    r.force = c.slot[c.slot_of(k)].force;
    r.overlap = c.history_of(k).overlap;
    const Vec3d& x = s.position[r.a];
    if (r.wall)
      r.branch = r.point - x;
    else
      r.branch = s.between(x, s.position[r.b]);
    if (!r.wall && r.a > r.b) {
      std::swap(r.a, r.b);
      r.point = r.point - (x + r.branch) + s.position[r.a];
      r.normal = -r.normal;
      r.force = -r.force;
      r.branch = -r.branch;
    }
    list.push_back({r, c.key[k].part_a});
  }
  std::sort(list.begin(), list.end(), [](const Sorted& x, const Sorted& y) {
    return std::tuple(x.contact.a, x.contact.wall, x.contact.b, x.contact.part, x.part_a) <
           std::tuple(y.contact.a, y.contact.wall, y.contact.b, y.contact.part, y.part_a);
  });
  for (const Sorted& r : list) s.contacts.push_back(r.contact);
}

// The box around a wall's mesh, world axes.
Domain box_of(const SnapshotWall& wall) {
  Domain box;
  bool first = true;
  for (const Vec3d& corner : wall.mesh->vertices) {
    const Vec3d x = wall.position + rotate(wall.orientation, corner);
    if (first) box.lower = box.upper = x;
    first = false;
    for (int k = 0; k < 3; ++k) {
      box.lower[k] = std::min(box.lower[k], x[k]);
      box.upper[k] = std::max(box.upper[k], x[k]);
    }
  }
  return box;
}

void cut_by_half_space(const SnapshotWall& wall, Domain& domain) {
  constexpr double along = 1 - 1e-12;  // cosine
  const Vec3d n = wall.normal();
  for (int k = 0; k < 3; ++k) {
    if (n[k] > along) domain.lower[k] = std::max(domain.lower[k], wall.position[k]);
    if (n[k] < -along) domain.upper[k] = std::min(domain.upper[k], wall.position[k]);
  }
}

// `centres`: the box of the centres of the bodies.
void cut_by_box(const Domain& wall, const Domain& centres, Domain& domain) {
  for (int k = 0; k < 3; ++k) {
    for (const double side : {wall.lower[k], wall.upper[k]}) {
      if (centres.lower[k] >= side) domain.lower[k] = std::max(domain.lower[k], side);
      if (centres.upper[k] <= side) domain.upper[k] = std::min(domain.upper[k], side);
    }
  }
}

}  // namespace

Vec3d SnapshotWall::normal() const {
  const shapes::Mat3d frame = shapes::rotation_matrix(orientation);
  return frame.column(kind == shapes::Kind::line ? 1 : 2);
}

Vec3d Snapshot::between(const Vec3d& x, const Vec3d& y) const {
  Vec3d d = y - x;
  for (int k = 0; k < 3; ++k)
    if (periodic[static_cast<std::size_t>(k)]) d[k] -= length[k] * std::nearbyint(d[k] / length[k]);
  return d;
}

Snapshot snapshot_of(const World& world) {
  Snapshot s;
  s.step = world.step;
  s.time = world.time();
  s.dimension = world.scene.dimension;
  s.thickness = world.scene.thickness;
  s.gravity = world.scene.gravity;
  s.shapes = world.shapes;
  for (const MaterialSpec& m : world.scene.materials) s.materials.push_back(m.name);
  for (const SpeciesSpec& x : world.scene.species) s.species_names.push_back(x.name);
  if (world.cell.periodic)
    for (int k = 0; k < 3; ++k) {
      s.periodic[static_cast<std::size_t>(k)] = world.cell.lattice.length[k] > 0;
      s.lower[k] = world.cell.lower[k];
      s.length[k] = world.cell.lattice.length[k];
    }
  for (const Wall& w : world.walls)
    s.walls.push_back({w.name, w.kind, w.mesh, w.polygon, w.position, w.velocity, w.spin, w.orientation, w.present});
  const std::vector<std::uint32_t> order = order_by_id(world);
  add_bodies(world, order, s);
  add_contacts(world, order, s);
  if (world.contacts.incidence_start.size() == world.particles.count() + 1) {  // it has the list of a running world
    s.elastic = energies(world).elastic;
    const auto lost = dissipated(world);
    if (world.scene.law.ledger) s.dissipated.assign(lost.begin(), lost.end());
  }
  return s;
}

double Domain::volume(const Snapshot& s) const {
  const Vec3d d = upper - lower;
  return d.x * d.y * (s.dimension == 2 ? s.thickness : d.z);
}

bool Domain::holds(const Vec3d& x) const {
  for (int k = 0; k < 3; ++k) {
    if (k == 2 && lower.z == upper.z && x.z == lower.z) return true;
    if (!(x[k] >= lower[k] && x[k] < upper[k])) return false;
  }
  return true;
}

Domain domain_of(const Snapshot& s) {
  Domain domain, centres;
  for (std::size_t i = 0; i < s.count(); ++i) {
    const Vec3d& x = s.position[i];
    const double r = s.bounding_radius[i];
    if (i == 0) domain = centres = {x, x};
    for (int k = 0; k < 3; ++k) {
      centres.lower[k] = std::min(centres.lower[k], x[k]);
      centres.upper[k] = std::max(centres.upper[k], x[k]);
      domain.lower[k] = std::min(domain.lower[k], x[k] - r);
      domain.upper[k] = std::max(domain.upper[k], x[k] + r);
    }
  }
  if (s.count() > 0)
    for (const SnapshotWall& w : s.walls) {
      if (!w.present) continue;
      if (is_half_space(w.kind))
        cut_by_half_space(w, domain);
      else if (w.mesh && !w.mesh->vertices.empty())
        cut_by_box(box_of(w), centres, domain);
    }
  for (int k = 0; k < 3; ++k)
    if (s.periodic[static_cast<std::size_t>(k)]) {
      domain.lower[k] = s.lower[k];
      domain.upper[k] = s.lower[k] + s.length[k];
    }
  if (s.dimension == 2) domain.lower.z = domain.upper.z = 0;
  return domain;
}

}  // namespace dem::analysis
