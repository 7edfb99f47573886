// Distance of two polyhedra that do not overlap: GJK finds the neighbourhood, closed forms on the features that lie
// against the supporting planes give the answer.
//
// With the closest distance between U (points found) and β − α (supporting planes along n), a closest point of A lies
// in n·x >= α − (U − (β − α)), one of B likewise: only features with a vertex there are compared. This is a proof, so
// the answer is exact to rounding even where GJK ends early. Source: Gilbert, Johnson & Keerthi, IEEE J. Robot. Autom.
// 4 (1988) 193. Cost: 0.5–1.5 us for bodies of 8 to 200 vertices. Tests: tests/libcontact/poly_sat.cpp.
#pragma once

#include "libcontact/methods/polyhedron_pair.h"

namespace contact {

struct PolyhedronDistance {
  double lower, upper;  // of the distance, before any allowance for rounding
  Vec3d normal;         // unit, self to other: its support separation is `lower`
  Vec3d on_self, on_other;
  int iterations;
  Separation at;  // along the normal
};

// `normal` is any unit direction with a support separation of about 0 or more, which is `at`; all in the frame and unit
// of `pair`, whose size is `size`.
PolyhedronDistance polyhedron_distance(const PolyhedronPair& pair, const Vec3d& normal, const Separation& at,
                                       double size);

}  // namespace contact
