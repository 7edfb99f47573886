#include "libdem/broad_phase/part_candidates.h"

#include <algorithm>

#include "libdem/detection.h"
#include "libdem/parts.h"

namespace dem {

bool has_compounds(const World& world) {
  const auto& kind = world.particles.kind;
  return std::find(kind.begin(), kind.end(), shapes::Kind::compound) != kind.end();
}

void part_pairs(const World& world, std::uint32_t i, std::uint32_t j, std::vector<Candidate>& row) {
  const Particles& p = world.particles;
  const Vec3d d = world.cell.lattice.nearest(p.motion[j].position - p.motion[i].position);
  const Mat3d ri = shapes::rotation_matrix(p.orientation[i]), rj = shapes::rotation_matrix(p.orientation[j]);
  const std::uint32_t parts_i = part_count(world, i), parts_j = part_count(world, j);
  const double skin = world.contacts.allowance[i] + world.contacts.allowance[j];
  for (std::uint32_t b = 0; b < parts_j; ++b) {
    const PartBall ball = part_ball(world, j, b, rj);
    const Vec3d to = d + ball.centre;
    for (std::uint32_t a = 0; a < parts_i; ++a) {
      const PartBall own = part_ball(world, i, a, ri);
      const Vec3d offset = to - own.centre;
      const double reach = own.radius + ball.radius + skin;
      if (dot(offset, offset) < reach * reach) row.push_back({{p.id[i], p.id[j], b, a}, i, j});
    }
  }
}

void part_walls(const World& world, std::uint32_t i, std::uint32_t w, const Mat3d& frame,
                std::span<const std::uint32_t> facets, std::vector<Candidate>& row) {
  const Particles& p = world.particles;
  const Wall& wall = world.walls[w];
  const Vec3d d = p.motion[i].position - wall.position;
  const Mat3d rotation = shapes::rotation_matrix(p.orientation[i]);
  const std::uint32_t parts = part_count(world, i);
  const double skin = world.contacts.allowance[i] + wall.allowance;
  const auto add = [&](std::uint32_t facet, auto near) {
    for (std::uint32_t a = 0; a < parts; ++a) {
      const PartBall ball = part_ball(world, i, a, rotation);
      if (near(d + ball.centre, ball.radius + skin)) row.push_back({{p.id[i], wall_base + w, facet, a}, i, w});
    }
  };
  if (is_half_space(wall.kind)) {
    const Vec3d normal = frame.column(2);
    add(0, [&](const Vec3d& at, double reach) { return dot(normal, at) < reach; });
    return;
  }
  for (const std::uint32_t f : facets)
    add(f, [&](const Vec3d& at, double reach) {
      return near_facet(wall.mesh->facets[f], transposed_times(frame, at), reach);
    });
}

void fill_groups(World& world) {
  Contacts& c = world.contacts;
  const Particles& p = world.particles;
  c.groups.clear();
  c.part_queries.clear();
  c.part_query.assign(c.count(), 0);
  c.share.assign(c.count(), 1);
  for (std::uint32_t k = 0; k < c.count(); ++k) {
    const bool wall = c.key[k].b >= wall_base;
    const std::uint32_t a = c.index_a[k], b = c.index_b[k];
    if (p.kind[a] != shapes::Kind::compound && (wall || p.kind[b] != shapes::Kind::compound)) continue;
    const Key* last = c.groups.empty() ? nullptr : &c.key[c.groups.back().first];
    if (last == nullptr || last->a != c.key[k].a || last->b != c.key[k].b) c.groups.push_back({k, 0});
    ++c.groups.back().count;
    shapes::Kind ka = part_kind(world, a, c.key[k].part_a);
    shapes::Kind kb = wall ? world.walls[b].kind : part_kind(world, b, c.key[k].part);
    if (kb < ka) std::swap(ka, kb);
    auto q = std::find_if(c.part_queries.begin(), c.part_queries.end(),
                          [&](const PartQuery& x) { return x.a == ka && x.b == kb; });
    if (q == c.part_queries.end()) q = c.part_queries.insert(q, {ka, kb, detection::find(ka, kb, world.scene)});
    c.part_query[k] = static_cast<std::uint8_t>(q - c.part_queries.begin());
  }
}

// A place of a body has left the way of its centre by the chord of the body's turn. In a cell that deforms (see
// moved_in_cell) centres follow the stretch F, arms do not: |1 − F| times the radius is lost besides.
bool parts_moved(const World& world) {
  const Particles& p = world.particles;
  const Contacts& c = world.contacts;
  const Cell& cell = world.cell;
  double least = 1, lost = 0;  // of the allowance, and of the radius besides
  if (cell.deforms) {
    least = std::min({1.0, cell.stretch.x, cell.stretch.y, cell.stretch.z});
    lost = 1 - least + shapes::max_abs(cell.stretch - Vec3d{1, 1, 1});
  }
  for (std::size_t i = 0; i < p.count(); ++i) {
    if (p.kind[i] != shapes::Kind::compound) continue;
    const Quatd turn = p.orientation[i] * shapes::conjugate(c.reference_orientation[i]);
    const double chord = 2 * norm(Vec3d{turn.x, turn.y, turn.z}) * p.motion[i].bounding_radius;  // 2 sin(angle / 2)
    const Vec3d followed =
        cell.deforms ? cell.centre + scaled(c.reference[i] - cell.centre, cell.stretch) : c.reference[i];
    const double left = least * c.allowance[i] - lost * p.motion[i].bounding_radius;
    if (!(norm(cell.lattice.nearest(p.motion[i].position - followed)) + chord < left)) return true;
  }
  return false;
}

}  // namespace dem
