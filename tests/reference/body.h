// A pair of bodies as the reference sees it: rotations are the exact ones of the (rounded) quaternions, sizes and
// offsets are the doubles given. `placed` is what the library is given.
#pragma once

#include <boost/multiprecision/cpp_bin_float.hpp>

#include "libcontact/dispatch.h"
#include "shapes/math/quat.h"

namespace reference {

using Real = boost::multiprecision::cpp_bin_float_50;
using Vector = shapes::Vec3<Real>;
using Matrix = shapes::Mat3<Real>;
using shapes::Kind;
using shapes::Vec3d;

struct Body {
  Kind kind = Kind::sphere;
  Vec3d size{};                    // as contact::Body
  shapes::Quatd orientation{};     // of plane bodies: about z
  const void* geometry = nullptr;  // as contact::Body

  contact::Body placed() const { return {kind, 0, geometry, size, rotation_matrix(normalized(orientation))}; }
  Matrix rotation() const {
    const auto& q = orientation;
    return rotation_matrix(normalized(shapes::Quat<Real>{Real(q.w), Real(q.x), Real(q.y), Real(q.z)}));
  }
  double circumradius() const { return contact::circumradius({kind, 0, geometry, size}); }
};

template <class T>
Vec3d rounded(const shapes::Vec3<T>& v) {
  return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)};
}
inline Vector exact(const Vec3d& v) { return {Real(v.x), Real(v.y), Real(v.z)}; }

// Kinds that the reference answers: convex bodies and half-spaces.
bool known(const Body& body);

}  // namespace reference
