#include "libcontact/dispatch.h"

#include <algorithm>

#include "libcontact/extend.h"
#include "libcontact/methods/list.h"

namespace contact {

namespace {

using shapes::Kind;

using Library = Dispatch<shapes::List, Methods>;

bool geometry_is_there(const Body& b) {
  if (b.kind == Kind::polyhedron || b.kind == Kind::rounded_polyhedron || b.kind == Kind::potential_particle ||
      b.kind == Kind::polygon)
    return b.geometry != nullptr;
  if (b.kind == Kind::mesh)
    return b.geometry != nullptr && b.part < static_cast<const shapes::Mesh*>(b.geometry)->facets.size();
  return true;
}

}  // namespace

double circumradius(const Body& b) {
  switch (b.kind) {
    case Kind::sphere:
    case Kind::disc:
      return b.size.x;
    case Kind::ellipsoid:
      return max_abs(b.size);
    case Kind::ellipse:
      return std::max(b.size.x, b.size.y);
    case Kind::polyhedron:
      return b.size.x * static_cast<const shapes::Polyhedron*>(b.geometry)->circumradius;
    case Kind::rounded_polyhedron:
      return b.size.x * static_cast<const shapes::Polyhedron*>(b.geometry)->circumradius + b.size.y;
    case Kind::potential_particle:
      return b.size.x * static_cast<const shapes::PotentialParticle*>(b.geometry)->circumradius;
    case Kind::polygon:
      return b.size.x * static_cast<const shapes::Polygon*>(b.geometry)->circumradius;
    case Kind::mesh: {
      double radius = 0;
      for (const Vec3d& v : static_cast<const shapes::Mesh*>(b.geometry)->vertices) radius = std::max(radius, norm(v));
      return b.size.x * radius;
    }
    default:
      return 0;
  }
}

const MethodInfo* methods_begin() { return Library::begin(); }
const MethodInfo* methods_end() { return Library::end(); }

const MethodInfo* choose(Kind a, Kind b, std::string_view method, double tolerance) {
  return Library::choose(a, b, method, tolerance);
}
ChunkQuery find(Kind a, Kind b, std::string_view method, double tolerance) {
  return Library::find(a, b, method, tolerance);
}
ChunkQuery find_own_measure(Kind a, Kind b, std::string_view method) { return Library::find_own_measure(a, b, method); }

Contact query(const Body& a, const Body& b, const Vec3d& offset, const Options& options, std::string_view method) {
  if (!geometry_is_there(a) || !geometry_is_there(b)) return refused();
  return Library::query(a, b, offset, options, method);
}

}  // namespace contact
