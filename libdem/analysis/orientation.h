// Nematic order of elongated or flat bodies, and how they lie along walls.
//
//   u    axis of a body without a sense: along its longest extent (ellipsoid: largest semi-axis; others: principal axis
//        of least inertia); of flat bodies, whose two longest are equal to 1e-6, across them. Round ones have none
//   Q    = <3 u u − I>/2,  in the plane <2 u u − I>; largest eigenvalue S with the director as its axis             (1)
//        S: 1 aligned, 0 isotropic; −1/2 the least <P2> about an axis, bodies lying across it. Of N isotropic bodies
//        S is not 0 but about 1/√N
//   wall <P2(u·n)> = <3 (u·n)² − 1>/2,  in the plane <2 (u·n)² − 1>, of bodies by the distance of their centres from
//        a plane or line of normal n: −1/2 (−1) where they lie along it, 1 where they stand
// Source: de Gennes and Prost, The Physics of Liquid Crystals, 2.1. Cost: O(bodies · walls). Accuracy: round-off.
// Tests: tests/libdem/analysis_orientation.cpp.
#pragma once

#include <optional>
#include <vector>

#include "libdem/analysis/settings.h"
#include "libdem/analysis/tensor.h"

namespace dem::analysis {

std::optional<Vec3d> body_axis(const Snapshot& snapshot, std::size_t body);  // unit, world frame

struct NematicOrder {
  std::size_t bodies = 0;  // that have an axis
  Mat3d tensor{};          // Q
  Principal principal{};   // of Q; value[0] = S, axis[0] the director
};
NematicOrder nematic_order(const std::vector<Vec3d>& axes, int dimension);

struct WallAlignment {
  double distance = 0;        // m, middle of the bin
  double bodies = 0, p2 = 0;  // number; their mean
};
// Bins of one width from the wall on, m; up to `range`. Empty bins are left out.
std::vector<WallAlignment> wall_alignment(const Snapshot& snapshot, const SnapshotWall& wall, double width,
                                          double range);

Result report_orientation(const Snapshot& snapshot, const Settings& settings);

}  // namespace dem::analysis
