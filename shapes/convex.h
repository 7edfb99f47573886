// Inner machinery of the polyhedron builders: hull topology, exact mass properties, the canonical assembly.
//
// Everything here works on coordinates that a power of two has brought to unit size: multiplying by a power of two is
// exact, so a body given in other units gives the same bits, scaled, and no square over- or underflows.
// Tests: tests/shapes/hull.cpp, tests/shapes/mass.cpp.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "shapes/polyhedron.h"

namespace shapes::convex {

using Loop = std::vector<std::uint32_t>;  // vertices of a polygon, counter-clockwise from outside

// Points that rounding cannot tell apart. A coordinate of magnitude x carries a rounding of eps/2 · x; the distance of
// a point from a plane through three others adds a dozen of those, and a rotation of the input a few more. 64 eps
// leaves a margin of about four over that, and is nine orders of magnitude below data written with five decimals.
inline constexpr double rounding = 64 * std::numeric_limits<double>::epsilon();

struct Faces {
  std::vector<Vec3d> vertices;      // unit size, every one used by a loop
  std::vector<Loop> loops;          // closed: every directed edge has its reverse in exactly one other loop
  std::vector<std::uint32_t> rank;  // order of the vertices in the finished polyhedron (smallest first)
};

// Exponent k with 2^(k-1) <= x < 2^k, for x > 0.
inline int exponent_above(double x) {
  int k = 0;
  std::frexp(x, &k);
  return k;
}
inline Vec3d times_two_to(const Vec3d& v, int k) {
  return {std::ldexp(v.x, k), std::ldexp(v.y, k), std::ldexp(v.z, k)};
}
inline double largest_coordinate(std::span<const Vec3d> points) {
  double m = 0;
  for (const Vec3d& p : points) m = std::fmax(m, max_abs(p));
  return m;
}
inline bool finite(const Vec3d& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }
// |v| without over- or underflow; the same bits, scaled, for v times a power of two.
inline double safe_norm(const Vec3d& v) {
  const double m = max_abs(v);
  if (!(m > 0)) return m;
  const int k = exponent_above(m);
  return std::ldexp(norm(times_two_to(v, -k)), k);
}
// v/|v| by division (a vector along an axis gives exactly ±1); v must not vanish.
inline Vec3d unit(const Vec3d& v) {
  const Vec3d u = times_two_to(v, -exponent_above(max_abs(v)));
  const double length = norm(u);
  return {u.x / length, u.y / length, u.z / length};
}

// a × b with every component within 1.5 ulp (Kahan's difference of products).
Vec3d accurate_cross(const Vec3d& a, const Vec3d& b);
// Area vector of a polygon: its length is the area, its direction the best outward normal.  [length²]
Vec3d area_vector(std::span<const Vec3d> vertices, std::span<const std::uint32_t> loop);

// Indices of the distinct points (farther apart than tolerance in some coordinate), in lexicographic order of
// coordinates: what follows does not depend on the order in which the points came.
std::vector<std::uint32_t> distinct_points(std::span<const Vec3d> points, double tolerance);
// Faces of the convex hull of distinct points; faces that agree within tolerance are one, points on edges and faces are
// dropped. Loops index `points`. Throws shapes::Error when the points span no volume.
std::vector<Loop> hull_faces(std::span<const Vec3d> points, double tolerance);

// Volume, centre and inertia of the solid that the loops bound.
MassProperties mass_of(std::span<const Vec3d> vertices, std::span<const Loop> loops);

// Centre and principal axes of a body of this size; identity where it stands there already, to round-off.
Pose principal_frame(const MassProperties& mass, double size);

// Spokes, rises and the lookup table, from vertices, faces and edges.
void add_neighbours(Polyhedron& p);

// The finished polyhedron, its lengths multiplied by 2^exponent.
Polyhedron assemble(Faces faces, Frame frame, int exponent);

}  // namespace shapes::convex
