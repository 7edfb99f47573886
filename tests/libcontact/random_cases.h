// Random bodies of every kind, and pairs of them from apart to deep.
#pragma once

#include <cmath>
#include <random>
#include <stdexcept>
#include <vector>

#include "libcontact/dispatch.h"
#include "shapes/math/quat.h"
#include "shapes/math/trig.h"
#include "shapes/mesh_build.h"
#include "shapes/polyhedron_build.h"
#include "tests/shapes/polygon_samples.h"
#include "tests/shapes/potential_samples.h"

namespace random_cases {

using namespace contact;
using shapes::Kind;

struct Draw {
  std::mt19937_64 engine{20240601};
  double uniform(double low, double high) {
    return low + (high - low) * (static_cast<double>(engine() >> 11) * 0x1p-53);
  }
  Vec3d vector() { return {uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)}; }
  Mat3d rotation() {
    for (;;) {
      const Vec3d v = vector();
      const shapes::Quatd q{uniform(-1, 1), v.x, v.y, v.z};
      if (q.w * q.w + dot(v, v) > 0.01) return rotation_matrix(normalized(q));
    }
  }
};

inline const std::vector<shapes::Polyhedron>& solids() {
  static const std::vector<shapes::Polyhedron> list = [] {
    std::vector<shapes::Polyhedron> s{shapes::make_box({1, 1.5, 2}), shapes::make_box({2, 2, 0.125}),
                                      shapes::make_platonic(shapes::Platonic::tetrahedron, 1),
                                      shapes::make_platonic(shapes::Platonic::octahedron, 1),
                                      shapes::make_platonic(shapes::Platonic::icosahedron, 1)};
    return s;
  }();
  return list;
}

using shape_tests::polygons;

// A tent of two slopes and a level part, so that facets, inner edges and open edges all occur.
inline const shapes::Mesh& wall() {
  static const shapes::Mesh mesh = [] {
    const std::vector<Vec3d> v{{-2, -2, -0.5}, {0, -2, 0}, {2, -2, 0}, {-2, 2, -0.5}, {0, 2, 0}, {2, 2, 0}};
    const std::vector<std::uint32_t> t{0, 1, 4, 0, 4, 3, 1, 2, 5, 1, 5, 4};
    return shapes::mesh_from_triangles(v, t);
  }();
  return mesh;
}

inline bool is_flat(Kind k) { return shapes::dimension_of(k) == 2; }
inline Vec3d random_vector(Kind k, Draw& draw) {
  const Vec3d v = draw.vector();
  return is_flat(k) ? Vec3d{v.x, v.y, 0} : v;
}
inline Mat3d random_rotation(Kind k, Draw& draw) {
  if (!is_flat(k)) return draw.rotation();
  const shapes::SineCosine t = shapes::sine_cosine(draw.uniform(-3, 3));
  return {{{t.cosine, -t.sine, 0}, {t.sine, t.cosine, 0}, {0, 0, 1}}};
}

inline Body random_body(Kind kind, Draw& draw) {
  Body b;
  b.kind = kind;
  b.rotation = random_rotation(kind, draw);
  switch (kind) {
    case Kind::sphere:
      b.size = {draw.uniform(0.3, 1.5), 0, 0};
      break;
    case Kind::ellipsoid:
      b.size = {draw.uniform(0.2, 1.5), draw.uniform(0.2, 1.5), draw.uniform(0.2, 1.5)};
      break;
    case Kind::polyhedron:
      b.geometry = &solids()[draw.engine() % solids().size()];
      b.size = {draw.uniform(0.5, 1.5), 0, 0};
      break;
    case Kind::rounded_polyhedron:
      b.geometry = &solids()[draw.engine() % solids().size()];
      b.size = {draw.uniform(0.4, 1.2), draw.uniform(0.05, 0.5), 0};
      break;
    case Kind::potential_particle:
      b.geometry = &shape_tests::potential_particles()[draw.engine() % shape_tests::potential_particles().size()];
      b.size = {draw.uniform(0.4, 1.2), 0, 0};
      break;
    case Kind::disc:
      b.size = {draw.uniform(0.3, 1.5), 0, 0};
      break;
    case Kind::ellipse:
      b.size = {draw.uniform(0.2, 1.5), draw.uniform(0.2, 1.5), 0};
      break;
    case Kind::polygon:
      b.geometry = &polygons()[draw.engine() % polygons().size()];
      b.size = {draw.uniform(0.5, 1.5), 0, 0};
      break;
    case Kind::plane:
    case Kind::line:
      break;
    case Kind::mesh:
      b.geometry = &wall();
      b.size = {draw.uniform(0.5, 1.5), 0, 0};
      b.part = static_cast<std::uint32_t>(draw.engine() % wall().facets.size());
      break;
    default:
      throw std::logic_error("no sample of this kind");
  }
  return b;
}

struct Case {
  Body a, b;
  Vec3d offset;
  double extent() const { return norm(offset) + circumradius(a) + circumradius(b); }
};

inline Case random_case(const MethodInfo& m, Draw& draw) {
  Case c{random_body(m.a, draw), random_body(m.b, draw), {}};
  if (m.b == Kind::plane || m.b == Kind::line)
    c.offset = random_vector(m.b, draw) -
               draw.uniform(-0.2, 1.2) * circumradius(c.a) * c.b.rotation.column(m.b == Kind::line ? 1 : 2);
  else
    c.offset = draw.uniform(0.1, 1.1) * (circumradius(c.a) + circumradius(c.b)) * normalized(random_vector(m.b, draw));
  return c;
}

}  // namespace random_cases
