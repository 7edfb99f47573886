// What bodies do to walls, summed over time: impulse and work of every wall, and loads triangle by triangle of meshes
// that ask for a map (`pressure_map`). Sums over steps of what acts at their ends: means over any span of time follow
// from differences. All of it is part of the state.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "libdem/accumulator.h"
#include "shapes/math/quat.h"

namespace dem {

struct World;
struct Wall;

struct TriangleLoad {          // ∫ dt, in the wall's frame
  shapes::Vec3d force{};       // of the bodies on the triangle, N s
  shapes::Vec3d tangential{};  // its part across the contacts' normals (friction), N s
  double pressing = 0;         // sum of the normal parts, whichever side they come from, N s
};

struct WallLoad {
  std::array<Accumulator, 3> impulse;  // ∫ force dt since the start, N s
  Accumulator work;                    // ∫ power dt since the start, J: of the bodies on the wall
  std::vector<TriangleLoad> map;       // per triangle, empty without a map; since the last frame before this step
};

// Adds the forces that have just been summed, over a step dt. Maps begin anew at the step after a frame. Cost: a few
// operations per wall; with a map, a search of the facet's triangles per contact.
void book_wall_loads(World& world, double dt);
// Power of the bodies on a wall now: force · velocity + torque · spin, W.
double wall_power(const Wall& wall);
// Over how much time the maps have been summed, s; 0 before the first step.
double map_duration(const World& world);

// Mean tractions on the triangles of a wall with a map since the frame before, in the order of the mesh's triangles.
struct TriangleTraction {
  shapes::Vec3d traction{};  // force per area of the bodies on the triangle, world frame, Pa: Σ traction · area = force
  shapes::Vec3d shear{};     // its tangential part, Pa
  double pressure = 0;       // Pa, >= 0 for contacts that push
};
std::vector<TriangleTraction> tractions(const World& world, const Wall& wall);

}  // namespace dem
