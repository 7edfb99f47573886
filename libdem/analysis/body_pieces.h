// A shape as pieces that do not overlap, each of them a convex solid, or its part in an ellipsoid or a cylinder: what
// planes cut off a piece has a closed form (cut_solid.h).
//
//   polyhedron           itself
//   rounded polyhedron   the core; a prism on every face, a sector of a cylinder along every edge, of a ball at every
//                        corner
//   potential particle   f of potential_particle.h is a quadratic where the planes that a point lies beyond are the
//   same:
//                        a piece of an ellipsoid in every cell of the arrangement of planes that the body reaches
//   body of parts        spheres cut along the planes in which they meet, less the polyhedra; polyhedra less those
//                        before them. Only ellipsoids that overlap spheres or ellipsoids stay whole (`exact` false):
//                        their overlap counts for both
//   polygon              prisms of height 1 on its convex parts
// Exact to rounding, each. Shapes at scale 1, body frame. Cost: once per shape, up to 0.1 s for 64 planes or tens of
// parts. Tests: tests/libdem/analysis_box_share.cpp.
#pragma once

#include <vector>

#include "libdem/analysis/cut_solid.h"
#include "libdem/world.h"

namespace dem::analysis {

struct BodyPiece {
  enum class Kind { solid, ball, cylinder } kind = Kind::solid;
  CutSolid solid;
  RoundFrame frame;                             // of a ball
  Vec3d point{}, along{};                       // of a cylinder
  double radius = 0;                            // of a cylinder, m
  Vec3d middle{};                               // of a sphere that holds the piece, m
  double reach = 0;                             // its radius, m
  double volume = 0;                            // m³
  double volume_of(const CutSolid& cut) const;  // of the part of `cut`, which lies in `solid`
};

struct BodyPieces {
  std::vector<BodyPiece> pieces;
  double volume = 0;  // sum over the pieces, m³; polygons: area, m²
  bool exact = true;
};

// Of everything but spheres, discs, ellipsoids and ellipses, which are their own closed form: none.
BodyPieces pieces_of(const ShapeEntry& shape);

}  // namespace dem::analysis
