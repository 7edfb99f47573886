#include "libdem/parts.h"

#include "libcontact/methods/point_polyhedron.h"
#include "libcontact/scale.h"
#include "libdem/law_map.h"
#include "shapes/geometry.h"

namespace dem {

shapes::Kind kind_of(shapes::Compound::PartKind kind) {
  switch (kind) {
    case shapes::Compound::PartKind::sphere:
      return shapes::Kind::sphere;
    case shapes::Compound::PartKind::ellipsoid:
      return shapes::Kind::ellipsoid;
    case shapes::Compound::PartKind::polyhedron:
      break;
  }
  return shapes::Kind::polyhedron;
}

shapes::Kind part_kind(const World& world, std::size_t i, std::uint32_t part) {
  const shapes::Compound* c = compound_of(world, i);
  return c == nullptr ? world.particles.kind[i] : kind_of(c->parts[part].kind);
}

double part_radius(const World& world, std::size_t i, std::uint32_t part) {
  const shapes::Compound* c = compound_of(world, i);
  if (c == nullptr) return law_radius(world, i);
  if (c->parts[part].kind == shapes::Compound::PartKind::polyhedron)
    return law_radius(world, shapes::Kind::polyhedron, {}, world.particles.motion[i].equivalent_radius);
  return c->parts[part].equivalent_radius * world.particles.size[i].x;
}

PartBody part_body(const World& world, std::size_t i, std::uint32_t part, const Mat3d& rotation) {
  const ShapeEntry& shape = world.shapes[world.particles.shape[i]];
  const Vec3d& size = world.particles.size[i];
  PartBody out{{}, {}, part_radius(world, i, part)};
  if (shape.compound == nullptr) {
    out.body.kind = shape.kind;
    out.body.geometry = shape.geometry();
    out.body.size = size;
    out.body.rotation = rotation;
    return out;
  }
  const shapes::Compound::Part& p = shape.compound->parts[part];
  out.body.kind = kind_of(p.kind);
  out.body.geometry = p.solid.get();
  out.body.size = p.size * size.x;
  out.body.rotation = p.kind == shapes::Compound::PartKind::ellipsoid ? rotation * p.rotation : rotation;
  out.centre = rotation * (p.centre * size.x);
  return out;
}

PartBall part_ball(const World& world, std::size_t i, std::uint32_t part, const Mat3d& rotation) {
  const shapes::Compound* c = compound_of(world, i);
  if (c == nullptr) return {{}, world.particles.motion[i].bounding_radius};
  const double scale = world.particles.size[i].x;
  return {rotation * (c->parts[part].centre * scale), c->parts[part].bounding_radius * scale};
}

double part_extent(const contact::Body& part, const Vec3d& n) {
  if (part.kind == shapes::Kind::sphere) return part.size.x;
  const Vec3d m = transposed_times(part.rotation, n);
  if (part.kind == shapes::Kind::ellipsoid) return norm(scaled(part.size, m));
  if (part.kind == shapes::Kind::potential_particle)
    return part.size.x * dot(m, shapes::support(*static_cast<const shapes::PotentialParticle*>(part.geometry), m));
  const double rounding = part.kind == shapes::Kind::rounded_polyhedron ? part.size.y : 0;
  return part.size.x * dot(m, shapes::support(*static_cast<const shapes::Polyhedron*>(part.geometry), m)) + rounding;
}

double part_distance(const shapes::Compound::Part& part, const Vec3d& x) {
  if (part.kind != shapes::Compound::PartKind::polyhedron) return shapes::distance(part, x);
  const Vec3d local = x - part.centre;
  const double size = part.bounding_radius + shapes::max_abs(local);
  const contact::Scale unit = contact::scale_of(size);
  return contact::surface_point(*part.solid, unit.down, unit.down * local, unit.down * size).distance * unit.up;
}

}  // namespace dem
