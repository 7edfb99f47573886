// Ellipses by the chord between the two points where their outlines cross.
//
//   method_point   midpoint of the chord
//   method_normal  across the chord, from A to B
//   method_overlap length that both ellipses cut from the line of that normal through the midpoint               (1)
//   gap            support separation along the same normal                                                    (2)
//
// Needs exactly two crossings. None (apart, or one inside the other), one (tangent), three, four (crossed), and one
// outline are told apart by ellipse_crossings.h; all these are handed over to `planar`, and flagged.
//
// Source: J. M. Ting, M. Khwaja, L. R. Meachum & J. D. Rowell, Int. J. Numer. Anal. Meth. Geomech. 17 (1993) 603; the
// crossings are found in angle form, not from the quartic, whose coefficients lose the fourth power of the aspect
// ratio. Validity: overlaps below both bodies' widths. Cost: 2 us. Accuracy: bounds of quadric_pair.h, certified.
// Tests: tests/libcontact/ellipse_crossings.cpp, approximate_ellipsoids.cpp, contract.cpp.
#pragma once

#include "libcontact/contact.h"
#include "libcontact/export.h"

namespace contact {

struct CONTACT_API IntersectionMidpoint {
  static constexpr const char* name = "intersection_midpoint";
  static constexpr int cost_rank = 60;
  static constexpr const char* remark = "chord of the two crossings (Ting et al. 1993); other counts are handed over";
  static constexpr bool exact = false, certified = false;  // what it hands over may not be

  static Contact query(const Placed<shapes::Ellipse>& a, const Placed<shapes::Ellipse>& b, const Vec3d& offset,
                       const Options& options, Cache* cache);
};

}  // namespace contact
