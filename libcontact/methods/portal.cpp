#include "libcontact/methods/portal.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace contact {
namespace {

constexpr int step_limit = 64;

// Which way the ray from p through the origin passes the edge from u to v: positive on its left, seen from p.
double side(const Vec3d& p, const Corner& u, const Corner& v) { return -dot(cross(u.at, v.at), p); }

Exit apart(const Vec3d& n) {
  Exit exit;
  exit.kind = Exit::apart;
  exit.normal = n;
  return exit;
}

}  // namespace

Exit leave(const DifferencePair& pair, const Vec3d& inside) {
  Exit exit;
  const Vec3d& p = inside;
  const double far = norm(p);
  if (!(far > 0x1p-40 * pair.size)) return exit;
  const Vec3d ray = p * (-1 / far);
  Vec3d u, w;
  tangent_frame(ray, u, w);
  // Three corners around the ray: closer to it where the facets are small.
  const double tilt = pair.self->vertices.size() + pair.other->vertices.size() <= 32 ? 0.8 : 0.5;
  const Vec3d along = tilt * u, back = ray - 0.5 * along, across = (0.75 * tilt) * w;
  Corner v1 = support(pair, ray + along), v2 = support(pair, back + across), v3 = support(pair, back - across);
  const double s12 = side(p, v1, v2), s23 = side(p, v2, v3), s31 = side(p, v3, v1);
  int steps = 0;
  if (!(s12 > 0 && s23 > 0 && s31 > 0)) {
    // The ray passes outside one edge: from there the triangle turns about the ray until it holds it.
    if (s23 < s12 && s23 <= s31)
      v1 = v3;
    else if (s31 < s12)
      v2 = v3;
    Vec3d n = cross(v1.at - p, v2.at - p);
    if (dot(n, p) > 0) {
      std::swap(v1, v2);
      n = -n;
    }
    for (;; ++steps) {
      if (steps > step_limit) return exit;
      v3 = support(pair, n);
      if (!(dot(v3.at, n) > 0)) return apart(n);
      if (side(p, v1, v3) > 0) {
        v2 = v3;
        n = cross(v1.at - p, v3.at - p);
      } else if (side(p, v3, v2) > 0) {
        v1 = v3;
        n = cross(v3.at - p, v2.at - p);
      } else {
        break;
      }
    }
  }
  // Counter-clockwise about the ray from here on.
  const double least = 16 * epsilon * pair.size;
  for (;; ++steps) {
    if (steps > step_limit) return exit;
    exit.face = facet_of(pair, v1, v2, v3);
    if (exit.face.kind != DifferenceFacet::none && prove_nearest(pair, exit.face, exit.axis) == Nearest::proven) {
      exit.kind = Exit::nearest;
      return exit;
    }
    const Vec3d n = cross(v2.at - v1.at, v3.at - v1.at);
    const Corner v4 = support(pair, n);
    if (!(dot(v4.at, n) > 0)) return apart(n);
    const double gain = dot(v4.at - v1.at, n);
    if (!(gain > 0 && gain * gain > least * least * dot(n, n))) {
      exit.kind = Exit::facet;
      exit.normal = n;
      exit.corner[0] = v1, exit.corner[1] = v2, exit.corner[2] = v3;
      return exit;
    }
    // Of the three triangles at v4 the one that the ray passes through.
    const Vec3d c = cross(v4.at, p);
    if (dot(v1.at, c) > 0)
      (dot(v2.at, c) > 0 ? v1 : v3) = v4;
    else
      (dot(v3.at, c) > 0 ? v2 : v1) = v4;
  }
}

}  // namespace contact
