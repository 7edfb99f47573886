// Convex bodies as gjk_epa and mpr see them, one type for all kinds: a core with a support function, a margin about it,
// and a ball inside. A plane or a line is its normal alone. Bodies of the plane keep z exactly 0; a polygon that is not
// convex is refused.
#pragma once

#include <algorithm>
#include <limits>

#include "libcontact/contact.h"

namespace contact {

struct ConvexBody {
  shapes::Kind kind{};
  const void* geometry = nullptr;  // of polyhedra, rounded or not, potential particles and polygons
  Vec3d axes{};                    // of an ellipsoid or ellipse; of a plane or line the normal
  double scale = 1;                // of the geometry
  double margin = 0;               // the radius of a sphere or disc, whose core is a point, or of the rounding
  double reach = 0;                // radius of a ball about the origin that holds the body; 0 of a wall
  double least = 0;                // what must not vanish beside the extent of the pair
  Mat3d rotation = Mat3d::identity();

  static constexpr std::uint32_t no_vertex = 0xffffffffu;
  bool is_solid() const { return kind == shapes::Kind::polyhedron || kind == shapes::Kind::rounded_polyhedron; }
  bool has_faces() const { return is_solid() || kind == shapes::Kind::polygon; }
  bool is_flat() const { return shapes::dimension_of(kind) == 2; }
  bool has_corners() const {  // of the core: a polytope or a point
    return kind != shapes::Kind::ellipsoid && kind != shapes::Kind::ellipse && kind != shapes::Kind::potential_particle;
  }

  struct Far {
    Vec3d at;  // of the core, from the body's origin
    std::uint32_t vertex = no_vertex;
  };
  // The farthest point of the core along n, which need not be unit. `near`: that along a direction close by, which
  // makes this one cheaper.
  Far support(const Vec3d& n, const Vec3d* near = nullptr) const;
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
inline Mat3d turn(double cosine, double sine) { return {{{cosine, -sine, 0}, {sine, cosine, 0}, {0, 0, 1}}}; }
inline ConvexBody convex_body(const Placed<shapes::Disc>& d) {
  return {.kind = shapes::Kind::disc, .margin = d.radius, .reach = d.radius, .least = d.radius};
}
inline ConvexBody convex_body(const Placed<shapes::Ellipse>& e) {
  return {.kind = shapes::Kind::ellipse,
          .axes = {e.a, e.b, 0},
          .reach = std::max(e.a, e.b),
          .least = e.a > 0 && e.b > 0 ? std::min(e.a, e.b) : 0,
          .rotation = turn(e.cosine, e.sine)};
}
inline ConvexBody convex_body(const Placed<shapes::Polygon>& p) {
  return {.kind = shapes::Kind::polygon,
          .geometry = p.shape,
          .scale = p.scale,
          .reach = p.scale * p.shape->circumradius,
          .least = p.shape->convex ? p.scale : 0,
          .rotation = turn(p.cosine, p.sine)};
}
inline ConvexBody convex_body(const Placed<shapes::Line>& l) {
  return {.kind = shapes::Kind::line, .axes = l.normal, .least = std::numeric_limits<double>::infinity()};
}

// A pair that has a convex body first, and a body or a wall second.
template <class A, class B>
concept ConvexKinds = !shapes::is_wall(shapes::kind_of<A>()) &&
                      shapes::dimension_of(shapes::kind_of<A>()) == shapes::dimension_of(shapes::kind_of<B>()) &&
                      requires(const Placed<A>& a, const Placed<B>& b) {
  convex_body(a);
  convex_body(b);
};

// A search ends in a few steps: both cores are polytopes or points, or one normal answers.
template <class S>
inline constexpr bool is_round = std::is_same_v<S, shapes::Ellipsoid> || std::is_same_v<S, shapes::Ellipse> ||
                                 std::is_same_v<S, shapes::PotentialParticle>;
template <class A, class B>
inline constexpr bool ends_early = shapes::is_wall(shapes::kind_of<B>()) || !(is_round<A> || is_round<B>);

}  // namespace contact
