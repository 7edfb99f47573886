// The parts of a body while it is being built: inner machinery of make_compound.
//
// Everything stands in the frame of the input, brought to unit size by a power of two.
#pragma once

#include <vector>

#include "shapes/compound.h"

namespace shapes::compound {

struct Part {
  Compound::PartKind kind = Compound::PartKind::sphere;
  Vec3d centre{};
  Mat3d rotation = Mat3d::identity();
  Quatd orientation{};
  Vec3d size{};
  Polyhedron solid;  // polyhedron: in the common frame, as given
};

// max and min of n·x over a part, n unit.
double highest(const Part& part, const Vec3d& n);
inline double lowest(const Part& part, const Vec3d& n) { return -highest(part, -n); }
// A plane proves that two parts do not overlap (they may touch). False when none of those tried does.
bool surely_apart(const Part& a, const Part& b);

struct Moments {  // ∫1, ∫x, ∫x xᵀ over a solid
  double zeroth = 0;
  Vec3d first{}, diagonal{}, mixed{};  // ∫x; ∫xx, yy, zz; ∫yz, zx, xy
  double error = 0;                    // of any of them, absolute: lengths are near 1
  void add(const Moments& m);
};
// Of the union of parts.
Moments moments_of_union(const std::vector<Part>& parts);
MassProperties mass_of(const Moments& m);

// Moments of a union of balls (compound_balls.cpp), and of a union of parts of any kinds (compound_lines.cpp).
Moments moments_of_balls(const std::vector<const Part*>& balls);
Moments moments_by_lines(const std::vector<const Part*>& parts);

}  // namespace shapes::compound
