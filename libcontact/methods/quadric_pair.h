// What the approximate methods of ellipsoids share: the pair in units, and what one direction and one point prove.
//
//   f(n) = n·d − h_A(n) − h_B(−n) <= gap                      any unit n; h the support heights                (1)
//   gap <= √((m + f)² + r²) − m         where m + f > 0, r the tangential part of d − x_A + x_B at n           (2)
//   gap <= σ_A(x) + σ_B(x)              any point x; σ >= signed distance to the surface, negative inside:     (3)
//          σ = −(1 − q) c inside, |y| (1 − 1/q) outside, q = |D⁻¹ Rᵀ y|, y = x − centre, c the least semi-axis
//
// (2): m is the sum of the least radii of curvature c²/a; both bodies are balls of these radii rolled in smaller convex
// bodies (Blaschke), which f + m > 0 keeps apart, and whose support points at n are as far apart as the root says.
// (3): the body holds (1 − q) of itself about q of y. Together they bound every pair at any depth, so that an answer is
// certified whatever its direction, though it may be wide. Ellipses are sections of ellipsoids by their plane of
// symmetry; every vector then keeps z = 0 exactly.
//
// Cost: 60 ns. Tests: tests/libcontact/contract.cpp, approximate_ellipsoids.cpp.
#pragma once

#include "libcontact/contact.h"

namespace contact {

struct QuadricPair {
  Vec3d axes_a, axes_b;          // semi-axes, units
  Mat3d rotation_a, rotation_b;  // body -> world
  Vec3d d;                       // centre of B from that of A, units; not zero
  double distance;               // |d|
  double extent;                 // |d| + circumradii, near 1
  bool flat;                     // a pair of ellipses
};

// What a method has found, in units.
struct QuadricMeasure {
  Vec3d normal{};      // of the support separation; unit
  Vec3d own_normal{};  // unit
  Vec3d own_point{};
  double own_overlap = 0;
  int iterations = 0;
  bool found = false;  // else the pair is handed over
  bool converged = true;
};

// The answer along `m.normal`, with bounds (1)–(3), in units of `up`. Refused when the pair is out of range.
Contact along_normal(const QuadricPair& pair, const QuadricMeasure& m, double up);

// q of (3).
inline double quadric_value(const Vec3d& axes, const Mat3d& rotation, const Vec3d& y) {
  const Vec3d x = transposed_times(rotation, y);
  return norm(Vec3d{x.x / axes.x, x.y / axes.y, x.z / axes.z});
}
// Outward unit normal of the level surface of q at y; zero at the centre.
Vec3d quadric_normal(const Vec3d& axes, const Mat3d& rotation, const Vec3d& y);

// Runs a method on a pair of ellipsoids or ellipses, from the body that gives the same bits in both orders; hands over
// to the production method when the method finds no direction, or the centres are one.
using QuadricMethod = QuadricMeasure (*)(const QuadricPair& pair);
Contact by_quadric_method(const Placed<shapes::Ellipsoid>& a, const Placed<shapes::Ellipsoid>& b, const Vec3d& offset,
                          const Options& options, QuadricMethod method);
Contact by_quadric_method(const Placed<shapes::Ellipse>& a, const Placed<shapes::Ellipse>& b, const Vec3d& offset,
                          const Options& options, QuadricMethod method);

}  // namespace contact
