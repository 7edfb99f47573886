// Newton's method for the greatest support separation, in double or 50 digits: on the sphere, or on the circle about an
// axis.
#pragma once

#include "tests/reference/core.h"

namespace reference {

// A core, or one of its corners alone.
template <class T>
struct Piece {
  const Core<T>* core;
  const shapes::Vec3<T>* corner = nullptr;
};

// From n uphill to a stationary point of n·d − h_A(n) − h_B(−n), cores alone; `axis` not null: n stays across it.
template <class T>
shapes::Vec3<T> climb(const Piece<T>& a, const Piece<T>& b, const shapes::Vec3<T>& d, shapes::Vec3<T> n,
                      const shapes::Vec3<T>* axis);

}  // namespace reference
