// What bodies do to walls, summed over time: impulse and work of every wall, and, of those that ask for a map
// (`pressure_map`), the loads on each triangle of a mesh or on squares of a plane (`map_cell`), as far as they are
// touched. A contact loads the triangle or square that holds its centre. Sums over steps of what acts at their ends:
// means over any span of time follow from differences. All of it is part of the state.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "libdem/accumulator.h"
#include "shapes/math/quat.h"

namespace dem {

struct World;
struct Wall;

struct MapLoad {               // ∫ dt, in the wall's frame
  shapes::Vec3d force{};       // of the bodies on the triangle or square, N s
  shapes::Vec3d tangential{};  // its part across the contacts' normals (friction), N s
  double pressing = 0;         // sum of the normal parts, whichever side they come from, N s
};

struct WallLoad {
  std::array<Accumulator, 3> impulse;  // ∫ force dt since the start, N s
  Accumulator work;                    // ∫ power dt since the start, J: of the bodies on the wall
  std::vector<MapLoad> map;            // per triangle or square, since the last frame before this step
  // Of a plane: which squares `map` is of, in order; square (i, j) spans [i, i + 1] × [j, j + 1] times map_cell along x
  // and y of the plane's frame. Empty for meshes.
  std::vector<std::array<std::int64_t, 2>> squares;
};

// Adds the forces that have just been summed, over a step dt. Maps begin anew at the step after a frame. Cost: a few
// operations per wall; with a map, per contact a search of the facet's triangles or, logarithmic, of the squares.
void book_wall_loads(World& world, double dt);
// Power of the bodies on a wall now: force · velocity + torque · spin, W.
double wall_power(const Wall& wall);
// Over how much time the maps have been summed, s; 0 before the first step.
double map_duration(const World& world);

// Mean tractions on the triangles or squares of a wall with a map since the frame before, in the order of its map.
struct MapTraction {
  shapes::Vec3d traction{};  // force per area of the bodies there, world frame, Pa: Σ traction · area = force
  shapes::Vec3d shear{};     // its tangential part, Pa
  double pressure = 0;       // Pa, >= 0 for contacts that push
};
std::vector<MapTraction> tractions(const World& world, const Wall& wall);

}  // namespace dem
