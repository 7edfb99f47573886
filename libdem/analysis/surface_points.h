// Points on the surfaces of bodies of every shape, evenly spread: what set-Voronoi cells are made of.
//
//   sphere                    Fibonacci's spiral
//   disc, ellipse, polygon    equal steps along the outline
//   everything else           of twenty times as many points each the farthest from those before, then three rounds of
//                             moving into the middle (Lloyd)
// The many points lie on triangles of the surface, by area; of round shapes they are moved onto it, an ellipsoid along
// its radius, a rounded polyhedron away from its core, a potential particle away from its centre; of bodies of parts
// those in another part are left out. Convex bodies have their centre too: else all cells of a sphere would meet in one
// point, where Voronoi codes lose digits. Points inside change no cell but those of the same body.
//
// The spacing is about the same on all bodies, else the finer one would win space: a body has `count` points times its
// equivalent radius squared over the mean of these (in the plane the radius), to the next half power of two, from 8 to
// 20000. No random numbers: the same points always. Cost: 20 count² a shape and size, set-up.
// Accuracy: on the surface to 1e-12 of the size. Tests: tests/libdem/analysis_voronoi.cpp.
#pragma once

#include <cstddef>
#include <vector>

#include "libdem/analysis/snapshot.h"

namespace dem::analysis {

class SurfacePoints {
 public:
  SurfacePoints(const Snapshot& snapshot, std::size_t count);  // the snapshot must outlive it
  // Those of body i, world coordinates, m.
  std::vector<Vec3d> of(std::size_t i) const;

 private:
  const Snapshot& s_;
  std::vector<std::uint32_t> set_;        // of a body
  std::vector<std::vector<Vec3d>> sets_;  // body frame, scale 1; ellipsoids and ellipses at the shape's own axes
};

}  // namespace dem::analysis
