// Closed forms: sphere–sphere, sphere–plane, ellipsoid–plane; and sphere–ellipsoid through the nearest surface point.
//
//   sphere–sphere      gap = |d| − (r_A + r_B),   n = d/|d|                                                     (1)
//   sphere–plane       gap = −N·d − r,            n = −N   (N out of the solid, d to a point of the plane)      (2)
//   ellipsoid–plane    gap = −N·d − |D Rᵀ N|,     n = −N                                                        (3)
//   sphere–ellipsoid   gap = n·d − |D Rᵀ n| − r,  −n the outward normal at the point nearest to the sphere's centre (4)
//
// D = diag(semi-axes) and the rotation R stay apart: forming R D² Rᵀ would cost the square of the aspect ratio in
// digits. Validity: every input; (4) inside the ellipsoid too, as the nearest surface point gives the least translation
// there. Coincident centres: spheres take n = z; on an ellipsoid's medial disc the side of the positive smallest axis.
// Cost: about 10 ns for (1)–(2), 25 ns for (3), 150 ns for (4). Accuracy: 16 eps (|d| + circumradii), certified.
// Tests: tests/libcontact/smooth_accuracy.cpp, contract.cpp.
#pragma once

#include "libcontact/contact.h"
#include "libcontact/export.h"

namespace contact {

struct CONTACT_API Analytic {
  static constexpr const char* name = "analytic";
  static constexpr int cost_rank = 0;
  static constexpr const char* remark = "closed form; sphere–ellipsoid by one scalar equation";

  static Contact query(const Placed<shapes::Sphere>& a, const Placed<shapes::Sphere>& b, const Vec3d& offset,
                       const Options& options, Cache* cache);
  static Contact query(const Placed<shapes::Sphere>& a, const Placed<shapes::Ellipsoid>& b, const Vec3d& offset,
                       const Options& options, Cache* cache);
  static Contact query(const Placed<shapes::Sphere>& a, const Placed<shapes::Plane>& b, const Vec3d& offset,
                       const Options& options, Cache* cache);
  static Contact query(const Placed<shapes::Ellipsoid>& a, const Placed<shapes::Plane>& b, const Vec3d& offset,
                       const Options& options, Cache* cache);
};

}  // namespace contact
