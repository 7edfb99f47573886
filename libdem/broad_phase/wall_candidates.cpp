#include "libdem/broad_phase/wall_candidates.h"

#include "libdem/broad_phase/part_candidates.h"

namespace dem {

NearWalls::NearWalls(const World& world) : world_(world), facets_(world.walls.size()) {
  for (const Wall& w : world.walls) frames_.push_back(shapes::rotation_matrix(w.orientation));
}

void NearWalls::look(std::size_t first, std::size_t last) {
  const std::vector<Motion>& bodies = world_.particles.motion;
  for (std::size_t w = 0; w < world_.walls.size(); ++w) {
    const Wall& wall = world_.walls[w];
    facets_[w].clear();
    if (!wall.present || wall.kind != shapes::Kind::mesh) continue;
    Vec3d low{}, high{};
    for (std::size_t i = first; i < last; ++i) {
      const double reach = bodies[i].bounding_radius + world_.contacts.allowance[i] + wall.allowance;
      const Vec3d x = transposed_times(frames_[w], bodies[i].position - wall.position);
      for (int k = 0; k < 3; ++k) {
        low[k] = i == first ? x[k] - reach : std::min(low[k], x[k] - reach);
        high[k] = i == first ? x[k] + reach : std::max(high[k], x[k] + reach);
      }
    }
    for (std::size_t f = 0; f < wall.mesh->facets.size(); ++f) {
      const shapes::Mesh::Facet& facet = wall.mesh->facets[f];
      bool apart = false;
      for (int k = 0; k < 3; ++k) apart = apart || facet.lower[k] > high[k] || facet.upper[k] < low[k];
      if (!apart) facets_[w].push_back(static_cast<std::uint32_t>(f));
    }
  }
}

void NearWalls::add(std::size_t i, bool regions, std::vector<Candidate>& row) const {
  const Particles& p = world_.particles;
  const Motion& m = p.motion[i];
  for (std::size_t w = 0; w < world_.walls.size(); ++w) {
    const Wall& wall = world_.walls[w];
    if (!wall.present) continue;
    const double reach = m.bounding_radius + world_.contacts.allowance[i] + wall.allowance;
    const Vec3d d = m.position - wall.position;
    if (p.kind[i] == shapes::Kind::compound) {
      part_walls(world_, static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(w), frames_[w], facets_[w], row);
      continue;
    }
    Candidate record{{p.id[i], wall_base + w}, static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(w)};
    if (is_half_space(wall.kind)) {
      const Vec3d normal = frames_[w].column(wall.kind == shapes::Kind::plane ? 2 : 1);
      if (dot(normal, d) < reach) add_records(record, regions, row);
      continue;
    }
    const Vec3d x = transposed_times(frames_[w], d);
    if (wall.polygon) {
      if (near_polygon(*wall.polygon, x, reach)) add_records(record, regions || wall.meets_in_regions(), row);
      continue;
    }
    for (const std::uint32_t f : facets_[w]) {
      if (!near_facet(wall.mesh->facets[f], x, reach)) continue;
      record.key.part = f;
      row.push_back(record);
    }
  }
}

}  // namespace dem
