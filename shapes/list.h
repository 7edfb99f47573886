// The list of shapes: the only place that names them all. Dispatch tables, scene keywords, catalogues and property
// tests are derived from it. Outside the program a shape is known by its name, never by its position here.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <type_traits>
#include <utility>

#include "shapes/compound.h"
#include "shapes/disc.h"
#include "shapes/ellipse.h"
#include "shapes/ellipsoid.h"
#include "shapes/line.h"
#include "shapes/mesh.h"
#include "shapes/plane.h"
#include "shapes/polygon.h"
#include "shapes/polyhedron.h"
#include "shapes/potential_particle.h"
#include "shapes/rounded_polyhedron.h"
#include "shapes/sphere.h"

namespace shapes {

// Bodies first, walls last; pairs of kinds are stated in this order.
using List = std::tuple<Sphere, Ellipsoid, Polyhedron, RoundedPolyhedron, PotentialParticle, Compound, Disc, Ellipse,
                        Polygon, Plane, Mesh, Line>;
inline constexpr std::size_t kind_count = std::tuple_size_v<List>;

enum class Kind : std::uint8_t {
  sphere,
  ellipsoid,
  polyhedron,
  rounded_polyhedron,
  potential_particle,
  compound,
  disc,
  ellipse,
  polygon,
  plane,
  mesh,
  line
};

template <class S>
constexpr Kind kind_of() {
  constexpr auto position = []<std::size_t... I>(std::index_sequence<I...>) {
    std::size_t found = kind_count;
    ((std::is_same_v<S, std::tuple_element_t<I, List>> ? void(found = I) : void()), ...);
    return found;
  };
  return static_cast<Kind>(position(std::make_index_sequence<kind_count>{}));
}
static_assert(kind_of<Sphere>() == Kind::sphere && kind_of<Disc>() == Kind::disc && kind_of<Plane>() == Kind::plane &&
              kind_of<Line>() == Kind::line);

constexpr const char* name_of(Kind k) {
  constexpr auto names = []<class... S>(std::tuple<S...>*) {
    return std::array<const char*, sizeof...(S)>{S::name...};
  }(static_cast<List*>(nullptr));
  return names[static_cast<std::size_t>(k)];
}

constexpr bool is_wall(Kind k) { return k >= Kind::plane; }
// Kinds of two-dimensional scenes live in the plane z = 0; the two never meet.
constexpr int dimension_of(Kind k) { return (k >= Kind::disc && k <= Kind::polygon) || k == Kind::line ? 2 : 3; }

}  // namespace shapes
