// A convex body as a core and a ball about each of its points, over any scalar: what a search for directions needs.
//
//   h(n) = n·x(n) + ball |n|,   x(n) the farthest point of the core along n                                     (1)
//
// Forms of cores: corners (points, polygons, polyhedra), an ellipsoid or ellipse, a potential particle.
#pragma once

#include <utility>
#include <vector>

#include "tests/reference/body.h"

namespace reference {

template <class T>
struct Core {
  enum class Form { corners, round, potential };
  Form form = Form::corners;
  bool planar = false;
  T ball{};                              // radius of the ball
  T least_radius{};                      // the core itself is a convex body plus a ball of this radius
  std::vector<shapes::Vec3<T>> corners;  // world axes, from the body's origin
  std::vector<Vec3d> rounded_corners;    // the same in double: what cannot support is told by them
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
  std::vector<std::vector<std::uint32_t>> loops;  // faces; of a polygon its edges
  std::vector<shapes::Vec3<T>> normals;           // of the loops, as stored
  shapes::Vec3<T> axes{};
  shapes::Mat3<T> turn{};
  const shapes::PotentialParticle* potential = nullptr;
  T scale{};

  // Lengths are multiplied by `unit`, a power of two.
  Core(const Body& body, double unit);
  bool has_corners() const { return form == Form::corners; }
  shapes::Vec3<T> support(const shapes::Vec3<T>& n) const;
  // Support point and second derivative of the support function of a smooth core at a unit n.
  void at(const shapes::Vec3<T>& n, shapes::Vec3<T>& point, shapes::Mat3<T>& hessian) const;
};

extern template struct Core<double>;
extern template struct Core<Real>;

}  // namespace reference
