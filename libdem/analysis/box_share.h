// How much of a body lies in a box: exact shares of bodies of every shape that the faces of boxes cut.
//
//   sphere, disc            signed sums of closed forms (round_in_box.h)
//   ellipsoid, ellipse      the unit ball and a parallelepiped, the unit disc and a parallelogram (cut_solid.h)
//   everything else         pieces without overlap, each with a closed form (body_pieces.h)
//
// A share is the body's volume times the share of its geometry, so that shares add up to `volume` of the snapshot; in
// the plane it is area times thickness. Bodies that overlap count both. Accuracy: 1e-12 of the body, but for rounded
// polyhedra whose edges lie within 1e-6 of a face's direction without being parallel (1e-8), and bodies of parts in
// which ellipsoids overlap round parts: their overlap counts for both parts, the whole scaled to the volume of the body
// (`notes` says so). Cost: nothing but a comparison for a body in one box; cut ones per box
// 0.1 us a sphere, 1.5 us an ellipsoid, 1 us a cube, 10 to 20 us a rounded or potential cube. Tests:
// tests/libdem/analysis_box_share.cpp.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "libdem/analysis/body_pieces.h"
#include "libdem/analysis/grid.h"

namespace dem::analysis {

struct BoxShare {
  std::uint32_t body = 0;
  std::size_t box = 0;  // place in the grid
  double volume = 0;    // m³, > 0
};

class BoxShares {
 public:
  explicit BoxShares(const Snapshot& snapshot);  // which must outlive it
  // Of body i, moved by `shift`, in a box; in what half-spaces normal·x <= offset (unit normals) have in common.
  double in_box(std::size_t i, const Vec3d& shift, const Grid::Box& box) const;
  double in_half_spaces(std::size_t i, const Vec3d& shift, std::span<const shapes::HalfSpace> planes) const;
  // The box about body i along the axes; of bodies of pieces about its bounding sphere, polyhedra apart.
  Grid::Box bounds(std::size_t i) const;
  // Every share of every body (every image of it) in the boxes of a grid, in order of bodies. On several threads.
  std::vector<BoxShare> on(const Grid& grid) const;
  const std::vector<std::string>& notes() const { return notes_; }

 private:
  const Snapshot& s_;
  std::vector<BodyPieces> pieces_;  // of the shapes
  std::vector<std::string> notes_;
};

}  // namespace dem::analysis
