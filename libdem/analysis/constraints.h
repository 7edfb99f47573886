// How many motions a contact takes from two bodies without friction: the number of independent normal forces that its
// patch can bear. A point 1, an edge on a face 2, a face on a face 3; in the plane a corner 1, a side on a side 2.
//
//   M = <w wᵀ>, w = (n, (r × n)/R)  over the points of the patch; constraints = eigenvalues of M above s²          (1)
//   patch: where the feature of a, its vertices that lie within max(overlap, t R) of its outermost along n, and the
//   feature of b, seen along n, lie over each other; R the smaller equivalent radius
//
// s = 0.05: a patch counts as wide where its half width is above that share of R; t = 0.001. A pair of several records
// counts them together, up to 6 (3). Spheres, ellipsoids and potential particles touch in a point; planes and mesh
// facets are taken to go on for ever. Bodies of parts and polygons that are not convex count by the points of
// their records alone: too few where their parts meet face to face.
// Twice the mean number of degrees of freedom is the isostatic value (spheres 3, of revolution 5, others 6; plane 2,
// 3). Source: Smith, Alam and Fisher, arXiv:1104.4933; Jaoshvili et al., Phys. Rev. Lett. 104 (2010) 185501. Cost:
// vertices per contact of polyhedra; nothing for round bodies. Tests: tests/libdem/analysis_constraints.cpp.
#pragma once

#include "libdem/analysis/pairs.h"

namespace dem::analysis {

struct Constraints {
  std::vector<std::uint8_t> of_pair, of_wall;  // as Pairs::bodies and Pairs::walls
  bool from_points = false;                    // some were counted by the points of records alone
};
Constraints constraints_of(const Snapshot& snapshot, const Pairs& pairs);

double degrees_of_freedom(const Snapshot& snapshot, std::size_t body);

}  // namespace dem::analysis
