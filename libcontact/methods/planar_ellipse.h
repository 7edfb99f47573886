// Two ellipses by Newton's method on one angle: (3) of planar.h. Inner header.
#pragma once

#include "libcontact/contact.h"
#include "libcontact/kernels/ellipse_search.h"
#include "libcontact/methods/method.h"

namespace contact {

Contact ellipse_pair(const Placed<shapes::Ellipse>& a, const Placed<shapes::Ellipse>& b, const Vec3d& offset,
                     const Options& options);

// The answer of a pair that is solved; lengths in units of `up`, d the offset in them.
inline Contact ellipse_contact(const EllipseAnswer<double>& r, const Vec3d& d, double up) {
  const auto in_space = [](const Flat<double>& v) { return Vec3d{v.x, v.y, 0}; };
  return smooth_contact(r.gap, r.lower, r.upper, in_space(r.normal), in_space(r.inner_a), d - in_space(r.inner_b), up,
                        static_cast<int>(r.iterations));
}

}  // namespace contact
