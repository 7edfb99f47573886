// What the searches for regions share: groups of pieces, and the parts of one polygon that are in play.
#pragma once

#include <algorithm>

#include "libcontact/methods/method.h"
#include "libcontact/methods/planar_outline.h"
#include "libcontact/scale.h"

namespace contact {

using Marks = ShortList<char, 64>;  // one per part or seam
constexpr std::uint32_t no_edge = shapes::Polygon::none;

// Pieces joined into groups; a group is known by its first piece.
class Groups {
 public:
  void add() { first_.push_back(static_cast<std::uint32_t>(first_.size())); }
  std::uint32_t of(std::uint32_t i) const {
    while (first_[i] != i) i = first_[i];
    return i;
  }
  void join(std::uint32_t i, std::uint32_t j) {
    i = of(i), j = of(j);
    first_[i < j ? j : i] = i < j ? i : j;
  }

 private:
  ShortList<std::uint32_t, 64> first_;
};

// Some material of a polygon: how deep its deepest corner lies behind a line, and that corner: a vertex of a part.
struct Depth {
  double value = -std::numeric_limits<double>::infinity();
  Vec3d corner{};
  std::uint32_t part = 0, vertex = 0;
};

struct PartsView {
  const shapes::Polygon& shape;
  Placement place;

  std::size_t count() const { return shape.parts.size(); }
  const shapes::Polygon::Part& part(std::size_t i) const { return shape.parts[i]; }
  Vec3d normal(const shapes::Polygon::Part& p, std::size_t side) const { return place.direction(p.normals[side]); }
  double height(const shapes::Polygon::Part& p, std::size_t side, const Vec3d& normal) const {
    return place.scale * p.offsets[side] + dot(normal, place.at);
  }
  Vec3d edge_normal(std::uint32_t e) const { return place.direction(shape.normals[e]); }
  double edge_height(std::uint32_t e, const Vec3d& normal) const {
    return place.scale * shape.offsets[e] + dot(normal, place.at);
  }
  bool holds(std::size_t i, const Vec3d& x) const {
    const auto& p = part(i);
    for (std::size_t k = 0; k < p.normals.size(); ++k)
      if (const Vec3d n = normal(p, k); !(dot(n, x) <= height(p, k, n))) return false;
    return true;
  }
  bool holds(const Vec3d& x) const {
    for (std::size_t i = 0; i < count(); ++i)
      if (holds(i, x)) return true;
    return false;
  }
  // Circles about a part and a point's neighbourhood of this radius meet, with a margin for rounding.
  bool near(std::size_t i, const Vec3d& centre, double radius, double margin) const {
    const Vec3d d = place.point(part(i).centre) - centre;
    const double reach = place.scale * part(i).radius + radius + margin;
    return dot(d, d) <= reach * reach;
  }

  Vec3d in_frame(const Vec3d& direction) const {  // its own
    return {place.cosine * direction.x + place.sine * direction.y,
            place.cosine * direction.y - place.sine * direction.x, 0};
  }
  // How far all of a part lies beyond the side of part `q` of `of` that its middle is highest over.
  [[gnu::always_inline]] double beyond_side(const shapes::Polygon::Part& p, const PartsView& of,
                                            const shapes::Polygon::Part& q) const {
    const Vec3d middle = of.in_frame(place.point(p.centre) - of.place.at);
    double top = -std::numeric_limits<double>::infinity();
    std::size_t side = 0;
    for (std::size_t k = 0; k < q.normals.size(); ++k)
      if (const double h = dot_xy(q.normals[k], middle) - of.place.scale * q.offsets[k]; h > top) top = h, side = k;
    return over_side(p, of, q, side);
  }
  // How far all of a part lies beyond a side of part `q` of `of`; negative: not all does.
  [[gnu::always_inline]] double over_side(const shapes::Polygon::Part& p, const PartsView& of,
                                          const shapes::Polygon::Part& q, std::size_t side) const {
    const Vec3d n = of.normal(q, side), down = in_frame(n);
    double lowest = std::numeric_limits<double>::infinity();
    for (const Vec3d& v : p.vertices) lowest = std::min(lowest, dot_xy(down, v));
    return place.scale * lowest + dot_xy(n, place.at) - of.height(q, side, n);
  }

  // Whether no region reaches across a seam: the other body holds a reflex corner of it.
  template <class Holds>
  bool blocked(const shapes::Polygon::Seam& seam, Holds&& other_holds) const {
    for (const std::uint32_t c : seam.corner)
      if (c != no_edge && other_holds(place.point(shape.vertices[c]))) return true;
    return false;
  }

  // Depth of the marked parts behind the line n·x = h.
  Depth behind(const Vec3d& n, double h, const Marks& marks) const {
    Depth depth;
    for (std::size_t i = 0; i < count(); ++i) {
      if (!marks[i]) continue;
      const auto& list = part(i).vertices;
      for (std::size_t k = 0; k < list.size(); ++k) {
        const Vec3d x = place.point(list[k]);
        if (const double d = h - dot(n, x); d > depth.value)
          depth = {d, x, static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(k)};
      }
    }
    return depth;
  }
};

// Collects a pair's regions; of too many it keeps the deepest.
class RegionList {
 public:
  RegionList(Contact* out, std::size_t capacity) : out_(out), capacity_(capacity) {}
  // Its place in the list; `capacity` when it was left out.
  std::size_t add(const Contact& c) {
    if (count_ < capacity_) {
      out_[count_] = c;
      return count_++;
    }
    full_ = true;
    std::size_t shallowest = 0;
    for (std::size_t i = 1; i < count_; ++i)
      if (out_[i].gap > out_[shallowest].gap) shallowest = i;
    if (!(c.gap < out_[shallowest].gap)) return capacity_;
    out_[shallowest] = c;
    return shallowest;
  }
  std::size_t finish(double up) {
    for (std::size_t i = 0; i < count_; ++i) {
      rescale(out_[i], up);
      if (full_) out_[i].certified = false;
    }
    return count_;
  }

 private:
  Contact* out_;
  std::size_t capacity_, count_ = 0;
  bool full_ = false;
};

inline Contact region_answer(double gap, double size, const Vec3d& n, const Vec3d& a, const Vec3d& b) {
  return smooth_contact(gap, gap - planar_half_width * size, gap + planar_half_width * size, n, a, b);
}

}  // namespace contact
