#include "libdem/report/view_shapes.h"

#include "libdem/report/base64.h"

namespace dem::report {

namespace {

Json mesh_json(const std::vector<Vec3d>& vertices, const std::vector<std::uint32_t>& triangles) {
  std::vector<float> points;
  for (const Vec3d& v : vertices)
    for (int k = 0; k < 3; ++k) points.push_back(static_cast<float>(v[k]));
  return {{"points", base64_of(points)}, {"triangles", base64_of(triangles)}};
}

// A fan for each convex polygon; `ends` of the loops in `corners`.
void add_fan(const std::uint32_t* loop, std::size_t count, std::vector<std::uint32_t>& triangles) {
  for (std::size_t i = 2; i < count; ++i) triangles.insert(triangles.end(), {loop[0], loop[i - 1], loop[i]});
}

std::size_t add_mesh(const shapes::Polyhedron& solid, Json& meshes) {
  std::vector<std::uint32_t> triangles;
  for (const auto& face : solid.faces) add_fan(&solid.face_vertices[face.first], face.count, triangles);
  meshes.push_back(mesh_json(solid.vertices, triangles));
  return meshes.size() - 1;
}

}  // namespace

Json list_of(const Vec3d& v) { return {v.x, v.y, v.z}; }
Json list_of(const Quatd& q) { return {q.w, q.x, q.y, q.z}; }

Json shape_json(const ShapeEntry& shape, Json& meshes) {
  Json parts = Json::array();
  const auto add = [&](const shapes::Polyhedron* solid, const Vec3d& centre, const Quatd& turn, const Vec3d& size,
                       bool own) {
    parts.push_back({{"mesh", solid == nullptr ? Json(-1) : Json(add_mesh(*solid, meshes))},
                     {"centre", list_of(centre)},
                     {"turn", list_of(turn)},
                     {"size", list_of(size)},
                     {"own", own}});
  };
  if (shape.compound == nullptr)
    add(shape.drawn(), {}, Quatd{}, {1, 1, 1}, shape.drawn() == nullptr);
  else
    for (const auto& part : shape.compound->parts)
      add(part.solid.get(), part.centre, part.orientation, part.size, false);
  return {{"family", shape.family.empty() ? shape.name : shape.family}, {"parts", parts}};
}

void add_to_box(const analysis::Snapshot& s, io::Box& box) {
  io::Box bodies, all;
  for (std::size_t i = 0; i < s.count(); ++i) bodies.add(s.position[i], s.bounding_radius[i]);
  all = bodies;
  for (const analysis::SnapshotWall& w : s.walls)
    if (w.present && w.mesh)
      for (const Vec3d& v : w.mesh->vertices) all.add(w.position + rotate(w.orientation, v));
  for (int corner = 0; corner < 2; ++corner)
    for (int k = 0; k < 3; ++k)
      if (s.periodic[static_cast<std::size_t>(k)] && !all.empty) {
        Vec3d x = all.centre();
        x[k] = s.lower[k] + corner * s.length[k];
        all.add(x);
      }
  const io::Box& chosen = bodies.empty || all.radius() <= 4 * bodies.radius() ? all : bodies;
  if (chosen.empty) return;
  box.add(chosen.lower);
  box.add(chosen.upper);
}

void ViewWalls::add(const analysis::Snapshot& s) {
  World world;
  bool fresh = false;
  while (walls_.size() < s.walls.size()) walls_.push_back(nullptr);
  for (std::size_t i = 0; i < s.walls.size(); ++i) {
    const analysis::SnapshotWall& w = s.walls[i];
    Wall wall;
    wall.name = w.name;
    wall.kind = w.kind;
    wall.mesh = w.mesh;
    wall.polygon = w.polygon;
    wall.position = w.position;
    wall.orientation = w.orientation;
    wall.present = w.present;
    world.walls.push_back(std::move(wall));
    fresh = fresh || (w.present && walls_[i].is_null());
  }
  if (!fresh) return;
  for (const io::WallSurface& surface : io::wall_surfaces(world, box_)) {
    if (!walls_[surface.wall].is_null()) continue;
    const Wall& wall = world.walls[surface.wall];
    const Quatd back = conjugate(wall.orientation);
    std::vector<Vec3d> points;
    for (const Vec3d& v : surface.vertices) points.push_back(rotate(back, v - wall.position));
    std::vector<std::uint32_t> triangles;
    std::uint32_t begin = 0;
    for (const std::uint32_t end : surface.ends) {
      add_fan(&surface.corners[begin], end - begin, triangles);
      begin = end;
    }
    walls_[surface.wall] = mesh_json(points, triangles);
    walls_[surface.wall]["name"] = wall.name;
  }
}

Json ViewWalls::poses(const analysis::Snapshot& s) {
  Json poses = Json::array();
  for (const analysis::SnapshotWall& w : s.walls)
    poses.push_back(w.present ? Json{w.position.x, w.position.y, w.position.z, w.orientation.w, w.orientation.x,
                                     w.orientation.y, w.orientation.z}
                              : Json(nullptr));
  return poses;
}

}  // namespace dem::report
