#include "tests/reference/body.h"

#include <algorithm>

#include "shapes/polygon.h"

namespace reference {

contact::Body Body::placed() const {
  contact::Body b;
  b.kind = kind;
  b.size = size;
  b.geometry = geometry;
  b.rotation = shapes::rotation_matrix(shapes::normalized(orientation));
  return b;
}

double Body::circumradius() const {
  switch (kind) {
    case Kind::sphere:
    case Kind::disc:
      return size.x;
    case Kind::ellipsoid:
      return max_abs(size);
    case Kind::ellipse:
      return std::max(size.x, size.y);
    case Kind::polyhedron:
      return size.x * static_cast<const shapes::Polyhedron*>(geometry)->circumradius;
    case Kind::rounded_polyhedron:
      return size.x * static_cast<const shapes::Polyhedron*>(geometry)->circumradius + size.y;
    case Kind::potential_particle:
      return size.x * static_cast<const shapes::PotentialParticle*>(geometry)->circumradius;
    case Kind::polygon:
      return size.x * static_cast<const shapes::Polygon*>(geometry)->circumradius;
    default:
      return 0;
  }
}

bool known(const Body& body) {
  switch (body.kind) {
    case Kind::polygon:
      return static_cast<const shapes::Polygon*>(body.geometry)->convex;
    case Kind::sphere:
    case Kind::disc:
    case Kind::ellipsoid:
    case Kind::ellipse:
    case Kind::polyhedron:
    case Kind::rounded_polyhedron:
    case Kind::potential_particle:
    case Kind::plane:
    case Kind::line:
      return true;
    default:
      return false;
  }
}

}  // namespace reference
