// Stability limits of the step, pair by pair: what dt = "auto" is chosen from and what `dem check` prints.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "libdem/world.h"

namespace dem {

// The bodies of one shape and material; places are storage indices.
struct BodyGroup {
  std::uint32_t shape = 0, material = 0;
  std::size_t count = 0;
  std::size_t light = 0;  // the member that yields most easily: it stands for all in the limits
  std::size_t large = 0;  // the member of largest equivalent radius
};
// In order of shape and material.
std::vector<BodyGroup> body_groups(const World& world);

// Where a group of bodies meets another one (or itself) or a wall, as stiff as a contact at run.dt_overlap between two
// bodies with run.dt_contacts contacts each makes it.
struct PairLimit {
  std::size_t group = 0;    // index into body_groups
  std::size_t partner = 0;  // likewise, or index into World::walls
  bool wall = false;        // which of them
  double normal = 0;        // s, limit of the normal mode
  double tangential = 0;    // s, of the sticking mode; +infinity without friction
  double limit() const { return normal < tangential ? normal : tangential; }
};
// Every pair once, in order of group and partner, walls after groups. Cost: groups · (groups + walls).
std::vector<PairLimit> pair_limits(const World& world, const std::vector<BodyGroup>& groups);

}  // namespace dem
