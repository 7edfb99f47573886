#include "libdem/io/vtk_pieces.h"

#include <algorithm>

#include "libdem/io/surfaces.h"
#include "libdem/io/vtp.h"
#include "libdem/parts.h"

namespace dem::io {

namespace {

template <class T, std::size_t N>
void append(std::vector<T>& values, const std::array<double, N>& more) {
  for (const double v : more) values.push_back(static_cast<T>(v));
}
std::array<double, 3> list(const Vec3d& v) { return {v.x, v.y, v.z}; }

std::int32_t index32(std::size_t i) { return static_cast<std::int32_t>(i); }

// Drawn by its faces: a polyhedron, or a polygon as one cell.
bool is_faceted(const PartBody& part) { return part.body.geometry != nullptr; }

// visit(i, part, its place) for every part of every body, in order of id.
template <class Visit>
void for_each_part(const World& world, Visit&& visit) {
  for (const std::uint32_t i : order_by_id(world)) {
    const Mat3d rotation = rotation_matrix(world.particles.orientation[i]);
    for (std::uint32_t part = 0; part < part_count(world, i); ++part)
      visit(i, part, part_body(world, i, part, rotation));
  }
}

}  // namespace

bool write_rounds(const std::string& path, const World& world) {
  const Particles& p = world.particles;
  std::vector<Vec3d> points;
  std::vector<std::int64_t> id;
  std::vector<std::int32_t> shape, material, species, connectivity, ends;
  std::vector<float> radius, velocity, spin, quaternion;
  std::vector<double> tensor;
  for_each_part(world, [&](std::uint32_t i, std::uint32_t part, const PartBody& b) {
    if (is_faceted(b)) return;
    const Motion& m = p.motion[i];
    const shapes::Compound* compound = compound_of(world, i);
    const Quatd q = compound ? p.orientation[i] * compound->parts[part].orientation : p.orientation[i];
    connectivity.push_back(index32(points.size()));
    points.push_back(m.position + b.centre);
    ends.push_back(index32(points.size()));
    id.push_back(static_cast<std::int64_t>(p.id[i]));
    shape.push_back(index32(p.shape[i]));
    material.push_back(index32(p.material[i]));
    species.push_back(index32(p.species[i]));
    radius.push_back(static_cast<float>(compound ? b.radius : m.equivalent_radius));
    append(velocity, list(m.velocity + cross(m.spin, b.centre)));
    append(spin, list(m.spin));
    append(quaternion, std::array<double, 4>{q.w, q.x, q.y, q.z});
    const Mat3d& r = b.body.rotation;
    const Mat3d t = r * Mat3d::diagonal(b.body.size) * transposed(r);
    for (const Vec3d& row : t.row) append(tensor, list(row));
  });
  if (points.empty()) return false;
  Vtp file;
  file.set_points(points, true);
  file.set_cells(Vtp::Cells::vertices, connectivity, ends);
  file.add_point_array("id", 1, id);
  file.add_point_array("shape", 1, shape);
  file.add_point_array("material", 1, material);
  if (!world.scene.species.empty()) file.add_point_array("species", 1, species);
  file.add_point_array("radius", 1, radius);
  file.add_point_array("velocity", 3, velocity);
  file.add_point_array("spin", 3, spin);
  file.add_point_array("quaternion", 4, quaternion);
  file.add_point_array("tensor", 9, tensor);
  file.write(path);
  return true;
}

bool write_polyhedra(const std::string& path, const World& world) {
  const Particles& p = world.particles;
  std::vector<Vec3d> points;
  std::vector<std::int64_t> particle;
  std::vector<std::int32_t> shape, material, species, connectivity, ends;
  std::vector<float> speed;
  for_each_part(world, [&](std::uint32_t i, std::uint32_t, const PartBody& b) {
    if (!is_faceted(b)) return;
    const ShapeEntry& entry = world.shapes[p.shape[i]];
    const auto* solid = entry.polygon    ? nullptr
                        : entry.compound ? static_cast<const shapes::Polyhedron*>(b.body.geometry)
                                         : entry.drawn();
    const std::size_t base = points.size();
    for (const Vec3d& v : entry.polygon ? entry.polygon->vertices : solid->vertices)
      points.push_back(p.motion[i].position + b.centre + b.body.rotation * (b.body.size.x * v));
    const auto end_cell = [&] {
      ends.push_back(index32(connectivity.size()));
      particle.push_back(static_cast<std::int64_t>(p.id[i]));
      shape.push_back(index32(p.shape[i]));
      material.push_back(index32(p.material[i]));
      species.push_back(index32(p.species[i]));
      speed.push_back(static_cast<float>(norm(p.motion[i].velocity)));
    };
    if (solid == nullptr) {
      for (std::size_t k = base; k < points.size(); ++k) connectivity.push_back(index32(k));
      return end_cell();
    }
    for (const auto& face : solid->faces) {
      for (std::uint32_t k = 0; k < face.count; ++k)
        connectivity.push_back(index32(base + solid->face_vertices[face.first + k]));
      end_cell();
    }
  });
  if (points.empty()) return false;
  Vtp file;
  file.set_points(points, false);
  file.set_cells(Vtp::Cells::polygons, connectivity, ends);
  file.add_cell_array("particle", 1, particle);
  file.add_cell_array("shape", 1, shape);
  file.add_cell_array("material", 1, material);
  if (!world.scene.species.empty()) file.add_cell_array("species", 1, species);
  file.add_cell_array("speed", 1, speed);
  file.write(path);
  return true;
}

bool write_contacts(const std::string& path, const World& world) {
  const Particles& p = world.particles;
  const std::vector<std::uint32_t> order = order_by_id(world);
  const auto position = [&](std::uint64_t id) {
    const auto before = [&](std::uint32_t i, std::uint64_t wanted) { return p.id[i] < wanted; };
    return p.motion[*std::lower_bound(order.begin(), order.end(), id, before)].position;
  };
  std::vector<Vec3d> points;
  std::vector<std::int64_t> a, b;
  std::vector<std::int32_t> connectivity, ends;
  std::vector<float> force, magnitude, tangential, normal, overlap, at;
  for (const ContactReport& c : touching_contacts(world)) {
    const Vec3d from = position(c.a);
    points.push_back(from);
    points.push_back(c.wall ? c.point : from + world.cell.lattice.nearest(position(c.b) - from));
    connectivity.push_back(index32(points.size() - 2));
    connectivity.push_back(index32(points.size() - 1));
    ends.push_back(index32(points.size()));
    a.push_back(static_cast<std::int64_t>(c.a));
    b.push_back(c.wall ? -1 - static_cast<std::int64_t>(c.b) : static_cast<std::int64_t>(c.b));
    append(force, list(c.force));
    magnitude.push_back(static_cast<float>(norm(c.force)));
    append(tangential, list(c.tangential));
    append(normal, list(c.normal));
    overlap.push_back(static_cast<float>(c.overlap));
    append(at, list(c.point));
  }
  if (points.empty()) return false;
  Vtp file;
  file.set_points(points, false);
  file.set_cells(Vtp::Cells::lines, connectivity, ends);
  file.add_cell_array("a", 1, a);
  file.add_cell_array("b", 1, b);
  file.add_cell_array("force", 3, force);
  file.add_cell_array("force_magnitude", 1, magnitude);
  file.add_cell_array("tangential", 3, tangential);
  file.add_cell_array("normal", 3, normal);
  file.add_cell_array("overlap", 1, overlap);
  file.add_cell_array("point", 3, at);
  file.write(path);
  return true;
}

bool write_walls(const std::string& path, const World& world) {
  std::vector<Vec3d> points;
  std::vector<std::int32_t> connectivity, ends, wall, material;
  std::vector<double> pressure, traction, shear;
  bool maps = false;
  for (const Wall& w : world.walls) maps = maps || w.motion.pressure_map;
  for (WallSurface& s : wall_surfaces(world, scene_box(world))) {
    if (!world.walls[s.wall].load.squares.empty()) s = map_squares(world, s.wall);
    const std::size_t base = points.size(), first = connectivity.size();
    points.insert(points.end(), s.vertices.begin(), s.vertices.end());
    for (const std::uint32_t c : s.corners) connectivity.push_back(index32(base + c));
    for (const std::uint32_t e : s.ends) {
      ends.push_back(index32(first + e));
      wall.push_back(index32(s.wall));
      material.push_back(index32(world.walls[s.wall].material));
    }
    if (!maps) continue;
    std::vector<MapTraction> map = tractions(world, world.walls[s.wall]);
    map.resize(s.ends.size());
    for (const MapTraction& t : map) {
      pressure.push_back(t.pressure);
      append(traction, list(t.traction));
      append(shear, list(t.shear));
    }
  }
  if (points.empty()) return false;
  Vtp file;
  file.set_points(points, false);
  file.set_cells(Vtp::Cells::polygons, connectivity, ends);
  file.add_cell_array("wall", 1, wall);
  file.add_cell_array("material", 1, material);
  if (maps) {
    file.add_cell_array("pressure", 1, pressure);
    file.add_cell_array("traction", 3, traction);
    file.add_cell_array("shear", 3, shear);
  }
  file.write(path);
  return true;
}

bool write_cell(const std::string& path, const World& world) {
  if (!world.cell.periodic) return false;
  const Box box = cell_box(world);
  const bool planar = world.scene.dimension == 2;
  std::vector<Vec3d> points;
  std::vector<std::int32_t> connectivity, ends;
  for (int corner = 0; corner < (planar ? 4 : 8); ++corner) {
    points.push_back({(corner & 1 ? box.upper : box.lower).x, (corner & 2 ? box.upper : box.lower).y,
                      planar ? 0 : (corner & 4 ? box.upper : box.lower).z});
    for (const int bit : {1, 2, 4}) {
      if ((corner & bit) != 0 || (planar && bit == 4)) continue;
      connectivity.push_back(corner);
      connectivity.push_back(corner | bit);
      ends.push_back(index32(connectivity.size()));
    }
  }
  Vtp file;
  file.set_points(points, true);
  file.set_cells(Vtp::Cells::lines, connectivity, ends);
  file.write(path);
  return true;
}

}  // namespace dem::io
