// Convex loops of the plane as queries see them: placed, in units near the pair's; and the answers about them that
// whole convex polygons and the parts of others share. Everything is relative to the origin of the pair's first body.
#pragma once

#include <limits>
#include <span>

#include "libcontact/contact.h"
#include "libcontact/methods/short_list.h"

namespace contact {

struct Placement {  // x -> scale · R x + at
  double scale, cosine, sine;
  Vec3d at;
  Vec3d direction(const Vec3d& v) const { return {cosine * v.x - sine * v.y, sine * v.x + cosine * v.y, 0}; }
  Vec3d point(const Vec3d& v) const { return at + scale * direction(v); }
};

inline Placement placement(const Placed<shapes::Polygon>& p, double down, const Vec3d& at) {
  return {p.scale * down, p.cosine, p.sine, at};
}

// Of vectors of the plane.
inline double dot_xy(const Vec3d& a, const Vec3d& b) { return a.x * b.x + a.y * b.y; }

struct Loop {
  std::span<const Vec3d> vertices, normals;  // side i runs from vertex i to the next; in the loop's own frame
  std::span<const double> offsets;
  std::span<const std::uint32_t> edges;  // of a part: of the outline, that a side lies on; else empty
  double core;                           // > 0: radius of a circle inside the loop about its origin
  Placement place;

  Loop(const shapes::Polygon& p, const Placement& at)
      : vertices(p.vertices), normals(p.normals), offsets(p.offsets), core(p.inscribed_radius), place(at) {}
  Loop(const shapes::Polygon::Part& p, const Placement& at)
      : vertices(p.vertices), normals(p.normals), offsets(p.offsets), edges(p.edge), core(0), place(at) {}

  std::uint32_t size() const { return static_cast<std::uint32_t>(vertices.size()); }
  std::uint32_t next(std::uint32_t i) const { return i + 1 == size() ? 0 : i + 1; }
  std::uint32_t before(std::uint32_t i) const { return (i == 0 ? size() : i) - 1; }
  bool is_cut(std::uint32_t side) const { return !edges.empty() && edges[side] == shapes::Polygon::none; }
  // As placed.
  Vec3d vertex(std::uint32_t i) const { return place.point(vertices[i]); }
  Vec3d normal(std::uint32_t i) const { return place.direction(normals[i]); }
  double height(std::uint32_t i, const Vec3d& normal) const {  // normal·x on side i
    return place.scale * offsets[i] + dot_xy(normal, place.at);
  }
  Vec3d in_frame(const Vec3d& direction) const {  // its own frame
    return {place.cosine * direction.x + place.sine * direction.y,
            place.cosine * direction.y - place.sine * direction.x, 0};
  }
};

// The vertex of a convex loop that is lowest along m, of the loop's own frame, by a walk from `vertex`.
struct Lowest {
  std::uint32_t vertex;
  double value, rise;  // its height along m; how much higher its neighbours are, at least
};
Lowest lowest_from(std::span<const Vec3d> loop, const Vec3d& m, std::uint32_t vertex);

// Half the width of an answer's bounds, per size.
inline constexpr double planar_half_width = 32 * epsilon;

// A convex loop's corner or crossing point and the side that begins there.
struct LoopCorner {
  Vec3d x;
  std::uint32_t side;
};
using Corners = ShortList<LoopCorner, 16>;

// The part of a convex loop with n·x <= height, into `out`; the side that this adds is called `side`.
void cut(const Corners& in, const Vec3d& n, double height, std::uint32_t side, Corners& out);

// Area moments of convex regions, added up: below the line of a contact the area is ∫h, so these are the moments of the
// patch.
class AreaMoments {
 public:
  void add(const Corners& region);
  // Centroid, and spread along the line of normal n. False when there is no area.
  bool patch(const Vec3d& n, Patch& patch) const;

 private:
  double area_ = 0, xx_ = 0, yy_ = 0, xy_ = 0;  // about origin_, a corner of the first region
  Vec3d first_{}, origin_{};
};

// Answers about convex loops, in units; size: the extent of the pair. Out of range, the status is refused.
Contact disc_loop(double radius, const Loop& b, double size);
Contact ellipse_loop(const Placed<shapes::Ellipse>& a, const Loop& b, double size);

}  // namespace contact
