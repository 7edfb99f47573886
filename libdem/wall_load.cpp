#include "libdem/wall_load.h"

#include <algorithm>
#include <cmath>

#include "libdem/build.h"
#include "libdem/mesh_triangles.h"

namespace dem {

namespace {

// The square of a plane's map that holds a point of its frame; made when it is the first there.
std::size_t square_at(WallLoad& load, double cell, const Vec3d& x) {
  const double most = 0x1p62;
  const auto index = [cell, most](double v) {
    return static_cast<std::int64_t>(std::clamp(std::floor(v / cell), -most, most));
  };
  const std::array<std::int64_t, 2> square{index(x.x), index(x.y)};
  const auto at = std::lower_bound(load.squares.begin(), load.squares.end(), square);
  const auto k = at - load.squares.begin();
  if (at == load.squares.end() || *at != square) {
    load.squares.insert(at, square);
    load.map.insert(load.map.begin() + k, MapLoad{});
  }
  return static_cast<std::size_t>(k);
}

void begin_map(Wall& w) {
  if (w.mesh) return std::fill(w.load.map.begin(), w.load.map.end(), MapLoad{});
  w.load.map.clear();
  w.load.squares.clear();
}

// The step of the frame before this one: maps are sums over the steps after it.
std::uint64_t map_begin(const World& world) {
  const std::uint64_t every = steps_between(world.scene.output.interval, world.time_step.dt);
  return every > 0 && world.step > 0 ? (world.step - 1) / every * every : 0;
}

void book_maps(World& world, double dt) {
  if (world.step == map_begin(world) + 1)
    for (Wall& w : world.walls) begin_map(w);
  const Contacts& c = world.contacts;
  for (const std::uint32_t k : c.wall_records) {
    Wall& w = world.walls[c.index_b[k]];
    if (c.touching[k] == 0 || !w.motion.pressure_map) continue;
    const Vec3d force = -c.slot[c.slot_of(k)].force, normal = c.history_of(k).normal;  // on the wall, into it
    const double pressing = dot(force, normal);
    const Mat3d r = rotation_matrix(w.orientation);
    const Vec3d x = transposed_times(r, contact_point(world, k) - w.position);
    MapLoad& load =
        w.load.map[w.mesh ? triangle_at(*w.mesh, c.key[k].part, x) : square_at(w.load, w.motion.map_cell, x)];
    load.force += transposed_times(r, force) * dt;
    load.tangential += transposed_times(r, force - normal * pressing) * dt;
    load.pressing += pressing * dt;
  }
}

}  // namespace

double wall_power(const Wall& w) { return dot(w.force, w.velocity) + dot(w.torque, w.spin); }

void book_wall_loads(World& world, double dt) {
  bool maps = false;
  for (Wall& w : world.walls) {
    for (int k = 0; k < 3; ++k) w.load.impulse[static_cast<std::size_t>(k)].add(w.force[k] * dt);
    w.load.work.add(wall_power(w) * dt);
    maps = maps || w.motion.pressure_map;
  }
  if (maps) book_maps(world, dt);
}

double map_duration(const World& world) {
  return static_cast<double>(world.step - map_begin(world)) * world.time_step.dt;
}

std::vector<MapTraction> tractions(const World& world, const Wall& w) {
  std::vector<MapTraction> list(w.load.map.size());
  const double duration = map_duration(world);
  if (!(duration > 0)) return list;
  const Mat3d r = rotation_matrix(w.orientation);
  for (std::size_t t = 0; t < list.size(); ++t) {
    double area = w.motion.map_cell * w.motion.map_cell;
    if (w.mesh) area = area_of(corners_of(*w.mesh, t));
    const MapLoad& load = w.load.map[t];
    const double per = 1 / (area * duration);
    list[t] = {r * (load.force * per), r * (load.tangential * per), load.pressing * per};
  }
  return list;
}

}  // namespace dem
