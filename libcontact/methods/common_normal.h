// Ellipsoids and ellipses by the common normal: the points of both surfaces whose outward normals are n and −n and
// whose join is parallel to n.
//
//   (x_B(−n) − x_A(n)) × n = 0                                                                                 (1)
//   method_overlap = −(x_B − x_A)·n,   method_normal = n,   method_point midway                                 (2)
//
// (1) is the condition that n is a stationary direction of the support separation, so (2) is the true overlap where
// there is one such direction of greatest separation: while it is below the sum of the least radii of curvature.
// Deeper, the direction found from the line of centres may be another one; the bounds say how far that may be off.
//
// Source: H. Ouadfel & L. Rothenburg, Comput. Geotech. 24 (1999) 245, for (1); solved here by Newton's method in the
// tangent plane from the line of centres, without a search from other starts. Validity: any pair; coincident centres
// are handed over. Cost: 0.3–1.2 us. Accuracy: bounds of quadric_pair.h, certified. Tests:
// tests/libcontact/approximate_ellipsoids.cpp, contract.cpp.
#pragma once

#include "libcontact/contact.h"
#include "libcontact/export.h"

namespace contact {

struct CONTACT_API CommonNormal {
  static constexpr const char* name = "common_normal";
  static constexpr int cost_rank = 50;
  static constexpr const char* remark = "points of opposite normals along their join (Ouadfel & Rothenburg 1999)";
  static constexpr bool exact = false, certified = false;  // what it hands over may not be

  static Contact query(const Placed<shapes::Ellipsoid>& a, const Placed<shapes::Ellipsoid>& b, const Vec3d& offset,
                       const Options& options, Cache* cache);
  static Contact query(const Placed<shapes::Ellipse>& a, const Placed<shapes::Ellipse>& b, const Vec3d& offset,
                       const Options& options, Cache* cache);
};

}  // namespace contact
