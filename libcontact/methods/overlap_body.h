// The overlap of convex polyhedra as a body: one of them cut by planes, plane by plane.
//
// Every cut decides for each corner once on which side it lies, and faces share their corners: the pieces of both
// surfaces fit together whatever the rounding, where faces are parallel or lie in one plane too. Corners in a plane
// are kept: a face that both bodies have in one place is the first one's.
//
// Scratch of the thread that grows to the largest overlap and is not given back. Cost: corners of the overlap × planes
// that meet it. Accuracy: corners to 64 eps of the pair's size. Tests: tests/libcontact/overlap_volume.cpp,
// overlap_depth.cpp, approximate_polyhedra.cpp
#pragma once

#include <vector>

#include "libcontact/methods/polyhedron_pair.h"

namespace contact {

class OverlapBody {
 public:
  struct Face {
    Vec3d normal;  // unit, out of the overlap
    std::uint32_t first, count;
    bool of_other;  // made by a cut
  };

  // The whole of p, scaled.
  void begin(const shapes::Polyhedron& p, double scale);
  // What lies of p, scaled, in n·x <= level; false: nothing.
  bool begin(const shapes::Polyhedron& p, double scale, const Vec3d& n, double level);
  // Keeps n·x <= level; false when nothing is left.
  bool cut(const Vec3d& n, double level);

  const std::vector<Vec3d>& corners() const { return corners_; }
  const std::vector<Face>& faces() const { return faces_; }
  // Corner k of a face, in order about its normal.
  std::uint32_t name(const Face& f, std::uint32_t k) const { return loops_[f.first + k]; }
  const Vec3d& corner(const Face& f, std::uint32_t k) const { return corners_[name(f, k)]; }
  // The face of other with the side from j to i; null: none.
  const Face* face_of_other(std::uint32_t j, std::uint32_t i) const;

 private:
  struct Crossing {
    std::uint32_t in, out, corner;
    std::uint32_t after;  // of the cut's own face: the crossing that comes next
  };
  struct Solid;  // what is cut: a polyhedron's own arrays, or what earlier cuts have left
  bool clip(const Solid& solid, const Vec3d& n);
  void close(const Vec3d& normal, std::uint32_t first, bool of_other);

  std::vector<Vec3d> corners_, next_corners_;
  std::vector<double> height_;
  std::vector<std::uint32_t> kept_as_;
  std::vector<std::uint32_t> loops_, next_loops_;
  std::vector<Face> faces_, next_faces_;
  std::vector<Crossing> crossings_;
};

// What lies in both, in the frame of the pair's self; no faces: nothing. Valid until the thread's next call.
const OverlapBody& overlap_body(const PolyhedronPair& pair);
// The same where self reaches into other along n, from self to other: what is out of the other's reach along n is left
// out first.
const OverlapBody& overlap_body(const PolyhedronPair& pair, const Vec3d& n);
// What lies of p, scaled, in n·x <= level.
const OverlapBody& overlap_body(const shapes::Polyhedron& p, double scale, const Vec3d& n, double level);

}  // namespace contact
