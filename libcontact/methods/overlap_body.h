// The overlap of convex polyhedra as a body: one of them cut by planes, plane by plane.
//
// A body is its sides, each with its two ends and the faces to its left and right: a cut shortens or drops sides and
// joins, in each face that it crosses, the two places where it does. It decides for each corner once on which side it
// lies, and faces share their sides: the pieces of both surfaces fit together whatever the rounding, where faces are
// parallel or lie in one plane too. Corners in a plane are kept: a face that both bodies have in one place is the
// first one's.
//
// The first cut walks over the corners of a polyhedron that it keeps, from the one farthest inside: the others are not
// looked at. Two edges that pass through each other begin as the tetrahedron between their four faces. Of the bodies'
// planes only those are cut with that some corner lies over, the deepest cut first.
//
// Scratch of the thread that grows to the largest overlap and is not given back. Cost: a corner cut off, or
// two edges, 20 ns, every other cut 70 ns. Accuracy: corners to 64 eps of the pair's size. Tests:
// tests/libcontact/overlap_volume.cpp, overlap_depth.cpp, approximate_polyhedra.cpp
#pragma once

#include <span>
#include <vector>

#include "libcontact/kernels/overlap_sums.h"
#include "libcontact/methods/polyhedron_pair.h"
#include "libcontact/methods/scratch_list.h"

namespace contact {

// n·x <= level
struct HalfSpace {
  Vec3d n;
  double level;
};

HalfSpace face_of_other(const PolyhedronPair& pair, std::uint32_t face);

// Where the line of an edge of each body meets the faces at the other one.
struct EdgesMeeting {
  Vec3d p, e, q, f, w;     // starts and vectors of self's and other's edge; q - p
  Vec3d of_a[2], of_b[2];  // outward normals at them
  double s[2], t[2];       // along self's edge, of other's faces; along other's edge, of self's
  int low, high;           // self's edge runs in other from face `low` to face `high`
  bool found;              // false: the edges do not pass through each other, or pass nearly parallel

  EdgesMeeting(const PolyhedronPair& pair, std::uint32_t edge_of_self, std::uint32_t edge_of_other);
  // Corners 0 and 1 on self's edge, 2 and 3 on other's, in the order of other's faces and self's; the faces there.
  void corners(Vec3d* x) const {
    x[0] = p + s[low] * e;
    x[1] = p + s[high] * e;
    x[2] = q + t[0] * f;
    x[3] = q + t[1] * f;
  }
};

class OverlapBody {
 public:
  static constexpr std::uint32_t none = 0xffffffffu;
  struct Except {
    std::uint32_t face[2] = {none, none};
  };
  // Overlaps of a known form (overlap_forms.h): one corner of self cut off by one plane, that is corner 0, the others
  // about n in order, and the plane's face the last one; two edges, self's from corner 0 to 1 and other's from 2 to 3,
  // self's faces 0 and 1, other's 2 at corner 0 and 3 at corner 1.
  enum class Form { general, corner, edges };
  using Side = kernels::OverlapSide;
  struct Face {
    Vec3d normal;          // unit, out of the overlap
    std::uint32_t enters;  // scratch of a cut: the crossing where the face enters what is kept
    bool of_other;         // made by a cut
  };

  // What lies of p, scaled, in the half space; `start`: the vertex farthest inside.
  void begin(const shapes::Polyhedron& p, double scale, const HalfSpace& keep, std::uint32_t start);
  void begin(const shapes::Polyhedron& p, double scale) { begin(p, scale, {{}, 1}, 0); }
  // What lies behind the two faces at an edge of each body, a tetrahedron. False: the edges do not pass through each
  // other, or pass nearly parallel.
  bool begin(const EdgesMeeting& meeting);
  // False: nothing lies outside the half space.
  bool cut(const HalfSpace& keep, bool of_other = true);
  // Keeps what lies behind all faces of one of the pair but those in `except`.
  void cut_by_self(const PolyhedronPair& pair, Except except);
  void cut_by_other(const PolyhedronPair& pair, Except except);

  Form form() const { return form_; }
  double depth() const { return depth_; }  // of a corner's form: how far it lies beyond the plane
  bool empty() const { return side_count_ == 0; }
  std::span<const Vec3d> corners() const { return {corners_.data(), corner_count_}; }
  std::span<const Side> sides() const { return {sides_.data(), side_count_}; }
  std::span<const Face> faces() const { return {faces_.data(), face_count_}; }  // some without any side

 private:
  struct Mark {
    std::uint32_t stamp, name;
  };
  void clear() { corner_count_ = side_count_ = face_count_ = 0; }
  void begin_walk(const shapes::Polyhedron& p);
  std::uint32_t name_of_face(const shapes::Polyhedron& p, std::uint32_t face);
  void close(std::uint32_t kept, std::uint32_t crossings, const Vec3d& normal, bool of_other);
  template <class Into, class FaceOf>
  void cut_by(const shapes::Polyhedron& p, double down, Except except, bool of_other, Into&& into, FaceOf&& face_of);

  ScratchList<Vec3d> corners_;
  ScratchList<Side> sides_, crossed_;
  ScratchList<Face> faces_;
  ScratchList<double> height_;
  ScratchList<std::uint32_t> kept_as_, queue_, near_;
  struct Crossing {
    std::uint32_t leaves, enters;  // faces
  };
  ScratchList<Crossing> crossings_;
  std::size_t corner_count_ = 0, side_count_ = 0, face_count_ = 0;
  std::vector<Mark> vertices_, faces_of_walk_;  // what they are here, where the stamp is the last walk's
  std::uint32_t stamp_ = 0;
  Form form_ = Form::general;
  double depth_ = 0;
  // Of cut_by: corners in the frame of the planes, the planes in that of the body.
  ScratchList<kernels::OverlapRow> seen_;
  ScratchList<double> planes_;
};

// What lies in both, in the frame of the pair's self; empty: nothing. Valid until the thread's next call.
const OverlapBody& overlap_body(const PolyhedronPair& pair);
// The same where self reaches under a face of other with a vertex that lies farthest below it.
const OverlapBody& overlap_under_face(const PolyhedronPair& pair, std::uint32_t face, std::uint32_t vertex);
// The same where two edges pass through each other, by `depth` along n, from self to other.
const OverlapBody& overlap_of_edges(const PolyhedronPair& pair, const EdgesMeeting& meeting, std::uint32_t edge_of_self,
                                    std::uint32_t edge_of_other, const Vec3d& n, double depth);
// What lies of p, scaled, in the half space.
const OverlapBody& overlap_body(const shapes::Polyhedron& p, double scale, const HalfSpace& keep);

}  // namespace contact
