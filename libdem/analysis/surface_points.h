// Points on the surfaces of bodies of every shape, evenly spread: what set-Voronoi cells are made of.
//
//   sphere               Fibonacci's spiral
//   disc, ellipse, polygon   equal steps along the outline
//   everything else      triangles of the surface, each with its share of the points by area, placed by the additive
//                        sequence of the plastic number; of round shapes moved onto the surface: an ellipsoid along its
//                        radius, a rounded polyhedron away from its core, a potential particle away from its centre
//   bodies of parts      points of the parts that lie in no other part
// and, of convex bodies, their centre: else all cells of a sphere would meet in one point, which is where Voronoi codes
// lose digits. Points inside change no cell but those of the same body.
// No random numbers: the same points always. Bodies of parts get about `count` points.
// Accuracy: on the surface to 1e-12 of the size. Tests: tests/libdem/analysis_voronoi.cpp.
#pragma once

#include <cstddef>
#include <vector>

#include "libdem/analysis/snapshot.h"

namespace dem::analysis {

class SurfacePoints {
 public:
  SurfacePoints(const Snapshot& snapshot, std::size_t count);  // > 3; the snapshot must outlive it
  // Those of body i, world coordinates, m.
  std::vector<Vec3d> of(std::size_t i) const;

 private:
  const Snapshot& s_;
  std::vector<std::vector<Vec3d>> of_shape_;  // body frame, scale 1; ellipsoids and ellipses at the shape's own axes
};

}  // namespace dem::analysis
