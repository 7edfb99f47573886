// A shape behind the C door: one geometry of a kind that needs one.
#pragma once

#include <variant>

#include "shapes/list.h"

struct contact_shape {
  std::variant<shapes::Polyhedron, shapes::Polygon, shapes::Mesh, shapes::PotentialParticle> geometry;

  // The geometry for bodies of this kind; null when it is of another.
  const void* for_kind(shapes::Kind kind) const {
    switch (kind) {
      case shapes::Kind::polyhedron:
      case shapes::Kind::rounded_polyhedron:
        return std::get_if<shapes::Polyhedron>(&geometry);
      case shapes::Kind::polygon:
        return std::get_if<shapes::Polygon>(&geometry);
      case shapes::Kind::mesh:
        return std::get_if<shapes::Mesh>(&geometry);
      case shapes::Kind::potential_particle:
        return std::get_if<shapes::PotentialParticle>(&geometry);
      default:
        return nullptr;
    }
  }
};
