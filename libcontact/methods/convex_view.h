// Convex bodies of space as gjk_epa and mpr see them: a support function, a ball inside, and a margin that is added to
// a core. One type for all kinds, so that each method is compiled once.
#pragma once

#include "libcontact/contact.h"
#include "libcontact/methods/vertex_support.h"

namespace contact {

struct ConvexView {
  // Core: a point, an ellipsoid or a polyhedron, about the origin of the view's body, in units along world axes.
  Vec3d axes{};  // of the ellipsoid; zero: a point
  const shapes::Polyhedron* solid = nullptr;
  double scale = 1, margin = 0;
  Mat3d rotation = Mat3d::identity();

  // The farthest point of the core along n, which need not be unit.
  Vec3d support(const Vec3d& n) const {
    const Vec3d m = transposed_times(rotation, n);
    if (solid != nullptr) return rotation * (scale * solid->vertices[highest_vertex(*solid, m).index]);
    const Vec3d u = scaled(axes, m);
    const double square = dot(u, u);
    return square == 0 ? Vec3d{} : rotation * scaled(axes, u * (1 / std::sqrt(square)));  // NaN passes on
  }
  // A ball inside the body.
  Vec3d inner_centre() const { return solid != nullptr ? rotation * (scale * core_ball(*solid).centre) : Vec3d{}; }
  double inner_radius() const {
    const double core =
        solid != nullptr ? scale * core_ball(*solid).radius : std::fmin(axes.x, std::fmin(axes.y, axes.z));
    return core + margin;
  }
};

struct ConvexPair {
  ConvexView a, b;
  Vec3d d;      // origin of b from that of a
  double size;  // |d| + circumradii, units

  struct Corner {  // of the difference K of the cores
    Vec3d at, on_a;
  };
  Corner support(const Vec3d& n) const {
    const Vec3d on_a = a.support(n);
    return {on_a - (d + b.support(-n)), on_a};
  }
  double margins() const { return a.margin + b.margin; }
  Vec3d inside() const { return a.inner_centre() - (d + b.inner_centre()); }  // a point of K
};

// What a method has found, in units.
struct ConvexMeasure {
  bool found = false;  // else the exact method answers
  bool converged = true;
  int iterations = 0;
  Vec3d normal{};
  double upper = 0;  // proven bound of the gap; infinite: none
  double overlap = 0;
  Vec3d point{};
};

using ConvexMethod = ConvexMeasure (*)(const ConvexPair& pair);

// Runs a method on a pair; gap and lower bound are the separation along its normal. From the body that gives the same
// bits in both orders.
template <class A, class B>
Contact by_convex_method(const Placed<A>& a, const Placed<B>& b, const Vec3d& offset, ConvexMethod method);

}  // namespace contact
