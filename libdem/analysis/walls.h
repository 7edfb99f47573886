// What bodies do to walls now: force, torque, pressure, and maps of pressure.
//
//   F = −Σ f  [N],  M = Σ (x − X) × (−f)  [N m]   f: force on a body at x, X: the wall's own point
//   pressure = Σ (normal force) / A  [Pa]         of a wall, a triangle, a side or a square of area A
//
// A contact loads the triangle of a mesh, the side of a polygon, or the square of a plane that holds its point. Squares
// (of a line: stretches, times the thickness) divide the box around the region as the plane's frame sees it, so that
// those which bear nothing are there too; points beyond count with the outermost. A is the mesh's area, the polygon's
// outline times the thickness, of planes and lines the area of all squares.
// Torques are those of the forces: couples that contacts bear (rolling, twist of a patch) are not in a snapshot, but in
// walls.csv of a run. Pressure over height: wall_profile.h. Means over time: walls.csv and pressure_map of a run. Cost:
// O(wall contacts), of meshes times the triangles per facet. Accuracy: round-off. Tests:
// tests/libdem/analysis_walls.cpp.
#pragma once

#include "libdem/analysis/pairs.h"
#include "libdem/analysis/settings.h"

namespace dem::analysis {

struct WallForce {
  Vec3d force{}, torque{};   // of the bodies on the wall; torque about its position
  double pressing = 0;       // N, sum of the normal parts
  std::size_t contacts = 0;  // pairs of a body and the wall
};
// One per wall; those that are not present bear nothing.
std::vector<WallForce> wall_forces(const Snapshot& snapshot);

struct Extent {
  double low = 0, high = 0;  // m
  double width() const { return high - low; }
};
// The box around the region along x and y of a wall's frame, about its position.
std::array<Extent, 2> seen_from(const SnapshotWall& wall, const Domain& region);

struct WallPatch {
  Vec3d centre{};               // world, m
  double area = 0;              // m²
  double pressing = 0;          // N
  Vec3d force{}, tangential{};  // on the wall, world frame, N; its part across the contacts' normals
};
// squares: how many along x and y of a plane's frame (of a line x alone).
std::vector<WallPatch> wall_map(const Snapshot& snapshot, std::size_t wall, const Domain& region,
                                const std::array<int, 2>& squares);
// As many as let squares be about `side` wide, m; 256 at most.
std::array<int, 2> squares_of(const Snapshot& snapshot, std::size_t wall, const Domain& region, double side);

Result report_walls(const Snapshot& snapshot, const Settings& settings);

}  // namespace dem::analysis
