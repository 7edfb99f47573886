// Bodies of any sizes in grids of several widths: the bodies of a level have radii within a factor of two, and its
// cells are as wide as two of its largest. The radius is that of the bounding sphere and the body's allowance. A body
// looks into every level as far as it reaches, so that a few large bodies among many small ones, or the reverse, cost
// what their neighbours do; in one grid as wide as the largest bodies each small one would look at all that fit into 27
// of them. Bodies of about one size make one level.
#pragma once

#include <vector>

#include "libdem/broad_phase/cells.h"
#include "libdem/particles.h"

namespace dem {

class Levels {
 public:
  // allowance: of each body, m. side: of the cells, over twice the largest radius; only the time that a search takes
  // depends on it.
  Levels(const std::vector<Motion>& bodies, const std::vector<double>& allowance, const Cell& box, double side = 1);

  // visit(j) for every body j whose bounding sphere is nearer than the allowances of both to that of body i, i itself
  // included.
  template <class Visit>
  void near(std::size_t i, Visit visit) const {
    const Motion& m = bodies_[i];
    for (const Level& level : levels_) {
      const double own = m.bounding_radius + allowance_[i];
      level.cells.near(m.position, own + level.largest, [&](std::uint32_t first, std::uint32_t last) {
        for (std::uint32_t k = first; k < last; ++k) {
          const Ball& ball = level.balls[k];
          const Vec3d d = lattice_.nearest(ball.centre - m.position);
          const double reach = own + ball.radius;
          if (dot(d, d) < reach * reach) visit(level.cells.order()[k]);
        }
      });
    }
  }

 private:
  struct Ball {
    Vec3d centre;
    double radius;
  };
  struct Level {
    double largest;  // radius, m
    Cells cells;
    std::vector<Ball> balls;  // in the order of the cells
  };
  const std::vector<Motion>& bodies_;
  const std::vector<double>& allowance_;
  contact::Lattice lattice_;
  std::vector<Level> levels_;  // of large bodies first
};

// All bodies in an order in which what is near in space is near, in cells that suit the most of them.
std::vector<std::uint32_t> order_in_space(const std::vector<Motion>& bodies, const std::vector<double>& allowance,
                                          const Cell& box);

}  // namespace dem
