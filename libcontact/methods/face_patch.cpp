#include "libcontact/methods/face_patch.h"

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

}  // namespace

bool face_patch(const PolyhedronPair& pair, std::uint32_t face, std::uint32_t deepest, double gap, Vec3d& on_self,
                Vec3d& on_other, Patch& patch) {
  const shapes::Polyhedron& self = *pair.self;
  const auto& f = self.faces[face];
  const Vec3d tip = pair.other_vertex(deepest);
  PlaneFrame plane;
  plane.normal = f.normal;
  tangent_frame(f.normal, plane.u, plane.v);
  plane.origin = tip - gap * f.normal;
  // Coordinates are counted from the deepest vertex: the patch lies around it, so its moments do not cancel.
  const Mat3d& r = pair.other_to_self;
  const DepthMap map{transposed_times(r, plane.u),
                     transposed_times(r, plane.v),
                     transposed_times(r, plane.normal),
                     pair.other_scale,
                     dot(plane.u, pair.offset - plane.origin),
                     dot(plane.v, pair.offset - plane.origin),
                     dot(plane.normal, plane.origin - pair.offset)};
  const std::uint32_t* loop = self.face_vertices.data() + f.first;
  const auto corner = [&](std::size_t k) {
    const Vec3d x = pair.self_vertex(loop[k]) - plane.origin;
    return PlanePoint{dot(plane.u, x), dot(plane.v, x)};
  };
  DepthMoments moments;
  if (f.count <= polygon_cap) {
    PlanePoint outline[polygon_cap];
    for (std::size_t k = 0; k < f.count; ++k) outline[k] = corner(k);
    for_each_submerged(*pair.other, map, [&](const DepthPoint* polygon, std::size_t count) {
      add_over(polygon, count, outline, f.count, moments);
    });
  } else {
    for (std::size_t k = 1; k + 1 < f.count; ++k) {
      const PlanePoint outline[3] = {corner(0), corner(k), corner(k + 1)};
      for_each_submerged(*pair.other, map, [&](const DepthPoint* polygon, std::size_t count) {
        add_over(polygon, count, outline, 3, moments);
      });
    }
  }
  if (!make_patch(moments, plane, patch)) {
    on_self = plane.origin;
    on_other = tip;
    return false;
  }
  on_self = plane(moments.deepest.u, moments.deepest.v, 0);
  on_other = on_self + gap * f.normal;
  return true;
}

}  // namespace contact
