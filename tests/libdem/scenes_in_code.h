// Scenes written in code: the shared pieces of the tests of the loop.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "libdem/random.h"
#include "libdem/world.h"

namespace dem::scenes {

inline double length(const Vec3d& v) { return std::sqrt(dot(v, v)); }

inline MaterialSpec material(const std::string& name, double young, double density, double restitution,
                             double friction) {
  MaterialSpec m;
  m.name = name;
  m.young = young;
  m.density = density;
  m.restitution = restitution;
  m.friction = friction;
  return m;
}

inline ShapeSpec sphere(const std::string& name, double radius) {
  ShapeSpec s;
  s.name = name;
  s.kind = "sphere";
  s.radius = radius;
  return s;
}
inline ShapeSpec ellipsoid(const std::string& name, const Vec3d& semi_axes) {
  ShapeSpec s;
  s.name = name;
  s.kind = "ellipsoid";
  s.semi_axes = semi_axes;
  return s;
}
inline ShapeSpec box(const std::string& name, const Vec3d& extents) {
  ShapeSpec s;
  s.name = name;
  s.kind = "box";
  s.extents = extents;
  return s;
}
inline ShapeSpec points(const std::string& name, const std::vector<Vec3d>& vertices) {
  ShapeSpec s;
  s.name = name;
  s.kind = "polyhedron";
  s.vertices = vertices;
  return s;
}

inline ShapeSpec clump(const std::string& name, const std::vector<std::array<double, 4>>& spheres) {
  ShapeSpec s;
  s.name = name;
  s.kind = "clump";
  s.spheres = spheres;
  return s;
}
inline ShapeSpec union_of(const std::string& name, const std::vector<PartSpec>& parts) {
  ShapeSpec s;
  s.name = name;
  s.kind = "union";
  s.parts = parts;
  return s;
}

inline ShapeSpec potential(const std::string& name, const std::vector<std::array<double, 4>>& planes, double k,
                           double r, double R) {
  ShapeSpec s;
  s.name = name;
  s.kind = "potential_particle";
  s.half_spaces = planes;
  s.k = k;
  s.r = r;
  s.R = R;
  return s;
}

inline WallSpec plane(const std::string& name, const std::string& material, const Vec3d& point, const Vec3d& normal) {
  WallSpec w;
  w.name = name;
  w.kind = "plane";
  w.material = material;
  w.point = point;
  w.normal = normal;
  return w;
}

inline BodySpec body(const std::string& shape, const std::string& material, const Vec3d& position,
                     const Vec3d& velocity = {}, const Vec3d& spin = {}, const Quatd& orientation = {}) {
  BodySpec b;
  b.shape = shape;
  b.material = material;
  b.position = position;
  b.velocity = velocity;
  b.spin = spin;
  b.orientation = orientation;
  return b;
}

// Turn by an angle (rad) about a unit axis.
inline Quatd turn(const Vec3d& axis, double angle) {
  const double s = std::sin(0.5 * angle);
  return {std::cos(0.5 * angle), axis.x * s, axis.y * s, axis.z * s};
}

// A flat square floor of side 2·half at height z: cells × cells squares with jittered inner vertices, each cut along a
// random diagonal, wound at random.
inline WallSpec random_floor(const std::string& name, const std::string& material, double half, int cells, double z,
                             std::uint64_t seed) {
  WallSpec w;
  w.name = name;
  w.kind = "mesh";
  w.material = material;
  const double pitch = 2 * half / cells;
  Random random(seed, 0, 0);
  const auto index = [cells](int i, int j) { return static_cast<std::uint32_t>(i * (cells + 1) + j); };
  for (int i = 0; i <= cells; ++i)
    for (int j = 0; j <= cells; ++j) {
      const bool inner = i > 0 && j > 0 && i < cells && j < cells;
      const double dx = inner ? random.uniform(-0.3, 0.3) : 0, dy = inner ? random.uniform(-0.3, 0.3) : 0;
      w.vertices.push_back({(i + dx) * pitch - half, (j + dy) * pitch - half, z});
    }
  const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    if (random.uniform() < 0.5) std::swap(b, c);
    w.triangles.push_back({a, b, c});
  };
  for (int i = 0; i < cells; ++i)
    for (int j = 0; j < cells; ++j) {
      const std::uint32_t a = index(i, j), b = index(i + 1, j), c = index(i + 1, j + 1), d = index(i, j + 1);
      if (random.uniform() < 0.5) {
        add(a, b, c);
        add(a, c, d);
      } else {
        add(a, b, d);
        add(b, c, d);
      }
    }
  return w;
}

inline World run(const Scene& scene, std::uint64_t steps, int threads = 1) {
  World world = build_world(scene);
  for (std::uint64_t i = 0; i < steps; ++i) advance(world, threads);
  return world;
}

// Storage place of a body by its id.
inline std::size_t place(const World& world, std::uint64_t id) { return order_by_id(world)[id]; }
inline const Motion& motion(const World& world, std::uint64_t id) { return world.particles.motion[place(world, id)]; }

// `count` bodies of every shape (sphere, ellipsoid, box, tetrahedron, a grain of fourteen corners) that fall and roll
// together in a tray: plane floor, two plane sides, a pitched mesh roof on end as the third and a wall that shakes as
// the fourth. Centimetres, E 5 MPa, twenty times gravity: within 600 steps every kind of contact is there.
inline Scene every_shape(std::uint64_t count) {
  Scene s;
  s.run.steps = 1000;
  s.run.dt_fraction = 0.3;
  s.gravity = {100, 5, -195};
  s.materials = {material("soft", 5e6, 2500, 0.5, 0.4), material("hard", 8e6, 1500, 0.8, 0.2)};
  s.materials[0].stiffness = 2e4;
  s.materials[1].stiffness = 3e4;
  s.shapes = {sphere("ball", 0.005), ellipsoid("egg", {0.004, 0.005, 0.0075}), box("brick", {0.008, 0.01, 0.012}),
              points("wedge", {{0, 0, 0}, {0.012, 0.001, 0}, {0.002, 0.013, 0.001}, {0.003, 0.004, 0.011}})};
  std::vector<Vec3d> grain;
  Random random(7, 0, 0);
  for (int i = 0; i < 14; ++i) {
    const Vec3d u = rotate(random.rotation(), Vec3d{0, 0, 1});
    grain.push_back({u.x * 0.005, u.y * 0.006, u.z * 0.007});
  }
  s.shapes.push_back(points("grain", grain));
  s.walls = {plane("floor", "soft", {0, 0, 0}, {0, 0, 1}), plane("west", "hard", {-0.05, 0, 0}, {1, 0, 0}),
             plane("south", "hard", {0, -0.05, 0}, {0, 1, 0}), plane("shaker", "soft", {0, 0.052, 0}, {0, -1, 0})};
  s.walls[3].motion = WallMotion::oscillation;
  s.walls[3].amplitude = {0, 0.001, 0};
  s.walls[3].frequency = 64;
  WallSpec ridge;
  ridge.name = "ridge";
  ridge.kind = "mesh";
  ridge.material = "hard";
  ridge.vertices = {{0.05, -0.06, -0.01}, {0.05, -0.06, 0.25}, {0.045, 0, -0.01},
                    {0.045, 0, 0.25},     {0.05, 0.06, -0.01}, {0.05, 0.06, 0.25}};
  ridge.triangles = {{0, 1, 2}, {1, 3, 2}, {2, 3, 4}, {3, 5, 4}};
  s.walls.push_back(ridge);
  FillSpec fill;
  fill.lower = {-0.05, -0.05, 0.0};
  fill.upper = {0.045, 0.05, 0.25};
  fill.count = count;
  fill.velocity = {2, 0, -3};
  fill.items = {{"ball", "soft", 1, 0.7, 1.0},
                {"egg", "hard", 1, 0.7, 1.0},
                {"brick", "soft", 1, 0.6, 0.8},
                {"wedge", "hard", 1, 0.7, 0.9},
                {"grain", "soft", 1, 0.8, 1.0}};
  s.fills = {fill};
  return s;
}

// The same tray with drivers: the shaker pushes with a kept force, the west side follows a table, back and forth.
inline Scene every_shape_driven(std::uint64_t count) {
  Scene s = every_shape(count);
  WallSpec& press = s.walls[3];
  press.motion = WallMotion::servo;
  press.axis = {0, -1, 0};
  press.target_force = 16;
  press.speed_limit = 0.5;
  WallSpec& west = s.walls[1];
  west.motion = WallMotion::table;
  west.displacements = {{0.001, 0, 0, 0}, {0.006, 0.002, 0, 0}, {0.0125, 0.001, 0.001, 0}, {0.03, 0.004, 0, 0}};
  return s;
}

// `count` bodies of every shape, two clouds that meet in a periodic box which deforms: first one way, then another,
// then by its stress along two axes.
inline Scene every_shape_in_a_cell(std::uint64_t count) {
  constexpr double edge = 0.1;
  Scene s = every_shape(count / 2);
  for (MaterialSpec& m : s.materials) m.stiffness /= 8;
  s.gravity = {};
  s.walls.clear();
  s.periodic.axes = "xyz";
  s.periodic.upper = {edge, edge, edge};
  s.fills[0].lower = {};
  s.fills[0].upper = {edge, edge, edge / 2};
  s.fills[0].velocity = {3, 2, 6};
  s.fills.push_back(s.fills[0]);
  s.fills[1].lower.z = edge / 2;
  s.fills[1].upper.z = edge;
  s.fills[1].velocity = {-2, -3, -8};
  DeformSpec first, second, third;
  first.strain_rates = {-16, -8, 4};
  second.start = 0.00390625;
  second.strain_rates = {4, -24, -12};
  third.start = 0.005859375;
  third.strain_rates = {0, 8, 0};
  third.stress_axes = "xz";
  third.target_stress = {8e4, 0, 6e4};
  third.rate_limit = 24;
  s.periodic.deform = {first, second, third};
  return s;
}

// The same tray with bodies of parts in it: a dumbbell, a clump of four unequal balls, an L and a plus of boxes, a
// mushroom of a half egg on a box; among balls and grains.
inline Scene bodies_of_parts(std::uint64_t count) {
  Scene s = every_shape(count);
  s.shapes.push_back(box("bar", {0.012, 0.004, 0.004}));
  s.shapes.push_back(box("stub", {0.004, 0.008, 0.004}));
  s.shapes.push_back(ellipsoid("cap", {0.006, 0.005, 0.003}));
  s.shapes.push_back(clump("dumbbell", {{-0.003, 0, 0, 0.003}, {0.003, 0, 0, 0.003}}));
  s.shapes.push_back(clump(
      "clump", {{0, 0, 0, 0.004}, {0.003, 0.002, 0, 0.003}, {-0.002, 0.003, 0.001, 0.003}, {0, 0, 0.004, 0.0025}}));
  s.shapes.push_back(union_of("ell", {{"bar", {0, 0, 0}, {}}, {"stub", {-0.004, 0.006, 0}, {}}}));
  s.shapes.push_back(
      union_of("plus", {{"bar", {0, 0, 0}, {}}, {"bar", {0, 0, 0}, turn({0, 0, 1}, 1.5707963267948966)}}));
  s.shapes.push_back(
      union_of("mushroom", {{"stub", {0, 0, 0}, turn({1, 0, 0}, 1.5707963267948966)}, {"cap", {0, 0, 0.004}, {}}}));
  s.fills[0].items = {{"ball", "soft", 1, 0.7, 1.0},     {"grain", "soft", 1, 0.8, 1.0},
                      {"dumbbell", "hard", 2, 0.8, 1.0}, {"clump", "soft", 2, 0.8, 1.0},
                      {"ell", "hard", 2, 0.7, 0.9},      {"plus", "soft", 2, 0.8, 1.0},
                      {"mushroom", "hard", 2, 0.7, 0.9}};
  return s;
}

}  // namespace dem::scenes
