// Force chains: quasi-linear rows of bodies that bear more than the rest.
//
//   σ   = −(1/V) Σ sym(r ⊗ f)   stress of a body of volume V: contact points r from its centre, forces f on it;
//         compression positive [Pa]. Its largest principal value σ1 and direction d stand for the load.          (1)
//   a body is loaded where σ1 > mean σ1 of the bodies that have contacts                                         (2)
//   two loaded bodies in contact are links of a chain where the line of centres l, seen from each of them, lies within
//   α of its d: |l·d| >= cos α |l|, α = 45°                                                                      (3)
//   a chain: three bodies or more that such links join
// Source: Peters, Muthuswamy, Wibowo and Tordesillas, Phys. Rev. E 72 (2005) 041307, who use the most compressive
// principal stress, its mean, three bodies and α = 45° as well. There chains are followed from body to body; here (3)
// must hold at both ends and chains are the components of the graph, so they may branch: `branches` counts the bodies
// with more than two links. Cost: O(bodies + contacts). Tests: tests/libdem/analysis_forces.cpp.
#pragma once

#include "libdem/analysis/clusters.h"
#include "libdem/analysis/pairs.h"
#include "libdem/analysis/tensor.h"

namespace dem::analysis {

// (1) of every body, walls included; zero without contacts.
std::vector<Mat3d> body_stresses(const Snapshot& snapshot);

struct Chain {
  std::uint32_t bodies = 0, links = 0, branches = 0;
  double length = 0;  // m, sum of its links' lengths from centre to centre
};
struct ForceChains {
  double mean_load = 0;                // of (2), Pa
  std::vector<double> load;            // σ1 per body, Pa
  std::vector<Vec3d> direction;        // d per body
  std::vector<std::uint32_t> of_body;  // chain of each body, Clusters::none
  std::vector<std::uint8_t> link;      // per pair of bodies
  std::vector<Chain> chains;           // the longest first
};
ForceChains force_chains_of(const Snapshot& snapshot, const Pairs& pairs, double angle = 0.7853981633974483);  // α

}  // namespace dem::analysis
