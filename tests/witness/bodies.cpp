#include "tests/witness/bodies.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "shapes/geometry.h"

namespace witness {

namespace {

shapes::Mat3<Real> rotation(const Body& b) {
  const Quatd& q = b.orientation;
  return shapes::rotation_matrix(shapes::normalized(shapes::Quat<Real>{q.w, q.x, q.y, q.z}));
}

struct Plane {
  Vector normal;
  Real offset;
};

// The planes of the faces, from their corners alone (Newell's normal), through the innermost corner.
std::vector<Plane> face_planes(const shapes::Polyhedron& p) {
  std::vector<Plane> planes;
  for (const auto& f : p.faces) {
    const auto corner = [&](std::uint32_t k) { return widened(p.vertices[p.face_vertices[f.first + k % f.count]]); };
    Vector n{};
    for (std::uint32_t k = 1; k + 1 < f.count; ++k) n += cross(corner(k) - corner(0), corner(k + 1) - corner(0));
    n = shapes::normalized(n);
    Real offset = dot(n, corner(0));
    for (std::uint32_t k = 1; k < f.count; ++k) offset = std::min(offset, dot(n, corner(k)));
    planes.push_back({n, offset});
  }
  return planes;
}

Vector centre(const Body& body) {
  if (body.type != Type::polyhedron) return {};
  Vector sum{};
  for (const Vec3d& v : body.shape->vertices) sum += widened(v);
  return sum * (Real(1) / static_cast<Real>(body.shape->vertices.size()));
}

// Factor about the centre that brings the surface to x (body frame): above 1 outside.
Real gauge(const Body& body, const Vector& x) {
  const Vector s = widened(body.size);
  switch (body.type) {
    case Type::sphere:
      return norm(x) / s.x;
    case Type::ellipsoid:
      return norm(Vector{x.x / s.x, x.y / s.y, x.z / s.z});
    case Type::box:
      return 2 * max_abs(Vector{x.x / s.x, x.y / s.y, x.z / s.z});
    case Type::polyhedron:
      break;
  }
  const Vector c = centre(body);
  Real g = 0;
  for (const Plane& p : face_planes(*body.shape)) g = std::max(g, dot(p.normal, x - c) / (p.offset - dot(p.normal, c)));
  return g;
}

}  // namespace

Vector widened(const Vec3d& v) { return {v.x, v.y, v.z}; }

contact::Body Body::placed() const {
  contact::Body b;
  b.size = size;
  b.rotation = shapes::rotation_matrix(shapes::normalized(orientation));
  if (type == Type::ellipsoid) b.kind = shapes::Kind::ellipsoid;
  if (shape) {
    b.kind = shapes::Kind::polyhedron;
    b.geometry = shape.get();
    b.size = {1, 1, 1};
  }
  return b;
}

double Body::circumradius() const {
  if (shape) return shape->circumradius;
  return type == Type::sphere ? size.x : max_abs(size);
}

double Body::inscribed_radius() const {
  if (shape) return shape->inscribed_radius;
  return type == Type::sphere ? size.x : std::min({size.x, size.y, size.z});
}

double Pair::size() const { return norm(offset) + a.circumradius() + b.circumradius(); }

Vector support(const Body& body, const Vector& n) {
  const Vector s = widened(body.size);
  if (body.type == Type::sphere) return n * (s.x / norm(n));
  const shapes::Mat3<Real> r = rotation(body);
  const Vector m = transposed_times(r, n);
  switch (body.type) {
    case Type::ellipsoid:
      return r * scaled(s, shapes::normalized(scaled(s, m)));
    case Type::box:
      return r * Vector{std::copysign(s.x / 2, m.x), std::copysign(s.y / 2, m.y), std::copysign(s.z / 2, m.z)};
    default:
      break;
  }
  Vector best = widened(body.shape->vertices[0]);
  for (const Vec3d& v : body.shape->vertices)
    if (dot(m, widened(v)) > dot(m, best)) best = widened(v);
  return r * best;
}

Real separation(const Pair& pair, const Vector& n) {
  const Vector u = n * (1 / norm(n));
  return dot(u, widened(pair.offset) + support(pair.b, -u) - support(pair.a, u));
}

Real clearance(const Body& body, const Vector& x) {
  const Vector y = transposed_times(rotation(body), x), s = widened(body.size);
  switch (body.type) {
    case Type::sphere:
      return s.x - norm(y);
    case Type::ellipsoid:
      return (1 - gauge(body, y)) * std::min({s.x, s.y, s.z});
    case Type::box:
      return std::min({s.x / 2 - std::abs(y.x), s.y / 2 - std::abs(y.y), s.z / 2 - std::abs(y.z)});
    case Type::polyhedron:
      break;
  }
  Real least = std::numeric_limits<Real>::infinity();
  for (const Plane& p : face_planes(*body.shape)) least = std::min(least, p.offset - dot(p.normal, y));
  return least;
}

Vector pulled_in(const Body& body, const Vector& x) {
  const shapes::Mat3<Real> r = rotation(body);
  const Vector y = transposed_times(r, x), c = centre(body);
  const Real g = gauge(body, y);
  return g <= 1 ? x : r * (c + (y - c) * (1 / g));
}

}  // namespace witness
