// Bodies of the plane as the sections of bodies in space by their plane of symmetry.
#pragma once

#include <algorithm>

#include "libcontact/contact.h"

namespace contact {

inline Placed<shapes::Ellipsoid> in_space(const Placed<shapes::Ellipse>& e) {
  return {{e.a, e.b, std::max(e.a, e.b)}, {{{e.cosine, -e.sine, 0}, {e.sine, e.cosine, 0}, {0, 0, 1}}}};
}

}  // namespace contact
