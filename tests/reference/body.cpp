#include "tests/reference/body.h"

#include "shapes/polygon.h"

namespace reference {

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
