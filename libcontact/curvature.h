// How curved two bodies are where they touch: principal curvatures of each, the gap between both, one effective radius.
//   ellipsoid, D = diag(semi-axes), n outward in its axes, h = |D n|, (t1, t2, n) a frame, w_i = cof(D) t_i/h
//     matrix of the radii of curvature  ρ11 = w2·w2/h,  ρ22 = w1·w1/h,  ρ12 = −w1·w2/h        [m]     (1)
//     det ρ = (abc)²/h⁴;  curvatures = 1/eigenvalues, the smaller radius from det/larger       [1/m]   (2)
//   gap of two bodies near the point of contact  A x² + B y², A <= B; k11 <= k12 of one, k21 <= k22 of the other,
//   ω the angle between the directions of k11 and k21
//     A + B = (k11 + k12 + k21 + k22)/2                                                        [1/m]   (3)
//     B − A = ½ sqrt((k11 − k12)² + (k21 − k22)² + 2 (k11 − k12)(k21 − k22) cos 2ω)            [1/m]   (4)
//     A B = ¼ [k11 k12 + k21 k22 + (k11 k21 + k12 k22) sin²ω + (k11 k22 + k12 k21) cos²ω]      [1/m²]  (5)
//     R_e = 1/(2 sqrt(A B));  of spheres 1/R_e = 1/R1 + 1/R2                                   [m]     (6)
// A follows from (5)/B: no difference of nearly equal numbers, whatever the aspect ratio.
// Bodies by their outward normal at the point: sphere, ellipsoid, potential particle (of which its own header tells the
// radii) in closed form; plane and mesh facet 0; rounded polyhedron 1/rounding radius everywhere, as on its corners,
// its faces and edges included. Bodies of the plane count as round across it as within it: both curvatures of a disc or
// an ellipse are that of its outline, those of a line 0. Polyhedra, polygons and compounds (their parts do) have none.
//
// Source: (1), (2) second derivatives of the support function h; (3), (4) Johnson, Contact Mechanics (1985), ch. 4.
// Valid for semi-axes within 1e50 of each other (tested to 1e8). Accuracy: 1e-14 relative, of ellipsoids. Cost: 40 ns
// an ellipsoid, 60 ns with a partner. A force 4/3 E* sqrt(R_e) δ^(3/2) whose R_e follows the point of contact is not
// the slope of an energy when the contact rolls over the shape. Test: tests/libcontact/curvature.cpp
#pragma once

#include "libcontact/dispatch.h"

namespace contact {

struct Curvature {
  double least = 0, most = 0;                 // principal curvatures, 1/m; >= 0
  Vec3d least_direction{}, most_direction{};  // unit, world axes, across the normal and each other
};

// Of the body where `outward`, unit, world axes, is its normal. False: it has no curvature there, `out` is left alone.
CONTACT_API bool curvature(const Body& body, const Vec3d& outward, Curvature& out);

struct RelativeCurvature {
  double least = 0, most = 0;  // A and B, 1/m
  double radius_eff = 0;       // R_e, m; infinite when A = 0
};

CONTACT_API RelativeCurvature relative_curvature(const Curvature& a, const Curvature& b);  // (3) to (6)
// Of two bodies that touch, normal from a to b. False: one of them has no curvature, or both are flat.
CONTACT_API bool relative_curvature(const Body& a, const Body& b, const Vec3d& normal, RelativeCurvature& out);

}  // namespace contact
