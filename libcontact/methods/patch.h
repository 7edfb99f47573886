// The overlap of a polyhedron with a plane (or with what lies behind a flat polygon), seen along the plane's normal and
// weighted by its local depth h: the moments that make a contact patch.
//
//   w = ∫h dA,  centre c = ∫x h dA / w,  spread = ∫(x−c)(x−c)ᵀ h dA / w  (in the plane)                       (1)
//   centre height = −½ ∫h² dA / w: midway, on depth-weighted average, between the plane and the body's surface  (2)
//
// Every integral is exact (h is linear over each clipped polygon). Weights go to zero with h, so a point that enters or
// leaves the patch moves nothing at once.
#pragma once

#include <cstddef>

#include "libcontact/contact.h"

namespace contact {

// A point of the body's surface over the plane: in-plane coordinates and depth below the plane.
struct DepthPoint {
  double u, v, h;
};

struct DepthMoments {
  double h = 0, hh = 0, hu = 0, hv = 0, huu = 0, hvv = 0, huv = 0;  // ∫ of the named product over the patch
  DepthPoint deepest{0, 0, -1};
  void add(const DepthPoint* polygon, std::size_t count);  // convex, counter-clockwise or clockwise, h >= 0
  // The triangle of (0, 0) at depth d and two points at depth 0; counted where it is counter-clockwise.
  void add_corner(double d, const DepthPoint& p, const DepthPoint& q) {
    const double area = 0.5 * (p.u * q.v - p.v * q.u);
    if (!(area > 0)) return;
    const double t = area * d, t3 = t / 3, t12 = t / 12, t60 = t / 60;
    h += t3;
    hh += t3 * (0.5 * d);
    hu += t12 * (p.u + q.u);
    hv += t12 * (p.v + q.v);
    huu += 2 * t60 * (p.u * p.u + q.u * q.u + p.u * q.u);
    hvv += 2 * t60 * (p.v * p.v + q.v * q.v + p.v * q.v);
    huv += t60 * (2 * (p.u * p.v + q.u * q.v) + p.u * q.v + q.u * p.v);
  }
};

// Sutherland–Hodgman step: the part of a convex polygon with cu·u + cv·v + ch·h + c >= 0. `out` has room for count + 1.
std::size_t clip(const DepthPoint* in, std::size_t count, double cu, double cv, double ch, double c, DepthPoint* out);

// Largest polygon that is clipped as a whole; larger ones are cut into a fan of triangles.
inline constexpr std::size_t polygon_cap = 64;

// Affine map from a polyhedron's geometry to the plane: u = scale·(U·x) + u0, …, depth h = h0 − scale·(N·x), N the
// plane's unit normal towards the polyhedron; all directions in the polyhedron's body frame.
struct DepthMap {
  Vec3d u_axis, v_axis, normal;
  double scale, u0, v0, h0;
  DepthPoint operator()(const Vec3d& x) const {
    return {scale * dot(u_axis, x) + u0, scale * dot(v_axis, x) + v0, h0 - scale * dot(normal, x)};
  }
};

// Calls visit(polygon, count) for the part of a face with h > 0, when it looks at the plane; count <= polygon_cap + 1.
// depth_of(i) is the depth of vertex i.
template <class Depth, class Visit>
void visit_submerged(const shapes::Polyhedron& p, const shapes::Polyhedron::Face& face, const DepthMap& map,
                     Depth&& depth_of, Visit&& visit) {
  if (dot(face.normal, map.normal) >= 0) return;
  const std::uint32_t* loop = p.face_vertices.data() + face.first;
  bool below = false, above = false;
  for (std::size_t k = 0; k < face.count; ++k) (depth_of(loop[k]) > 0 ? below : above) = true;
  if (!below) return;
  DepthPoint polygon[polygon_cap], clipped[polygon_cap + 1];
  const auto emit = [&](std::size_t count) {
    if (!above) return visit(static_cast<const DepthPoint*>(polygon), count);
    const std::size_t kept = clip(polygon, count, 0, 0, 1, 0, clipped);
    if (kept >= 3) visit(static_cast<const DepthPoint*>(clipped), kept);
  };
  if (face.count <= polygon_cap) {
    for (std::size_t k = 0; k < face.count; ++k) polygon[k] = map(p.vertices[loop[k]]);
    emit(face.count);
  } else {
    polygon[0] = map(p.vertices[loop[0]]);
    for (std::size_t k = 1; k + 1 < face.count; ++k) {
      polygon[1] = map(p.vertices[loop[k]]);
      polygon[2] = map(p.vertices[loop[k + 1]]);
      emit(3);
    }
  }
}

// The same for every face.
template <class Visit>
void for_each_submerged(const shapes::Polyhedron& p, const DepthMap& map, Visit&& visit) {
  constexpr std::size_t cap = 256;
  double height[cap];
  const std::size_t known = p.vx.size() <= cap ? p.vertices.size() : 0;
  for (std::size_t i = 0; i < known; ++i)
    height[i] = map.h0 - map.scale * (map.normal.x * p.vx[i] + map.normal.y * p.vy[i] + map.normal.z * p.vz[i]);
  const auto depth_of = [&](std::uint32_t i) {
    return known ? height[i] : map.h0 - map.scale * dot(map.normal, p.vertices[i]);
  };
  for (const auto& face : p.faces) visit_submerged(p, face, map, depth_of, visit);
}

// Plane of a patch: origin on it, orthonormal axes, u × v = normal; in any frame.
struct PlaneFrame {
  Vec3d origin, u, v, normal;
  Vec3d operator()(double a, double b, double height) const { return origin + a * u + b * v + height * normal; }
};

// Centre and spread (1)–(2) in the frame of `plane`, lengths in its unit. False when the moments vanish.
bool make_patch(const DepthMoments& moments, const PlaneFrame& plane, Patch& patch);

// The same after x -> rotation·x.
Patch rotated(const Patch& patch, const Mat3d& rotation);
inline OverlapDepth rotated(OverlapDepth d, const Mat3d& rotation) {
  d.normal = rotation * d.normal;
  d.point = rotation * d.point;
  return d;
}

}  // namespace contact
