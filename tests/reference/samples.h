// Random bodies of every kind that the reference knows: round, of corners, thin, in the plane.
#pragma once

#include <cmath>
#include <random>
#include <stdexcept>

#include "shapes/polyhedron_build.h"
#include "tests/reference/body.h"
#include "tests/shapes/polygon_samples.h"
#include "tests/shapes/potential_samples.h"

namespace reference {

class Source {
 public:
  explicit Source(std::uint64_t seed) : engine_(seed) {}
  double uniform(double low, double high) {
    return low + (high - low) * (static_cast<double>(engine_() >> 11) * 0x1p-53);
  }
  Vec3d direction(int dimension = 3) {
    for (;;) {
      const Vec3d v{uniform(-1, 1), uniform(-1, 1), dimension == 2 ? 0 : uniform(-1, 1)};
      if (const double s = dot(v, v); s > 0.01 && s < 1) return normalized(v);
    }
  }
  shapes::Quatd orientation(int dimension) {
    const Vec3d v = dimension == 2 ? Vec3d{0, 0, 1} : direction();
    const double half = uniform(-3, 3);
    return {std::cos(half), std::sin(half) * v.x, std::sin(half) * v.y, std::sin(half) * v.z};
  }
  template <class List>
  const auto& one_of(const List& list) {
    return list[engine_() % list.size()];
  }

 private:
  std::mt19937_64 engine_;
};

inline const std::vector<shapes::Polyhedron>& solids() {
  using enum shapes::Platonic;
  static const std::vector<shapes::Polyhedron> list{
      shapes::make_box({1, 1.5, 2}),         shapes::make_box({2, 2, 0.125}),
      shapes::make_platonic(tetrahedron, 1), shapes::make_platonic(octahedron, 1),
      shapes::make_platonic(icosahedron, 1), shapes::make_prism(7, 0.5, 1.5)};
  return list;
}

using shape_tests::polygons;

inline Body sample(Kind kind, Source& draw) {
  Body b{kind, {draw.uniform(0.3, 1.5), 0, 0}, draw.orientation(shapes::dimension_of(kind)), nullptr};
  switch (kind) {
    case Kind::ellipsoid:
    case Kind::ellipse:
      b.size.y = draw.uniform(0.2, 1.5);
      if (kind == Kind::ellipsoid) b.size.z = draw.uniform(0.2, 1.5);
      break;
    case Kind::rounded_polyhedron:
      b.size.y = draw.uniform(0.05, 0.5);
      b.geometry = &draw.one_of(solids());
      break;
    case Kind::polyhedron:
      b.geometry = &draw.one_of(solids());
      break;
    case Kind::potential_particle:
      b.geometry = &draw.one_of(shape_tests::potential_particles());
      break;
    case Kind::polygon:
      b.geometry = &draw.one_of(polygons());
      break;
    case Kind::plane:
    case Kind::line:
      b.size = {};
      break;
    case Kind::sphere:
    case Kind::disc:
      break;
    default:
      throw std::logic_error("no sample of this kind");
  }
  return b;
}

inline bool half_space(Kind kind) { return kind == Kind::plane || kind == Kind::line; }

// Offset of B, from far to deep.
inline Vec3d sample_offset(const Body& a, const Body& b, Source& draw) {
  const int dimension = shapes::dimension_of(b.kind);
  if (!half_space(b.kind))
    return draw.uniform(0, 1.3) * (a.circumradius() + b.circumradius()) * draw.direction(dimension);
  const Vec3d out = b.placed().rotation.column(b.kind == Kind::line ? 1 : 2);
  return draw.direction(dimension) - draw.uniform(-0.2, 1.2) * a.circumradius() * out;
}

}  // namespace reference
