// Bodies as the witness tests see them, and the plain code that proves things about a pair without the library:
// supports and points of the bodies in long double, from the quaternion and the sizes alone.
#pragma once

#include <memory>
#include <string>

#include "libcontact/dispatch.h"
#include "shapes/math/quat.h"

namespace witness {

using Real = long double;
using Vector = shapes::Vec3<Real>;
using shapes::Quatd;
using shapes::Vec3d;

enum class Type { sphere, ellipsoid, box, polyhedron };

struct Body {
  Type type = Type::sphere;
  Vec3d size{};                                     // radius in x; semi-axes; full extents; polyhedron: unused
  std::shared_ptr<const shapes::Polyhedron> shape;  // box and polyhedron
  Quatd orientation{};

  contact::Body placed() const;  // what the library is given
  double circumradius() const;
  double inscribed_radius() const;
};

struct Pair {
  std::string name;
  Body a, b;
  Vec3d offset{};       // origin of B − origin of A
  double size() const;  // L = |offset| + circumradii
};

Vector widened(const Vec3d& v);
// The body point farthest along n, from the body's origin, world axes.
Vector support(const Body& body, const Vector& n);
// Support separation along n (any length but zero): never above the gap.
Real separation(const Pair& pair, const Vector& n);
// Radius of a ball about x (from the body's origin) that lies in the body; negative when x is outside.
Real clearance(const Body& body, const Vector& x);
// x itself when it is in the body, else the body point on the way from x to the centre.
Vector pulled_in(const Body& body, const Vector& x);

}  // namespace witness
