// Bodies of any sizes in grids of several widths: the bodies of a level have bounding radii within a factor of two, and
// its cells are as wide as two of its largest. A body looks into every level as far as it reaches, so that a few large bodies
// among many small ones, or the reverse, cost what their neighbours do; in one grid as wide as the largest bodies each
// small one would look at all that fit into 27 of them. Bodies of about one size make one level.
#pragma once

#include <vector>

#include "libdem/broad_phase/cells.h"
#include "libdem/particles.h"

namespace dem {

class Levels {
 public:
  Levels(const std::vector<Motion>& bodies, double skin, const Cell& box);

  // visit(j) for every body j whose bounding sphere is nearer than the skin to that of body i, i itself, and others.
  template <class Visit>
  void near(std::size_t i, Visit visit) const {
    const Motion& m = bodies_[i];
    for (const Level& level : levels_) level.cells.near(m.position, m.bounding_radius + level.largest + skin_, visit);
  }
  double largest() const { return levels_.empty() ? 0 : levels_.front().largest; }  // bounding radius, m

 private:
  struct Level {
    double largest;  // bounding radius, m
    Cells cells;
  };
  const std::vector<Motion>& bodies_;
  double skin_;
  std::vector<Level> levels_;  // of large bodies first
};

// All bodies in an order in which what is near in space is near, in cells that suit the most of them.
std::vector<std::uint32_t> order_in_space(const std::vector<Motion>& bodies, double skin, const Cell& box);

}  // namespace dem
