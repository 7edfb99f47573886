// The network of normal forces: strong and weak contacts, its clusters, and up to which force it still goes through.
//
//   f = normal force of a pair (pairs.h), <f> its mean over the pairs of bodies that push                       [N]
//   strong: f >= s <f>, s = Settings::strong_force (1: Radjai et al., Phys. Rev. Lett. 80 (1998) 61)
//   clusters: bodies that strong contacts join
//   percolation along an axis: a cluster reaches from one side of the region to the other, a side being all bodies that
//   come within one mean bounding radius of it; along a periodic axis: a cluster reaches its own image
//   critical force: the largest f_c for which the contacts f >= f_c percolate                                   [N]
// Contacts that pull are in none of it. Cost: O(NC log NC). Tests: tests/libdem/analysis_forces.cpp.
#pragma once

#include <array>
#include <optional>

#include "libdem/analysis/clusters.h"
#include "libdem/analysis/pairs.h"
#include "libdem/analysis/settings.h"

namespace dem::analysis {

struct ForceNetwork {
  double mean = 0, threshold = 0;                 // <f>, s <f>, N; 0: nothing pushes
  std::vector<std::uint8_t> strong;               // per pair of bodies
  Clusters::List clusters;                        // of the strong network, two bodies at least
  std::array<bool, 3> percolates{};               // it, along the axes
  std::array<std::optional<double>, 3> critical;  // N; nothing: not even all contacts do
};
ForceNetwork force_network_of(const Snapshot& snapshot, const Pairs& pairs, const Domain& region, double strong);

// What pictures draw: from centre to centre, to the nearest image; of walls from the centre to the point.
struct NetworkLine {
  Vec3d from{}, to{};      // m
  std::uint32_t pair = 0;  // place in Pairs::bodies or Pairs::walls
  bool wall = false, strong = false;
  double force = 0, relative = 0, tangential = 0;  // normal, N; over <f>; N
};
std::vector<NetworkLine> network_lines(const Snapshot& snapshot, const Pairs& pairs, const ForceNetwork& network);
// For pictures: per line force, relative, tangential, strong, wall; per point width, the relative force (>= 0), which
// filters that make tubes of lines ask for.
Surface network_surface(const std::vector<NetworkLine>& lines);

}  // namespace dem::analysis
