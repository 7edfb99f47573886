// Corners against corners in 50 digits: the features that a search left, all of them.
#pragma once

#include "tests/reference/core.h"
#include "tests/reference/directions.h"

namespace reference {

// Features whose corners can be support points in a cell.
struct Active {
  std::vector<std::uint32_t> corners, edges, loops;
};
// `side`: 1 for A, −1 for B, whose support points are those along −n.
Active active(const Core<double>& core, const std::vector<Cell>& cells, double side);

// Normals of a face, outward: as stored, and through three corners.
std::vector<Vector> face_normals(const Core<Real>& core, std::uint32_t loop);

// Every axis across two active edges, both ways.
std::vector<Vector> edge_axes(const Core<Real>& a, const Core<Real>& b, const Active& fa, const Active& fb);

// Shortest vector from a point of A to a point of B among the active features; B is displaced by d.
Vector shortest(const Core<Real>& a, const Core<Real>& b, const Vector& d, const Active& fa, const Active& fb);

// Distance of q from the hull of the corners that support along n, in the body's coordinates.
Real to_support_set(const Core<Real>& core, const Active& features, const Vector& n, const Vector& q);

}  // namespace reference
