// Support separation of an ellipsoid from a point or an edge of another body, as a function of the other body's outward
// direction m:  φ(m) = m·(c − p) − |D Qᵀ m|, for the ellipsoid of centre c, semi-axes D, axes Q.
#pragma once

#include "libcontact/contact.h"

namespace contact {

struct EllipsoidAt {
  Vec3d semi_axes, centre;
  Mat3d axes;  // ellipsoid's body frame -> frame of the query

  struct Support {
    double height;  // |D Qᵀ m|
    Vec3d arm;      // from the centre to the support point along +m
  };
  Support support(const Vec3d& m) const {
    const Vec3d u = scaled(semi_axes, transposed_times(axes, m));
    const double h = norm(u);
    return {h, axes * scaled(semi_axes, u * (1 / h))};
  }
  // The ellipsoid's point that is deepest against the outward direction m.
  Vec3d deepest(const Vec3d& m) const { return centre - support(m).arm; }
  double least_axis() const;
  // Smallest radius of curvature, c²/a: the ellipsoid is a convex body plus a ball of this radius.
  double least_curvature_radius() const;
  // max over all unit m of φ(m) for a point p: its signed distance (negative inside), with the m that gives it.
  double point_separation(const Vec3d& p, Vec3d& m) const;
};

// A local maximum of φ over the arc of outward directions that turns from n0 to n1 about e (n0 × n1 along +e), from
// `start` on that arc, by Newton's method in the angle, halving steps that do not climb:
//   dφ/dθ = m'·(c − p − arm),  d²φ/dθ² = −(φ + ρ),  m' = e × m / |e|,  ρ = (|D Qᵀ m'|² − (m'·arm)²)/|D Qᵀ m|      (1)
struct ArcMaximum {
  double value;
  Vec3d m;
  int iterations;
};
ArcMaximum maximise_on_arc(const EllipsoidAt& body, const Vec3d& p, const Vec3d& e, const Vec3d& n0, const Vec3d& n1,
                           const Vec3d& start);

// A local maximum of φ over all directions, by steepest ascent with the curvature along the slope. For deep overlaps,
// where the best direction of a vertex need not be the one that gives its signed distance.
Vec3d ascend(const EllipsoidAt& body, const Vec3d& p, const Vec3d& start);

}  // namespace contact
