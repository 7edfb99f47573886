#include "libcontact/methods/face_patch.h"

#include <algorithm>

namespace contact {
namespace {

struct PlanePoint {
  double u, v;
};

// Moments of the part of `polygon` over a convex counter-clockwise outline of at most polygon_cap corners.
void add_over(const DepthPoint* polygon, std::size_t count, const PlanePoint* outline, std::size_t corners,
              DepthMoments& moments) {
  DepthPoint buffer[2][2 * polygon_cap + 2];
  const DepthPoint* current = polygon;
  int next = 0;
  for (std::size_t k = 0; k < corners; ++k) {
    const PlanePoint p = outline[k], q = outline[k + 1 == corners ? 0 : k + 1];
    const double cu = p.v - q.v, cv = q.u - p.u, c = -(cu * p.u + cv * p.v);
    bool outside = false;
    for (std::size_t i = 0; i < count; ++i) outside |= cu * current[i].u + cv * current[i].v + c < 0;
    if (!outside) continue;
    count = clip(current, count, cu, cv, 0, c, buffer[next]);
    if (count < 3) return;
    current = buffer[next];
    next = 1 - next;
  }
  moments.add(current, count);
}

// The patch of a single vertex below the plane, at its tip (0, 0), whose edges cross the plane within the outline: a
// fan of corners. False when that is not so.
bool add_tip(const shapes::Polyhedron& p, const DepthMap& map, std::uint32_t tip, double depth,
             const PlanePoint* outline, std::size_t corners, DepthMoments& moments) {
  constexpr std::uint32_t cap = 16;
  const std::uint32_t first = p.first_spoke[tip], count = p.first_spoke[tip + 1] - first;
  if (count > cap) return false;
  DepthPoint rim[cap];
  const Vec3d x = p.vertices[tip];
  double square = 0;
  for (std::uint32_t k = 0; k < count; ++k) {
    const Vec3d e = p.spokes[first + k].to - x;
    const double rise = map.scale * dot(map.normal, e);
    if (!(rise > depth)) return false;
    const double t = map.scale * (depth / rise);
    rim[k] = {t * dot(map.u_axis, e), t * dot(map.v_axis, e), 0};
    square = std::max(square, rim[k].u * rim[k].u + rim[k].v * rim[k].v);
  }
  PlanePoint a = outline[corners - 1];
  for (std::size_t k = 0; k < corners; ++k) {
    const PlanePoint b = outline[k];
    const double eu = b.u - a.u, ev = b.v - a.v, within = a.u * b.v - a.v * b.u;  // |e| times the distance of the side
    if (!(within > 0 && within * within > square * (eu * eu + ev * ev))) return false;
    a = b;
  }
  // Seen from outside, against the normal, the edges of the tip turn the other way than in the plane.
  for (std::uint32_t k = 0; k < count; ++k) moments.add_corner(depth, rim[k + 1 == count ? 0 : k + 1], rim[k]);
  moments.deepest = {0, 0, depth};
  return true;
}

}  // namespace

void face_patch(const PolyhedronPair& pair, const Mat3d& rotation, const Vec3d& position, std::uint32_t face,
                std::uint32_t deepest, double gap, Vec3d& on_self, Vec3d& on_other, Patch& patch) {
  const shapes::Polyhedron& self = *pair.self;
  const shapes::Polyhedron& other = *pair.other;
  const auto& f = self.faces[face];
  const Vec3d tip = pair.other_vertex(deepest), foot = tip - gap * f.normal;
  Vec3d u, v;
  tangent_frame(f.normal, u, v);
  // Coordinates are counted from the deepest vertex: the patch lies around it, so its moments do not cancel.
  const Mat3d& r = pair.other_to_self;
  const DepthMap map{
      transposed_times(r, u),     transposed_times(r, v),     transposed_times(r, f.normal),    pair.other_scale,
      dot(u, pair.offset - foot), dot(v, pair.offset - foot), dot(f.normal, foot - pair.offset)};
  const std::uint32_t* loop = self.face_vertices.data() + f.first;
  const auto corner = [&](std::size_t k) {
    const Vec3d x = pair.self_vertex(loop[k]) - foot;
    return PlanePoint{dot(u, x), dot(v, x)};
  };
  DepthMoments moments;
  const auto add_parts = [&](const PlanePoint* outline, std::size_t corners) {
    const auto add = [&](const DepthPoint* polygon, std::size_t count) {
      add_over(polygon, count, outline, corners, moments);
    };
    if (!for_each_submerged_near(other, map, deepest, add)) for_each_submerged(other, map, add);
  };
  if (f.count <= polygon_cap) {
    PlanePoint outline[polygon_cap];
    for (std::size_t k = 0; k < f.count; ++k) outline[k] = corner(k);
    if (!add_tip(other, map, deepest, -gap, outline, f.count, moments)) add_parts(outline, f.count);
  } else {
    for (std::size_t k = 1; k + 1 < f.count; ++k) {
      const PlanePoint outline[3] = {corner(0), corner(k), corner(k + 1)};
      add_parts(outline, 3);
    }
  }
  const PlaneFrame plane{rotation * foot + position, rotation * u, rotation * v, rotation * f.normal};
  if (make_patch(moments, plane, patch)) {
    on_self = plane(moments.deepest.u, moments.deepest.v, 0);
    on_other = on_self + gap * plane.normal;
    return;
  }
  on_self = plane.origin;
  on_other = plane.origin + gap * plane.normal;
  patch = {0.5 * (on_self + on_other), {}};
}

}  // namespace contact
