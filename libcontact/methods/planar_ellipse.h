// Two ellipses by Newton's method on one angle: (3) of planar.h.
#pragma once

#include "libcontact/contact.h"

namespace contact {

Contact ellipse_pair(const Placed<shapes::Ellipse>& a, const Placed<shapes::Ellipse>& b, const Vec3d& offset,
                     const Options& options);

}  // namespace contact
