#include "libcontact/methods/overlap_moments.h"

#include <algorithm>
#include <cmath>

#include "libcontact/kernels/chunk.h"
#include "libcontact/methods/overlap_forms.h"

namespace contact {

namespace {

using kernels::OverlapRow;
using kernels::OverlapSide;
using kernels::OverlapTriangle;

// A body as it is summed over: a fan of triangles in each face, spread from the first of its corners. `cones`: those of
// faces without corner 0, `of_other`: those of other's faces, `rim`: sides with self's face to the left, other's to the
// right.
class Lists {
 public:
  kernels::OverlapLists gather(const OverlapBody& body) {
    const auto corners = body.corners();
    const auto faces = body.faces();
    const auto sides = body.sides();
    const std::size_t filled = (corners.size() + 3) / 4 * 4;
    corners_.make_room(filled);
    places_.make_room(filled);
    normals_.make_room(faces.size());
    fans_.make_room(faces.size());
    cones_.make_room(2 * sides.size() + 4);
    of_other_.make_room(2 * sides.size() + 4);
    rim_.make_room(sides.size() + 4);
    for (std::size_t i = 0; i < filled; ++i) {
      const Vec3d& x = corners[i < corners.size() ? i : 0];
      corners_[i] = {x.x, x.y, x.z, 0};
    }
    std::uint32_t* const fans = fans_.data();
    for (std::size_t i = 0; i < faces.size(); ++i) {
      const Vec3d& n = faces[i].normal;
      normals_[i] = {n.x, n.y, n.z, 0};
      fans[i] = OverlapBody::none;
    }
    for (const OverlapSide& s : sides) {
      const std::uint32_t first = std::min(s.from, s.to);
      fans[s.left] = std::min(fans[s.left], first);
      fans[s.right] = std::min(fans[s.right], first);
    }
    // No branch on what cannot be guessed.
    OverlapTriangle *cone = cones_.data(), *other = of_other_.data();
    OverlapSide* between = rim_.data();
    for (const OverlapSide& s : sides) {
      const std::size_t left = faces[s.left].of_other, right = faces[s.right].of_other;
      const std::uint32_t f = fans[s.left], g = fans[s.right];
      const std::size_t in_left = static_cast<std::size_t>(f != s.from) & static_cast<std::size_t>(f != s.to),
                        in_right = static_cast<std::size_t>(g != s.from) & static_cast<std::size_t>(g != s.to);
      *cone = {f, s.from, s.to};
      cone += in_left & static_cast<std::size_t>(f != 0);
      *other = {f, s.from, s.to};
      other += in_left & left;
      *cone = {g, s.to, s.from};
      cone += in_right & static_cast<std::size_t>(g != 0);
      *other = {g, s.to, s.from};
      other += in_right & right;
      *between = left != 0 ? OverlapSide{s.to, s.from, s.right, s.left} : s;
      between += left ^ right;
    }
    return {corners_.data(),
            normals_.data(),
            cones_.data(),
            of_other_.data(),
            rim_.data(),
            places_.data(),
            corners.size(),
            filled,
            fill(cones_.data(), cone),
            fill(of_other_.data(), other),
            fill(rim_.data(), between)};
  }

 private:
  template <class Entry>
  static std::size_t fill(const Entry* list, Entry* end) {
    while ((end - list) % 4 != 0) *end++ = {};
    return static_cast<std::size_t>(end - list);
  }

  ScratchList<OverlapRow> corners_, places_, normals_;
  ScratchList<std::uint32_t> fans_;  // of faces: the corner
  ScratchList<OverlapTriangle> cones_, of_other_;
  ScratchList<OverlapSide> rim_;
};

}  // namespace

OverlapDepth line_of_action(const DepthSlope& s) {
  OverlapDepth out{.depth = s.depth, .gain = norm(s.force)};
  out.normal = s.force * (1 / out.gain);
  out.point = s.centroid + cross(out.normal, s.moment) * (1 / out.gain);
  out.screw = dot(out.normal, s.moment) / out.gain;
  return out;
}

bool depth_slope(const OverlapBody& body, double size, DepthSlope& out) {
  if (body.empty()) return false;
  if (body.form() == OverlapBody::Form::corner)
    return corner_slope(body.corners(), -body.faces().back().normal, body.depth(), size, out);
  if (body.form() == OverlapBody::Form::edges) {
    const auto faces = body.faces();
    const Vec3d normals[4] = {faces[0].normal, faces[1].normal, faces[2].normal, faces[3].normal};
    return edges_slope(body.corners().data(), normals, size, out);
  }
  static thread_local Lists lists;
  return kernels::kernels().overlaps->slope(lists.gather(body), size, out);
}

}  // namespace contact
