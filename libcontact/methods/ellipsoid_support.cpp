#include "libcontact/methods/ellipsoid_support.h"

#include <algorithm>
#include <cmath>

#include "libcontact/methods/point_ellipsoid.h"

namespace contact {

double EllipsoidAt::least_axis() const { return std::min({semi_axes.x, semi_axes.y, semi_axes.z}); }

double EllipsoidAt::least_curvature_radius() const {
  const double c = least_axis(), a = std::max({semi_axes.x, semi_axes.y, semi_axes.z});
  return c * (c / a);
}

double EllipsoidAt::point_separation(const Vec3d& p, Vec3d& m) const {
  m = -(axes * nearest_on_ellipsoid(semi_axes, transposed_times(axes, p - centre)).normal);
  return dot(m, centre - p) - support(m).height;
}

int maxima_of_point(const EllipsoidAt& body, const Vec3d& p, Vec3d m[2]) {
  const Vec3d y = transposed_times(body.axes, p - body.centre);
  m[0] = -(body.axes * nearest_on_ellipsoid(body.semi_axes, y).normal);
  EllipsoidFoot second;
  if (!second_foot(body.semi_axes, y, second)) return 1;
  m[1] = -(body.axes * second.normal);
  return 2;
}

namespace {

// The shadow of the ellipsoid along e, and where the point p lies in it.
struct Shadow {
  Vec3d first, second;  // unit directions of its semi-axes, perpendicular to e
  Vec3d semi_axes, at;  // the third one is inert: as long as the longest, with the point on its zero

  Shadow(const EllipsoidAt& body, const Vec3d& p, const Vec3d& e) {
    Vec3d u, v;
    tangent_frame(normalized(e), u, v);
    const Vec3d su = scaled(body.semi_axes, transposed_times(body.axes, u));
    const Vec3d sv = scaled(body.semi_axes, transposed_times(body.axes, v));
    const double uu = dot(su, su), vv = dot(sv, sv), uv = dot(su, sv), half = 0.5 * (uu - vv);
    const double radius = std::sqrt(half * half + uv * uv), greatest = 0.5 * (uu + vv) + radius;
    double x = half >= 0 ? half + radius : uv, y = half >= 0 ? uv : radius - half;
    const double length = std::sqrt(x * x + y * y);
    if (length > 0)
      x /= length, y /= length;
    else
      x = 1, y = 0;
    first = x * u + y * v;
    second = x * v - y * u;
    const double major = std::sqrt(greatest);
    semi_axes = {major, norm(cross(su, sv)) / major, major};
    const Vec3d w = p - body.centre;
    at = {dot(w, first), dot(w, second), 0};
  }
  Vec3d outward(const EllipsoidFoot& foot) const { return -(foot.normal.x * first + foot.normal.y * second); }
};

}  // namespace

int maxima_of_edge(const EllipsoidAt& body, const Vec3d& p, const Vec3d& e, Vec3d m[2]) {
  const Shadow shadow(body, p, e);
  m[0] = shadow.outward(nearest_on_ellipsoid(shadow.semi_axes, shadow.at));
  EllipsoidFoot second;
  if (!second_foot(shadow.semi_axes, shadow.at, second)) return 1;
  m[1] = shadow.outward(second);
  return 2;
}

Vec3d EllipsoidAt::edge_maximum(const Vec3d& p, const Vec3d& e) const {
  const Shadow shadow(*this, p, e);
  return shadow.outward(nearest_on_ellipsoid(shadow.semi_axes, shadow.at));
}

}  // namespace contact
