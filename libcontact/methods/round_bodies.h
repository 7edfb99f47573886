// Strictly convex round bodies as potential.h sees them: support height, support point, radii of curvature. Placed
// about their origin in the axes of the query, lengths in a unit near the pair's.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "libcontact/contact.h"

namespace contact {

using TangentMatrix = shapes::TangentMatrix<double>;

struct BallAt {  // a point when the radius is 0
  double radius;
  struct At {
    double height, excess;  // the height is at most height + excess, before rounding
    Vec3d x;                // from the body's origin
  };
  At at(const Vec3d& n, const At* = nullptr) const { return {radius, 0, radius * n}; }
  TangentMatrix radii(const At&, const Vec3d&, const Vec3d&, const Vec3d&) const { return {radius, 0, radius}; }
  double circumradius() const { return radius; }
  double least_curvature_radius() const { return radius; }
  Vec3d inner_centre() const { return {}; }
  double inner_radius() const { return radius; }
  template <class Use>
  void for_each_normal(Use&&) const {}
};

struct EllipsoidBody {
  Vec3d semi_axes;
  Mat3d rotation;
  struct At {
    double height, excess;
    Vec3d x;
    Vec3d u;  // D Rᵀ n, unit
  };
  At at(const Vec3d& n, const At* = nullptr) const {
    const Vec3d v = scaled(semi_axes, transposed_times(rotation, n));
    const double height = norm(v);
    const Vec3d u = v * (1 / height);
    return {height, 0, rotation * scaled(semi_axes, u), u};
  }
  TangentMatrix radii(const At& s, const Vec3d&, const Vec3d& t1, const Vec3d& t2) const {
    Vec3d p = scaled(semi_axes, transposed_times(rotation, t1)), q = scaled(semi_axes, transposed_times(rotation, t2));
    p -= dot(p, s.u) * s.u;
    q -= dot(q, s.u) * s.u;
    const double inverse = 1 / s.height;
    return {dot(p, p) * inverse, dot(p, q) * inverse, dot(q, q) * inverse};
  }
  double least_axis() const { return std::min({semi_axes.x, semi_axes.y, semi_axes.z}); }
  double circumradius() const { return max_abs(semi_axes); }
  double least_curvature_radius() const { return least_axis() * (least_axis() / max_abs(semi_axes)); }
  Vec3d inner_centre() const { return {}; }
  double inner_radius() const { return least_axis(); }
  template <class Use>
  void for_each_normal(Use&& use) const {
    for (int i = 0; i < 3; ++i) use(rotation.column(i)), use(-rotation.column(i));
  }
};

struct PotentialAt {
  const shapes::PotentialParticle* shape;
  double scale;    // geometry -> units
  Mat3d rotation;  // body -> query
  struct At {
    double height, excess;
    Vec3d x;
    shapes::PotentialSupport<double> own;  // in the geometry's units
  };
  // `near`: an answer for a direction close by, which makes this one cheaper and no different.
  At at(const Vec3d& n, const At* near = nullptr) const {
    const Vec3d m = transposed_times(rotation, n);
    const auto s = shapes::support_from_centre<double>(*shape, m, near != nullptr ? &near->own.from_centre : nullptr);
    const double height =
        s.found ? scale * (s.height + dot(m, shape->centre)) : std::numeric_limits<double>::quiet_NaN();
    return {height, scale * s.excess, rotation * (scale * (s.from_centre + shape->centre)), s};
  }
  TangentMatrix radii(const At& s, const Vec3d& n, const Vec3d& t1, const Vec3d& t2) const {
    const TangentMatrix k = shapes::curvature_radii(s.own, transposed_times(rotation, n),
                                                    transposed_times(rotation, t1), transposed_times(rotation, t2));
    return {scale * k.k11, scale * k.k12, scale * k.k22};
  }
  double circumradius() const { return scale * shape->circumradius; }
  double least_curvature_radius() const { return scale * shape->least_curvature_radius; }
  Vec3d inner_centre() const { return rotation * (scale * shape->centre); }
  double inner_radius() const { return scale * shape->inner_radius; }
  template <class Use>
  void for_each_normal(Use&& use) const {
    for (const auto& plane : shape->planes) use(rotation * plane.normal);
  }
};

}  // namespace contact
