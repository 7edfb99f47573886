// Pressure on a wall over height.
//
//   p(h) = Σ (normal force of the contacts between h and h + Δh) / A(h)   [Pa]                                    (1)
//   A(h) = area of the wall between these heights, exact: of its triangles; of planes the part that the box around the
//          region shows; of lines and polygons in the plane lengths times the thickness                           [m²]
//
// Heights are counted along gravity's opposite from the origin (without gravity along the last axis), bands are of one
// height from the lowest to the highest point of the region; contacts beyond it count with the outermost that have
// area. Bands without area are left out. Walls that stand in fewer than two bands (level ones) have no profile. Cost:
// O(contacts of the wall + triangles · bands). Accuracy: round-off. Tests: tests/libdem/analysis_walls.cpp.
#pragma once

#include "libdem/analysis/grid.h"
#include "libdem/analysis/result.h"

namespace dem::analysis {

struct WallBand {
  double from = 0, to = 0;          // m
  double area = 0;                  // m²
  double pressing = 0, across = 0;  // N: sums of normal forces; of the magnitudes of tangential ones
};
std::vector<WallBand> wall_profile(const Snapshot& snapshot, std::size_t wall, const Domain& region, double height);

// Table height_<wall>; no rows where there is no profile.
Table profile_table(const Snapshot& snapshot, std::size_t wall, const Domain& region, double height);

}  // namespace dem::analysis
