// Inner faces of a body of polyhedra, and where its parts meet: inner machinery of make_compound.
#pragma once

#include <vector>

#include "shapes/compound_parts.h"

namespace shapes::compound {

// Grows every polyhedron through the faces that lie inside the body, as far as it stays convex and in the body.
void grow_through_inner_faces(std::vector<Part>& parts);
// By (a, b), in the body frame, at unit size.
std::vector<Compound::Joint> joints_of(const std::vector<Compound::Part>& parts);

}  // namespace shapes::compound
