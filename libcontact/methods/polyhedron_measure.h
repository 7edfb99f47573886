// What the approximate methods of polyhedra share: the pair in units in the frame of the first body, and the answer
// along the normal that they find.
//
//   gap >= f(n) = min over b of n·x − max over a of n·x                                                        (1)
//   gap <= −(depth of x in a + depth of x in b)     any point x inside both                                     (2)
//   gap <= |c_b − c_a| − r_a − r_b                  balls inside the bodies                                     (3)
#pragma once

#include "libcontact/methods/polyhedron_pair.h"

namespace contact {

struct PlacedPolyhedra {
  PolyhedronPair pair;
  double size;  // L, units
};

// In units of `up`; size 0 when out of range.
PlacedPolyhedra placed_polyhedra(const Placed<shapes::Polyhedron>& a, const Placed<shapes::Polyhedron>& b,
                                 const Vec3d& offset, double& up);

// In units, in the frame of the first body.
struct PolyhedronMeasure {
  bool found = false;  // else `sat` answers
  bool converged = true;
  int iterations = 0;
  double overlap = 0;
  Vec3d normal{}, point{};  // the point counts for (2) where it is inside both
};

// Least of offset − normal·x over the faces: the depth of x inside, negative outside; x in the body's frame, units.
double depth_in(const shapes::Polyhedron& p, double scale, const Vec3d& x);

using PolyhedronMethod = PolyhedronMeasure (*)(const PlacedPolyhedra& placed);

// Runs a method from the body that gives the same bits in both orders.
Contact by_polyhedron_method(const Placed<shapes::Polyhedron>& a, const Placed<shapes::Polyhedron>& b,
                             const Vec3d& offset, PolyhedronMethod method);

}  // namespace contact
