// Random pairs at a chosen gap, and the 3-D pairs of the case file.
#pragma once

#include <vector>

#include "tests/witness/bodies.h"

namespace witness {

enum class Family { box, grain, ellipsoid, sphere };

// Half of them separated by 1e-3 … 5e-2, half overlapping by 1e-3 … 0.2 of the smaller inscribed radius. Sizes differ
// by up to 4, ellipsoids and boxes have axis ratios up to 4. A grain is a Platonic solid, another shipped solid or a
// coarse hull of a shipped grain.
std::vector<Pair> random_pairs(Family a, Family b, int count, unsigned seed);

std::vector<Pair> case_file_pairs();

}  // namespace witness
