// How well groups of bodies are mixed, from their shares in boxes.
//
//   c_k = n_gk / n_k              share of group g among the n_k bodies of box k (centres in it)
//   σ²  = Σ n_k (c_k − p)² / N    p = share of g among all N (1) σ0² = p (1 − p)               wholly segregated;  σr²
//   = p (1 − p)/n, n = N/K: mixed at random, mean sample size n M   = (σ0² − σ²)/(σ0² − σr²)  Lacey's index: 0
//   segregated, 1 random, with a scatter that K boxes leave           (2) RSD = σ/p,  I = σ²/σ0²        relative
//   standard deviation; Danckwerts' intensity of segregation
//
// The mean of σ² over all ways to deal out the groups on the same boxes is p (1 − p)(K − 1)/(N − 1), a little less than
// σr²; it is reported too. Of several groups σ, σ0 and σr are sums over them. Weighted by n_k: boxes at a free surface
// hold few bodies. Source: Lacey, J. Appl. Chem. 4 (1954) 257; Danckwerts, Appl. Sci. Res. A 3 (1952) 279.
// The index depends on the boxes: state their number with it. Cost: O(bodies).
// Tests: tests/libdem/analysis_mixing.cpp.
#pragma once

#include <optional>
#include <vector>

#include "libdem/analysis/grid.h"
#include "libdem/analysis/groups.h"
#include "libdem/analysis/result.h"

namespace dem::analysis {

struct MixingOfGroup {
  double share = 0, variance = 0, segregated = 0, random = 0, random_exact = 0;  // p, σ², σ0², σr²
  std::optional<double> lacey() const;  // nothing where one group is all, or a box holds one body
  std::optional<double> rsd() const;    // nothing where nobody is in the group
  std::optional<double> intensity() const;
};
struct Mixing {
  std::size_t bodies = 0, boxes = 0;  // N in groups and in the grid; K that hold some
  std::vector<MixingOfGroup> groups;
  MixingOfGroup all;  // sums; `share` 1
};
Mixing mixing_of(const Snapshot& snapshot, const Grid& grid, const Groups& groups);

Result report_mixing(const Snapshot& snapshot, const Settings& settings);

}  // namespace dem::analysis
