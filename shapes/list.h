// The list of shapes: the only place that names them all. Dispatch tables, scene keywords, catalogues and property
// tests are derived from it. Outside the program a shape is known by its name, never by its position here.
#pragma once

#include <cstddef>
#include <cstdint>
#include <tuple>
#include <type_traits>
#include <utility>

#include "shapes/ellipsoid.h"
#include "shapes/mesh.h"
#include "shapes/plane.h"
#include "shapes/polyhedron.h"
#include "shapes/sphere.h"

namespace shapes {

using List = std::tuple<Sphere, Ellipsoid, Polyhedron, Plane, Mesh>;
inline constexpr std::size_t kind_count = std::tuple_size_v<List>;

enum class Kind : std::uint8_t { sphere, ellipsoid, polyhedron, plane, mesh };

template <class S>
constexpr Kind kind_of() {
  constexpr auto position = []<std::size_t... I>(std::index_sequence<I...>) {
    std::size_t found = kind_count;
    ((std::is_same_v<S, std::tuple_element_t<I, List>> ? void(found = I) : void()), ...);
    return found;
  };
  return static_cast<Kind>(position(std::make_index_sequence<kind_count>{}));
}
static_assert(kind_of<Sphere>() == Kind::sphere && kind_of<Mesh>() == Kind::mesh);

constexpr const char* name_of(Kind k) {
  constexpr const char* names[] = {Sphere::name, Ellipsoid::name, Polyhedron::name, Plane::name, Mesh::name};
  return names[static_cast<std::size_t>(k)];
}

}  // namespace shapes
