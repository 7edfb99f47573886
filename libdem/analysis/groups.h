// Bodies in groups: what mixing compares and what pictures colour.
//
//   species, material, shape   as in the snapshot; group names are theirs
//   size      by equivalent radius: one group per radius where there are at most eight (equal to 1e-6), else two at
//             the mean
//   density   mass over volume, in the same way
//   x y z     equal slabs of the reference's extent along the axis, ids that it does not have: no group
//   layers    the same along gravity, from below (without gravity along the last axis); position: its two halves
// Without a reference, slabs are those of the snapshot itself. Cost: O(bodies log bodies).
// Tests: tests/libdem/analysis_mixing.cpp.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "libdem/analysis/group_words.h"
#include "libdem/analysis/snapshot.h"

namespace dem::analysis {

struct Groups {
  static constexpr std::uint32_t none = 0xffffffffu;
  std::vector<std::string> names;
  std::vector<std::uint32_t> of_body;  // place in names, or none
};
// Throws InputError with the list of words when `by` is none of them. slabs: of x, y, z, layers.
Groups groups_of(const Snapshot& snapshot, const std::string& by, const Snapshot* reference, int slabs = 8);

// Of each body its place in the other snapshot, by id; none where it is not there.
std::vector<std::uint32_t> places_in(const Snapshot& snapshot, const Snapshot& other);
// Unit vector against gravity; without gravity along the last axis.
Vec3d upward(const Snapshot& snapshot);

}  // namespace dem::analysis
