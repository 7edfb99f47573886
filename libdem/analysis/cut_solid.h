// A convex solid as the polygons about it, to be cut by planes again and again, and what of it lies in round bodies.
//
//   cut        faces share their corners to the bit, and every cut decides for a corner once on which side it lies, so
//              that pieces on both sides of a plane fit together whatever the rounding
//   volume     of the solid: cones from one of its corners over its faces
//   in a ball  cones from the ball's centre over the faces; over a face at height h the part between its foot and an
//              edge at distance d from it, from s₁ to s₂ along the edge, is                                        (1)
//                h d (s₂ − s₁)/6                      where the edge lies in the ball
//                θ h (3R² − h²)/6 − ψ R³/3            where it does not, |h| < R
//                (±θ − ψ) R³/3                        |h| >= R, the sign of h
//              θ = [atan(s/d)], ψ = [atan(h s/(d √(h² + d² + s²)))] from s₁ to s₂: the solid angle is θ − ψ
//   in a cylinder along w   Σ over faces of ∫w du dv over that part of the face's image that lies in the circle    (2)
//
// (1) and (2) are closed forms without cases that fail: planes may touch the ball, go through its centre, edges too.
// Ellipsoids are balls in coordinates of their own. Accuracy: 1e-14 of the ball or solid; (2) loses digits, down to
// 1e-8, where a face is within 1e-6 of the cylinder's direction without being parallel to it. Cost: 0.1 us an edge.
// Source: the decomposition of J. Strobl, A. Formella & T. Pöschel, J. Comput. Phys. 311 (2016) 158, is one with other
// pieces; (1) is derived in the source. Tests: tests/libdem/analysis_cut_solid.cpp.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "shapes/polyhedron.h"
#include "shapes/polyhedron_build.h"

namespace dem::analysis {

using shapes::Mat3d;
using shapes::Vec3d;

class CutSolid {
 public:
  struct Face {
    Vec3d normal;                // unit, outward
    std::uint32_t first, count;  // its corners, counter-clockwise from outside
  };
  CutSolid() = default;
  // The box between two corners; the body frame of a polyhedron; a prism of height h on a polygon, along `normal`.
  static CutSolid box(const Vec3d& lower, const Vec3d& upper);
  static CutSolid of(const shapes::Polyhedron& p);
  static CutSolid prism(std::span<const Vec3d> loop, const Vec3d& normal, double height);

  // Keeps what has normal·x <= offset, normal unit.
  void cut(const Vec3d& normal, double offset);
  void move(const Vec3d& by);
  bool empty() const { return faces_.empty(); }
  std::span<const Face> faces() const { return faces_; }
  std::span<const Vec3d> corners() const { return corners_; }  // those that several faces share several times
  std::span<const Vec3d> corners(const Face& f) const { return {corners_.data() + f.first, f.count}; }
  double volume() const;

 private:
  void add_face(const Vec3d& normal, std::span<const Vec3d> loop);
  std::vector<Vec3d> corners_;
  std::vector<Face> faces_;
};

// x -> map (x − centre) takes an ellipsoid to the unit ball. `inverse`: of map, `volume_scale`: its |det|.
struct RoundFrame {
  Mat3d map = Mat3d::identity(), inverse = Mat3d::identity();
  Vec3d centre{};
  double volume_scale = 1;
};
RoundFrame round_frame(const Vec3d& centre, const Mat3d& axes, const Vec3d& semi_axes);  // columns of axes: unit

// Volume of the solid's part in the ellipsoid that `frame` makes the unit ball.
double volume_in_ball(const CutSolid& solid, const RoundFrame& frame);
// Volume of the solid's part in the cylinder of a radius about the line through a point, `along` unit.
double volume_in_cylinder(const CutSolid& solid, const Vec3d& point, const Vec3d& along, double radius);

// Signed area and ∫x, ∫y of what the circle of a radius about the origin holds of the triangle (0, from, to).
struct DiscSums {
  double area = 0, x = 0, y = 0;
};
void add_edge_in_disc(double from_x, double from_y, double to_x, double to_y, double radius, DiscSums& sums);

}  // namespace dem::analysis
