#include "libdem/io/surfaces.h"

#include <algorithm>
#include <set>
#include <utility>

namespace dem::io {

namespace {

Vec3d plane_normal(const Wall& wall) {
  return rotate(wall.orientation, wall.kind == shapes::Kind::line ? Vec3d{0, 1, 0} : Vec3d{0, 0, 1});
}
Vec3d to_world(const Wall& wall, const Vec3d& x) { return rotate(wall.orientation, x) + wall.position; }

// Keeps the part of a convex polygon with n·(x − point) >= 0 (Sutherland and Hodgman's clipping).
std::vector<Vec3d> clip(const std::vector<Vec3d>& polygon, const Vec3d& n, const Vec3d& point) {
  std::vector<Vec3d> kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec3d &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const double ha = dot(n, a - point), hb = dot(n, b - point);
    if (ha >= 0) kept.push_back(a);
    if ((ha < 0) != (hb < 0)) kept.push_back(a + (b - a) * (ha / (ha - hb)));
  }
  return kept;
}

WallSurface plane_surface(const World& world, std::size_t index, const Box& box) {
  const Wall& wall = world.walls[index];
  const Vec3d n = plane_normal(wall);
  const Vec3d centre = box.centre() - n * dot(n, box.centre() - wall.position);
  const double half = 1.1 * box.radius();
  Vec3d t1, t2;
  tangent_frame(n, t1, t2);
  if (wall.kind == shapes::Kind::line) {  // a strip as deep as the bodies
    t1 = {n.y, -n.x, 0};
    t2 = {0, 0, half > 0 ? 0.5 * (box.upper.z - box.lower.z) / half : 0};
  }
  std::vector<Vec3d> polygon{centre - (t1 + t2) * half, centre + (t1 - t2) * half, centre + (t1 + t2) * half,
                             centre + (t2 - t1) * half};
  for (std::size_t other = 0; other < world.walls.size(); ++other) {
    const Wall& w = world.walls[other];
    if (other == index || !w.present || !is_half_space(w.kind)) continue;
    const Vec3d m = plane_normal(w);
    if (norm(cross(m, n)) > 1e-6) polygon = clip(polygon, m, w.position);
  }
  WallSurface surface{index, true, n, std::move(polygon), {}, {}, {}};
  for (std::uint32_t i = 0; i < surface.vertices.size(); ++i) surface.corners.push_back(i);
  if (!surface.corners.empty()) surface.ends.push_back(static_cast<std::uint32_t>(surface.corners.size()));
  surface.outline.assign(surface.corners.size(), 1);
  return surface;
}

WallSurface mesh_surface(const World& world, std::size_t index) {
  const Wall& wall = world.walls[index];
  const shapes::Mesh& mesh = *wall.mesh;
  WallSurface surface{index, false, {}, {}, mesh.triangles, {}, {}};
  for (const Vec3d& v : mesh.vertices) surface.vertices.push_back(to_world(wall, v));
  std::set<std::pair<std::uint32_t, std::uint32_t>> real;
  for (const auto& e : mesh.edges) real.insert(std::minmax(e.vertex[0], e.vertex[1]));
  for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
    const std::uint32_t next = i % 3 == 2 ? i - 2 : i + 1;
    const std::pair<std::uint32_t, std::uint32_t> edge = std::minmax(mesh.triangles[i], mesh.triangles[next]);
    surface.outline.push_back(real.count(edge) ? 1 : 0);
    if (i % 3 == 2) surface.ends.push_back(i + 1);
  }
  return surface;
}

}  // namespace

void Box::add(const Vec3d& point, double margin) {
  const Vec3d m{margin, margin, margin};
  if (empty) {
    lower = point - m;
    upper = point + m;
    empty = false;
    return;
  }
  for (int k = 0; k < 3; ++k) {
    lower[k] = std::min(lower[k], point[k] - margin);
    upper[k] = std::max(upper[k], point[k] + margin);
  }
}

Box particle_box(const World& world) {
  Box box;
  for (const Motion& m : world.particles.motion) box.add(m.position, m.bounding_radius);
  return box;
}

Box scene_box(const World& world) {
  Box box = particle_box(world);
  for (const Wall& wall : world.walls)
    if (wall.present && wall.mesh)
      for (const Vec3d& v : wall.mesh->vertices) box.add(to_world(wall, v));
  for (const FillSpec& fill : world.scene.fills) {
    box.add(fill.lower);
    box.add(fill.upper);
  }
  if (box.empty)
    for (const Wall& wall : world.walls) box.add(wall.position);
  return box;
}

std::vector<WallSurface> wall_surfaces(const World& world, const Box& box) {
  std::vector<WallSurface> surfaces;
  for (std::size_t i = 0; i < world.walls.size(); ++i) {
    const Wall& wall = world.walls[i];
    if (!wall.present) continue;
    WallSurface surface = wall.mesh ? mesh_surface(world, i) : plane_surface(world, i, box);
    if (!surface.ends.empty()) surfaces.push_back(std::move(surface));
  }
  return surfaces;
}

WallSurface map_squares(const World& world, std::size_t index) {
  const Wall& wall = world.walls[index];
  const double cell = wall.motion.map_cell;
  WallSurface surface{index, true, plane_normal(wall), {}, {}, {}, {}};
  for (const auto& square : wall.load.squares) {
    for (const auto& [i, j] : {std::array{0, 0}, {1, 0}, {1, 1}, {0, 1}}) {
      surface.corners.push_back(static_cast<std::uint32_t>(surface.vertices.size()));
      const double x = static_cast<double>(square[0]) + i, y = static_cast<double>(square[1]) + j;
      surface.vertices.push_back(to_world(wall, {cell * x, cell * y, 0}));
    }
    surface.ends.push_back(static_cast<std::uint32_t>(surface.corners.size()));
  }
  surface.outline.assign(surface.corners.size(), 1);
  return surface;
}

Box cell_box(const World& world) {
  Box box = particle_box(world);
  const Cell& cell = world.cell;
  for (int k = 0; k < 3; ++k) {
    if (cell.lattice.length[k] == 0) continue;
    box.lower[k] = cell.lower[k];
    box.upper[k] = cell.lower[k] + cell.lattice.length[k];
  }
  return box;
}

std::vector<WallSurface> cell_surfaces(const World& world) {
  if (!world.cell.periodic) return {};
  const Box box = cell_box(world);
  WallSurface surface{world.walls.size(), false, {}, {}, {}, {}, {}};
  for (int corner = 0; corner < 8; ++corner)
    surface.vertices.push_back({(corner & 1 ? box.upper : box.lower).x, (corner & 2 ? box.upper : box.lower).y,
                                (corner & 4 ? box.upper : box.lower).z});
  const auto face = [&surface](std::initializer_list<std::uint32_t> corners) {
    surface.corners.insert(surface.corners.end(), corners);
    surface.ends.push_back(static_cast<std::uint32_t>(surface.corners.size()));
  };
  face({4, 5, 7, 6});
  if (world.scene.dimension == 3) {
    face({0, 2, 3, 1});
    face({0, 1, 5, 4});
    face({2, 6, 7, 3});
    face({0, 4, 6, 2});
    face({1, 3, 7, 5});
  }
  surface.outline.assign(surface.corners.size(), 1);
  return {surface};
}

}  // namespace dem::io
