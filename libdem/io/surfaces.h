// Walls as polygons in world coordinates, and the box that a scene fills: what files for viewers and pictures share.
#pragma once

#include <cstdint>
#include <vector>

#include "libdem/world.h"

namespace dem::io {

struct Box {
  Vec3d lower{}, upper{};  // m
  bool empty = true;
  void add(const Vec3d& point, double margin = 0);
  Vec3d centre() const { return (lower + upper) * 0.5; }
  double radius() const { return 0.5 * norm(upper - lower); }  // of the sphere about it
};

Box particle_box(const World& world);
// Particles, mesh walls that are present, boxes that are filled and, when there is nothing else, the planes' points.
Box scene_box(const World& world);

// The periodic box; along axes that are not periodic it ends where the bodies do.
Box cell_box(const World& world);

struct WallSurface {
  std::size_t wall;                    // index into World::walls
  bool half_space;                     // a plane: only the side that its normal points to is free
  Vec3d normal{};                      // plane only
  std::vector<Vec3d> vertices;         // m
  std::vector<std::uint32_t> corners;  // polygons one after the other, as vertex indices
  std::vector<std::uint32_t> ends;     // where each polygon ends in `corners`
  std::vector<std::uint8_t> outline;   // per corner: 1 when the edge to the next corner is one of the wall, not inner
};

// The walls that are present. A plane becomes the part of a square about the box that lies on the free side of all
// other planes: five planes show as an open box.
std::vector<WallSurface> wall_surfaces(const World& world, const Box& box);
// Of a plane with a pressure map: the squares of its map that were touched.
WallSurface map_squares(const World& world, std::size_t wall);
// What shows the periodic box in a picture: its faces (`wall` is the number of walls), in 2-D the rectangle in front of
// the bodies; nothing in a scene without one.
std::vector<WallSurface> cell_surfaces(const World& world);

}  // namespace dem::io
