// Convex bodies as gjk_epa and mpr see them, one type for all kinds: a core with a support function, a margin about it,
// and a ball inside. A plane is its normal alone.
#pragma once

#include <algorithm>
#include <limits>

#include "libcontact/contact.h"

namespace contact {

struct ConvexBody {
  shapes::Kind kind{};
  const void* geometry = nullptr;  // of polyhedra, rounded or not, and potential particles
  Vec3d axes{};                    // of an ellipsoid; of a plane the normal
  double scale = 1;                // of the geometry
  double margin = 0;               // the radius of a sphere, whose core is a point, or of the rounding
  double reach = 0;                // radius of a ball about the origin that holds the body; 0 of a plane
  double least = 0;                // what must not vanish beside the extent of the pair
  Mat3d rotation = Mat3d::identity();

  static constexpr std::uint32_t no_vertex = 0xffffffffu;
  bool is_solid() const { return kind == shapes::Kind::polyhedron || kind == shapes::Kind::rounded_polyhedron; }
  bool has_corners() const { return is_solid() || kind == shapes::Kind::sphere; }  // of the core: a polytope or a point

  struct Far {
    Vec3d at;  // of the core, from the body's origin
    std::uint32_t vertex = no_vertex;
  };
  // The farthest point of the core along n, which need not be unit.
  Far support(const Vec3d& n) const;
  // max of n·x over the core, n unit: not below it, before rounding.
  double height(const Vec3d& n) const;
  // A ball inside the body.
  Vec3d inner_centre() const;
  double inner_radius() const;
};

inline ConvexBody convex_body(const Placed<shapes::Sphere>& s) {
  return {.kind = shapes::Kind::sphere, .margin = s.radius, .reach = s.radius, .least = s.radius};
}
inline ConvexBody convex_body(const Placed<shapes::Ellipsoid>& e) {
  const Vec3d& a = e.semi_axes;
  // Comparisons that a NaN fails: `least` is then not positive.
  const double least = a.x > 0 && a.y > 0 && a.z > 0 ? std::min({a.x, a.y, a.z}) : 0;
  return {.kind = shapes::Kind::ellipsoid, .axes = a, .reach = max_abs(a), .least = least, .rotation = e.rotation};
}
inline ConvexBody convex_body(const Placed<shapes::Polyhedron>& p) {
  return {.kind = shapes::Kind::polyhedron,
          .geometry = p.shape,
          .scale = p.scale,
          .reach = p.scale * p.shape->circumradius,
          .least = p.scale,
          .rotation = p.rotation};
}
inline ConvexBody convex_body(const Placed<shapes::RoundedPolyhedron>& p) {
  ConvexBody b = convex_body(p.core);
  b.kind = shapes::Kind::rounded_polyhedron;
  b.margin = p.radius;
  b.reach += p.radius;
  b.least = p.core.scale > 0 && p.radius > 0 ? std::min(p.core.scale, p.radius) : 0;
  return b;
}
inline ConvexBody convex_body(const Placed<shapes::PotentialParticle>& p) {
  return {.kind = shapes::Kind::potential_particle,
          .geometry = p.shape,
          .scale = p.scale,
          .reach = p.scale * p.shape->circumradius,
          .least = p.scale > 0 ? std::min(p.scale, p.scale * p.shape->inner_radius) : 0,
          .rotation = p.rotation};
}
inline ConvexBody convex_body(const Placed<shapes::Plane>& p) {
  return {.kind = shapes::Kind::plane, .axes = p.normal, .least = std::numeric_limits<double>::infinity()};
}

// A pair that has a convex body first, and a body or a wall second.
template <class A, class B>
concept ConvexKinds = !shapes::is_wall(shapes::kind_of<A>()) &&
                      shapes::dimension_of(shapes::kind_of<A>()) == shapes::dimension_of(shapes::kind_of<B>()) &&
                      requires(const Placed<A>& a, const Placed<B>& b) {
  convex_body(a);
  convex_body(b);
};

// The core is a polytope or a point.
template <class S>
inline constexpr bool ends_in_corners =
    std::is_same_v<S, shapes::Sphere> || std::is_same_v<S, shapes::Polyhedron> ||
    std::is_same_v<S, shapes::RoundedPolyhedron> || std::is_same_v<S, shapes::Plane>;

}  // namespace contact
