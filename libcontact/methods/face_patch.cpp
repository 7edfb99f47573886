#include "libcontact/methods/face_patch.h"

#include <algorithm>
#include <cstdint>

namespace contact {
namespace {

struct PlanePoint {
  double u, v;
};

// A convex counter-clockwise polygon of at most polygon_cap corners as half-planes cu·u + cv·v + c >= 0.
class Outline {
 public:
  Outline(const PlanePoint* corner, std::size_t count) : count_(count) {
    for (std::size_t k = 0; k < count; ++k) {
      const PlanePoint p = corner[k], q = corner[k + 1 == count ? 0 : k + 1];
      const double cu = p.v - q.v, cv = q.u - p.u;
      side_[k] = {cu, cv, -(cu * p.u + cv * p.v)};  // of short sides far away p × q would cancel
    }
  }
  // Some of the points lie beyond side k.
  bool crosses(std::size_t k, const DepthPoint* point, std::size_t count) const {
    bool beyond = false;
    for (std::size_t i = 0; i < count; ++i)
      beyond |= side_[k].cu * point[i].u + side_[k].cv * point[i].v + side_[k].c < 0;
    return beyond;
  }
  std::size_t count() const { return count_; }
  std::size_t clip_side(std::size_t k, const DepthPoint* in, std::size_t count, DepthPoint* out) const {
    return clip(in, count, side_[k].cu, side_[k].cv, 0, side_[k].c, out);
  }

 private:
  struct Side {
    double cu, cv, c;
  };
  Side side_[polygon_cap];
  std::size_t count_;
};

// Moments of what faces of a body have under the plane and over an outline.
class Submerged {
 public:
  Submerged(const shapes::Polyhedron& p, const DepthMap& map, const Outline& outline, DepthMoments& moments)
      : p_(p), map_(map), outline_(outline), moments_(moments) {}

  // The faces that look at the plane, under it and over the outline, hang together across edges that have a part there:
  // below a plane the body's lower side is convex, and so is the outline. A walk from the deepest vertex, at (0, 0),
  // meets them all where that is over the outline. False, before anything is added, for too many faces.
  bool add_around(std::uint32_t deepest) {
    if (p_.faces.size() > walk_cap) return false;
    std::uint64_t seen[walk_cap / 64];
    std::fill_n(seen, (p_.faces.size() + 63) / 64, 0);
    std::uint16_t queue[walk_cap];
    std::size_t count = 0;
    const auto enqueue = [&](std::uint32_t f) {
      const std::uint64_t bit = std::uint64_t{1} << (f % 64);
      if ((seen[f / 64] & bit) != 0) return;
      seen[f / 64] |= bit;
      queue[count++] = static_cast<std::uint16_t>(f);
    };
    for (std::uint32_t k = p_.first_spoke[deepest]; k < p_.first_spoke[deepest + 1]; ++k) enqueue(p_.spokes[k].face);
    for (std::size_t i = 0; i < count; ++i)
      add(queue[i], [&](std::uint32_t edge) {
        const auto& e = p_.edges[edge];
        enqueue(e.face[e.face[0] == queue[i] ? 1 : 0]);
      });
    return true;
  }
  void add_all() {
    for (std::uint32_t f = 0; f < p_.faces.size(); ++f) add(f, [](std::uint32_t) {});
  }

 private:
  // Calls `across` for every edge that may have a part under the plane and over the outline.
  template <class Across>
  void add(std::uint32_t f, Across&& across) {
    const auto& face = p_.faces[f];
    if (dot(face.normal, map_.normal) >= 0) return;
    const std::uint32_t *loop = p_.face_vertices.data() + face.first, *edge = p_.face_edges.data() + face.first;
    DepthPoint polygon[polygon_cap];
    if (face.count > polygon_cap) {
      polygon[0] = map_(p_.vertices[loop[0]]);
      for (std::uint32_t k = 1; k + 1 < face.count; ++k) {
        polygon[1] = map_(p_.vertices[loop[k]]);
        polygon[2] = map_(p_.vertices[loop[k + 1]]);
        add_part(polygon, 3);
      }
      for (std::uint32_t k = 0; k < face.count; ++k) across(edge[k]);
      return;
    }
    for (std::uint32_t k = 0; k < face.count; ++k) polygon[k] = map_(p_.vertices[loop[k]]);
    if (!add_part(polygon, face.count)) return;
    for (std::uint32_t k = 0; k < face.count; ++k)
      if (polygon[k].h > 0 || polygon[k + 1 == face.count ? 0 : k + 1].h > 0) across(edge[k]);
  }
  // What of a polygon lies under the plane and over the outline. False when there is nothing.
  bool add_part(const DepthPoint* polygon, std::size_t count) {
    DepthPoint buffer[2][2 * polygon_cap + 2];
    bool below = false, above = false;
    for (std::size_t k = 0; k < count; ++k) (polygon[k].h > 0 ? below : above) = true;
    if (!below) return false;
    const DepthPoint* current = polygon;
    int next = 0;
    if (above) {
      count = clip(current, count, 0, 0, 1, 0, buffer[0]);
      current = buffer[0];
      next = 1;
    }
    for (std::size_t k = 0; k < outline_.count() && count >= 3; ++k) {
      if (!outline_.crosses(k, current, count)) continue;
      count = outline_.clip_side(k, current, count, buffer[next]);
      current = buffer[next];
      next = 1 - next;
    }
    if (count < 3) return false;
    moments_.add(current, count);
    return true;
  }

  static constexpr std::size_t walk_cap = 4096;
  const shapes::Polyhedron& p_;
  const DepthMap& map_;
  const Outline& outline_;
  DepthMoments& moments_;
};

// The patch of a single vertex below the plane, at its tip (0, 0), whose edges cross the plane within the outline: a
// fan of corners. False when that is not so.
bool add_tip(const shapes::Polyhedron& p, const DepthMap& map, std::uint32_t tip, double depth, double reach,
             DepthMoments& moments) {
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
  if (!(square < reach * reach)) return false;
  // Seen from outside, against the normal, the edges of the tip turn the other way than in the plane.
  for (std::uint32_t k = 0; k < count; ++k) moments.add_corner(depth, rim[k + 1 == count ? 0 : k + 1], rim[k]);
  moments.deepest = {0, 0, depth};
  return true;
}

}  // namespace

void face_patch(const PolyhedronPair& pair, const Mat3d& rotation, const Vec3d& position, const FaceOverVertex& at,
                Vec3d& on_self, Vec3d& on_other, Patch& patch) {
  const shapes::Polyhedron& self = *pair.self;
  const shapes::Polyhedron& other = *pair.other;
  const auto& f = self.faces[at.face];
  const Vec3d tip = pair.other_vertex(at.deepest), foot = tip - at.gap * f.normal;
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
  if (f.count <= polygon_cap) {
    if (!add_tip(other, map, at.deepest, -at.gap, at.reach, moments)) {
      PlanePoint corners[polygon_cap];
      for (std::size_t k = 0; k < f.count; ++k) corners[k] = corner(k);
      const Outline outline(corners, f.count);
      Submerged part(other, map, outline, moments);
      if (!(at.reach > 0 && part.add_around(at.deepest))) part.add_all();
    }
  } else {
    for (std::size_t k = 1; k + 1 < f.count; ++k) {
      const PlanePoint corners[3] = {corner(0), corner(k), corner(k + 1)};
      const Outline outline(corners, 3);
      Submerged(other, map, outline, moments).add_all();
    }
  }
  const PlaneFrame plane{rotation * foot + position, rotation * u, rotation * v, rotation * f.normal};
  if (make_patch(moments, plane, patch)) {
    on_self = plane(moments.deepest.u, moments.deepest.v, 0);
    on_other = on_self + at.gap * plane.normal;
    return;
  }
  on_self = plane.origin;
  on_other = plane.origin + at.gap * plane.normal;
  patch = {0.5 * (on_self + on_other), {}};
}

}  // namespace contact
