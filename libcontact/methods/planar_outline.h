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

struct Outline {
  struct Side {
    Vec3d vertex, normal;  // side i runs from vertex i to vertex i + 1
    double height;         // normal·x on it
  };
  ShortList<Side, 16> sides;

  Outline(std::span<const Vec3d> vertices, std::span<const Vec3d> normals, std::span<const double> offsets,
          const Placement& place) {
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      const Vec3d n = place.direction(normals[i]);
      sides.push_back({place.point(vertices[i]), n, place.scale * offsets[i] + dot(n, place.at)});
    }
  }
  Outline(const shapes::Polygon& p, const Placement& place) : Outline(p.vertices, p.normals, p.offsets, place) {}
  Outline(const shapes::Polygon::Part& p, const Placement& place) : Outline(p.vertices, p.normals, p.offsets, place) {}

  std::size_t size() const { return sides.size(); }
  std::size_t next(std::size_t i) const { return i + 1 == sides.size() ? 0 : i + 1; }
  const Vec3d& vertex(std::size_t i) const { return sides[i].vertex; }
  const Vec3d& normal(std::size_t i) const { return sides[i].normal; }
  double height(std::size_t i) const { return sides[i].height; }
  double lowest(const Vec3d& n, std::size_t& index) const {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < sides.size(); ++i)
      if (const double h = dot(n, sides[i].vertex); h < least) least = h, index = i;
    return least;
  }
};

// Half the width of an answer's bounds, per size.
inline constexpr double planar_half_width = 32 * epsilon;

// A convex loop's corner or crossing point and the side that begins there.
struct Corner {
  Vec3d x;
  std::uint32_t side;
};
using Corners = ShortList<Corner, 16>;

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
Contact disc_outline(double radius, const Outline& b, double size);
Contact ellipse_outline(const Placed<shapes::Ellipse>& a, const Outline& b, double size);
Contact outline_pair(const Outline& a, const Outline& b, double size, const Options& options);

}  // namespace contact
