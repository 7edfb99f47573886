// What is in the way of a new body: the bounding spheres of bodies and the triangles of meshes, in cells by size class;
// half-spaces.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <unordered_map>
#include <vector>

#include "libdem/world.h"

namespace dem {

class Occupancy {
 public:
  // The walls that are present and the bodies that reach into the box from lower to upper.
  Occupancy(const World& world, const Vec3d& lower, const Vec3d& upper);

  void add(const Vec3d& x, double radius);
  // Whether a sphere overlaps a body or a wall; touching is allowed.
  bool blocked(const Vec3d& x, double radius) const;

 private:
  static constexpr std::uint32_t none = 0xffffffffu;
  struct Sphere {  // a body's, or the one around a triangle
    Vec3d x;
    double radius;
    std::uint32_t triangle;
  };
  struct Cell {
    std::int64_t x, y, z;
    friend bool operator==(const Cell&, const Cell&) = default;
  };
  struct Hash {
    std::size_t operator()(const Cell& c) const;
  };
  struct Level {  // radii from 2^level up to twice that
    double side = 0;
    std::vector<Sphere> spheres;
    std::unordered_map<Cell, std::vector<std::uint32_t>, Hash> cells;
  };
  void add_mesh(const Wall& wall);
  void add_image(const Vec3d& x, double radius);
  void file(const Sphere& sphere);  // under the level of its radius
  bool overlaps(const Sphere& sphere, const Vec3d& x, double radius) const;
  bool meets(const Level& level, const Vec3d& x, double radius) const;
  Vec3d lower_, upper_, period_{};  // m; period 0: none
  std::vector<const Wall*> half_spaces_;
  std::vector<std::array<Vec3d, 3>> triangles_;  // world frame, m
  std::map<int, Level> levels_;
};

}  // namespace dem
