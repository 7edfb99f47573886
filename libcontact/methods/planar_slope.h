// (1)–(4) of overlap_depth.h in the plane: of a connected overlap of outlines, made of convex pieces.
#pragma once

#include "libcontact/methods/overlap_moments.h"
#include "libcontact/methods/planar_outline.h"

namespace contact {

class PlanarOverlap {
 public:
  // Cuts between parts of a body are no border of it, but move with it.
  enum Side : std::uint32_t { of_a, of_b, cut_of_a, cut_of_b };

  // A convex piece, counter-clockwise; side_of takes a corner's `side` to a Side.
  template <class SideOf>
  void add(const Corners& piece, SideOf&& side_of) {
    for (const LoopCorner& c : piece) corners_.push_back({c.x, side_of(c.side)});
    ends_.push_back(static_cast<std::uint32_t>(corners_.size()));
  }
  // False where it is shallower than least_depth of `size`, that of the smaller body, or its chord has no direction.
  bool slope(double size, DepthSlope& out) const;

 private:
  // Side from `from` to `to`, after the one from `previous`; pieces one after another.
  struct At {
    Vec3d previous, from, to, first;  // first corner of the piece
    std::uint32_t before, side;
  };
  template <class Visit>
  void each_side(Visit&& visit) const {
    std::uint32_t first = 0;
    for (const std::uint32_t end : ends_) {
      for (std::uint32_t i = first; i < end; ++i) {
        const LoopCorner &previous = corners_[i == first ? end - 1 : i - 1], &corner = corners_[i];
        visit(At{previous.x, corner.x, corners_[i + 1 == end ? first : i + 1].x, corners_[first].x, previous.side,
                 corner.side});
      }
      first = end;
    }
  }
  ShortList<LoopCorner, 32> corners_;
  ShortList<std::uint32_t, 8> ends_;
};

// Of two convex loops. False: as above, or they do not overlap.
bool outlines_depth(const Loop& a, const Loop& b, double smaller, OverlapDepth& out);
// Of the overlap's outline, whose sides are named of_a, of_b.
bool outline_depth(const Corners& overlap, double smaller, OverlapDepth& out);

}  // namespace contact
