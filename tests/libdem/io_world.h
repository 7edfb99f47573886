// A world filled by hand: two spheres, two ellipsoids, a box and a prism above a plane, beside a mesh wall; the two
// spheres touch each other and one of them the plane.
#pragma once

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <string>

#include "libdem/world.h"
#include "shapes/mesh_build.h"
#include "shapes/polyhedron_build.h"

namespace dem::io_test {

inline ShapeEntry round_entry(const std::string& name, const Vec3d& axes) {
  const double v = 4.0 / 3.0 * std::numbers::pi * axes.x * axes.y * axes.z;
  const Vec3d s = scaled(axes, axes);
  const bool sphere = axes.x == axes.y && axes.y == axes.z;
  ShapeEntry e;
  e.name = name;
  e.kind = sphere ? shapes::Kind::sphere : shapes::Kind::ellipsoid;
  e.size = axes;
  e.volume = v;
  e.equivalent_radius = std::cbrt(v * 0.75 / std::numbers::pi);
  e.inertia = Vec3d{s.y + s.z, s.x + s.z, s.x + s.y} * (v / 5);
  e.circumradius = max_abs(axes);
  e.inscribed_radius = std::min({axes.x, axes.y, axes.z});
  return e;
}

inline ShapeEntry polyhedron_entry(const std::string& name, shapes::Polyhedron p) {
  ShapeEntry e;
  e.name = name;
  e.kind = shapes::Kind::polyhedron;
  e.size = {1, 1, 1};
  e.volume = p.mass.volume;
  e.equivalent_radius = std::cbrt(e.volume * 0.75 / std::numbers::pi);
  e.inertia = {p.mass.inertia.row[0].x, p.mass.inertia.row[1].y, p.mass.inertia.row[2].z};
  e.circumradius = p.circumradius;
  e.inscribed_radius = p.inscribed_radius;
  e.polyhedron = std::make_shared<const shapes::Polyhedron>(std::move(p));
  return e;
}

inline void add_body(World& world, std::uint32_t shape, std::uint32_t material, double scale, const Vec3d& position,
                     const Quatd& orientation = {}, const Vec3d& velocity = {}, const Vec3d& spin = {}) {
  Particles& p = world.particles;
  const ShapeEntry& e = world.shapes[shape];
  const double s3 = scale * scale * scale, density = world.materials[material].density;
  p.id.push_back(world.next_id++);
  p.shape.push_back(shape);
  p.material.push_back(material);
  p.species.push_back(0);
  p.size.push_back(e.size * scale);
  p.mass.push_back(density * e.volume * s3);
  p.inertia.push_back(e.inertia * (density * s3 * scale * scale));
  p.motion.push_back(
      {position, scale * e.circumradius, velocity, 1 / p.mass.back(), spin, scale * e.equivalent_radius});
  p.orientation.push_back(normalized(orientation));
  p.rotation.push_back(spin * 0.5);
  p.angular_momentum.push_back({});
  p.force.push_back({});
  p.torque.push_back({});
}

inline void add_contact(World& world, std::uint32_t a, std::uint64_t b, const Vec3d& force, const Vec3d& normal,
                        double overlap) {
  Contacts& c = world.contacts;
  const bool wall = b >= wall_base;
  c.list({world.particles.id[a], b, 0}, a, static_cast<std::uint32_t>(wall ? b - wall_base : b),
         {force * 0.1, overlap, normal, 0}, force);
  c.centre.push_back(normal * world.particles.motion[a].bounding_radius);
  c.cache.push_back({});
}

inline World small_world() {
  World world;
  Scene& scene = world.scene;
  scene.title = "a world for tests";
  scene.gravity = {0, 0, -9.81};
  for (const char* name : {"glass", "steel"}) {
    MaterialSpec m;
    m.name = name;
    m.young = 1e7;
    m.density = name[0] == 'g' ? 2500 : 7800;
    scene.materials.push_back(m);
    contact::Material c;
    c.young = m.young;
    c.density = m.density;
    world.materials.push_back(c);
  }
  world.pairs.resize(4);
  world.shapes = {round_entry("ball", {0.5, 0.5, 0.5}), round_entry("pebble", {0.6, 0.4, 0.3}),
                  polyhedron_entry("brick", shapes::make_box({1, 0.8, 0.6})),
                  polyhedron_entry("hexagon", shapes::make_prism(6, 0.5, 0.7))};
  add_body(world, 0, 0, 1.0, {0.1, 0, 0.499}, {}, {0.1, 0.2, 1.0 / 3.0}, {1, 2, 3});
  add_body(world, 0, 1, 1.0, {1.099, 0, 0.5});
  add_body(world, 1, 0, 1.0, {0, 1.5, 1}, {0.9, 0.1, 0.2, 0.3}, {0, 0, -1});
  add_body(world, 1, 0, 0.5, {1.5, 1.5, 1}, {0.5, 0.5, -0.5, 0.5});
  add_body(world, 2, 1, 1.0, {0, -1.5, 1}, {0.8, 0.2, 0.1, 0.1}, {0, 3, 4});
  add_body(world, 3, 0, 1.2, {1.5, -1.5, 1}, {0.3, 0.2, 0.7, 0.1});

  Wall floor;
  floor.name = "floor";
  world.walls.push_back(floor);
  const Vec3d corner[] = {{-2, -3, 0}, {-2, 3, 0}, {-2, 3, 3}, {-2, -3, 3}};
  const std::uint32_t triangles[] = {0, 1, 2, 0, 2, 3};
  Wall side;
  side.name = "side";
  side.kind = shapes::Kind::mesh;
  side.mesh = std::make_shared<const shapes::Mesh>(shapes::mesh_from_triangles(corner, triangles));
  world.walls.push_back(side);

  add_contact(world, 0, 1, {-12, 0.5, 0}, {1, 0, 0}, 0.001);
  add_contact(world, 0, wall_base, {0, 0, 30}, {0, 0, -1}, 0.001);
  world.time_step = {1e-4, 1e-3, "ball on ball"};
  world.step = 120;
  return world;
}

// An empty folder that goes with the test.
class Folder {
 public:
  explicit Folder(const std::string& name) : path_(std::filesystem::temp_directory_path() / ("dem_" + name)) {
    path_ += std::to_string(::getpid());
    std::filesystem::remove_all(path_);
    std::filesystem::create_directories(path_);
  }
  ~Folder() { std::filesystem::remove_all(path_); }
  std::string operator/(const std::string& name) const { return (path_ / name).string(); }
  std::string path() const { return path_.string(); }

 private:
  std::filesystem::path path_;
};

}  // namespace dem::io_test
