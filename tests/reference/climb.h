// Newton's method for the greatest support separation, in 50 digits: on the sphere, or on the circle about an axis.
#pragma once

#include "tests/reference/core.h"

namespace reference {

// A core, or one of its corners alone.
struct Piece {
  const Core<Real>* core;
  const Vector* corner = nullptr;
};

// From n uphill to a stationary point of n·d − h_A(n) − h_B(−n), cores alone; `axis` not null: n stays across it.
Vector climb(const Piece& a, const Piece& b, const Vector& d, Vector n, const Vector* axis);

}  // namespace reference
