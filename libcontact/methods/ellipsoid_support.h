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
  // The m of the largest φ over those perpendicular to e.
  Vec3d edge_maximum(const Vec3d& p, const Vec3d& e) const;
};

// The local maxima of φ over all directions (`maxima_of_point`) or over those perpendicular to e (`maxima_of_edge`),
// largest first: one, or two where p lies near the medial disc, never more (point_ellipsoid.h). The second problem is
// that of a point and an ellipse, the shadow of the ellipsoid along e. Exact at any depth. Cost: 0.1 us each.
int maxima_of_point(const EllipsoidAt& body, const Vec3d& p, Vec3d m[2]);
int maxima_of_edge(const EllipsoidAt& body, const Vec3d& p, const Vec3d& e, Vec3d m[2]);

}  // namespace contact
