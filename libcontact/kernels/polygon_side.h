// One corner of `other` behind one side of `self`, lane by lane: is it what a search of all sides would answer, and
// what is the answer? T is double or a pack; the bits of a lane are those of polygon_pair.cpp and polygon_regions.cpp.
//
// Lengths are in metres, as they come: those two work in units of a power of two, which changes no digit. What is
// compared here only to be sure has margins far above rounding; where one is not kept, the lane has no answer.
//
//   whole polygons   the side is nearer than all others: facet_alone.h                                          (1)
//   parts            the overlap of these two parts is a region by itself, and this side is the one of its border that
//                    the other part lies least deep behind                                                      (2)
//
// (2): the corners of the overlap are known (side_overlap.h), each at a distance from where another side would begin.
// Where it ends at a cut, the reflex corner that the cut begins at lies in the other part, which ends the region there.
// Every other side of its border has a corner of the other part farther behind it than this one has.
// Tests: tests/libcontact/polygon_lanes.cpp
#pragma once

#include "libcontact/kernels/flat.h"
#include "libcontact/kernels/side_overlap.h"

namespace contact {

using shapes::lesser;

template <class T>
struct FlatPlace {  // x -> at + scale · R x
  T scale, cosine, sine;
  Flat<T> at;
  [[gnu::always_inline]] Flat<T> direction(const Flat<T>& v) const {
    return {cosine * v.x - sine * v.y, sine * v.x + cosine * v.y};
  }
  [[gnu::always_inline]] Flat<T> point(const Flat<T>& v) const { return at + scale * direction(v); }
  [[gnu::always_inline]] Flat<T> in_frame(const Flat<T>& v) const {
    return {scale * (cosine * v.x + sine * v.y), scale * (cosine * v.y - sine * v.x)};
  }
};

template <class T>
struct PolygonSide {  // a lane's SideRow
  Flat<T> before, start, end, after, normal;
  T offset, cut, cut_before, cut_after;
};
template <class T>
struct PolygonCorner {  // and CornerRow
  Flat<T> corner, left[2], right[2], far;
  T cut_left[2], cut_right[2];
};

template <class T>
class SideMeeting {
 public:
  using P = SidePoint<T>;
  using Mask = MaskOf<T>;

  // What the law sees, and more of the contact; from self to other.
  T depth, gain, spread;
  Flat<T> normal, point, centre, out;
  T level;  // the normal's third coordinate: zero, with the sign that it has there

  // size: at least twice the extent of the pair, m; smaller: at least the lesser circumradius, m; core: of whole
  // polygons the radii of their circles added up, m.
  template <bool parts>
  [[gnu::always_inline]] Mask solve(const PolygonSide<T>& s, const PolygonCorner<T>& c, const FlatPlace<T>& self,
                                    const FlatPlace<T>& other, const T& size, const T& smaller, const T& core) {
    using std::sqrt;
    out = self.direction(s.normal);
    const Flat<T> along{-out.y, out.x}, tip = other.point(c.corner);
    const T gap = dot(out, tip) - (self.scale * s.offset + dot(out, self.at)), d = -gap;
    const T from_start = dot(along, tip) - dot(along, self.point(s.start));
    const auto of_self = [&](const Flat<T>& v) {
      const Flat<T> e = v - s.start;
      return P{self.scale * (s.normal.x * e.y - s.normal.y * e.x) - from_start, -self.scale * dot(s.normal, e)};
    };
    const Flat<T> x = other.in_frame(along), y = other.in_frame(out);
    const auto of_other = [&](const Flat<T>& v) {
      const Flat<T> e = v - c.corner;
      return P{dot(x, e), d - dot(y, e)};
    };
    SideCorners<T> near{d,
                        -from_start,
                        of_self(s.end).u,
                        of_self(s.before),
                        of_self(s.after),
                        {of_other(c.left[0]), of_other(c.left[1])},
                        {of_other(c.right[0]), of_other(c.right[1])},
                        of_other(c.far)};
    if constexpr (parts) {
      near.cut_before = s.cut_before > T(0);
      near.cut_after = s.cut_after > T(0);
      for (int i = 0; i < 2; ++i) {
        near.cut_left[i] = c.cut_left[i] > T(0);
        near.cut_right[i] = c.cut_right[i] > T(0);
      }
    } else {
      near.cut_before = near.cut_after = near.cut_left[0] = near.cut_left[1] = near.cut_right[0] = near.cut_right[1] =
          T(1) < T(0);
    }
    SideRegion<T> region;
    Mask found = region.find(near) && size > T(0x1p-200) && size < T(0x1p200);
    if constexpr (parts)
      found = found && region.alone(near, s.cut_before, s.cut_after, c.cut_left, c.cut_right, size) && s.cut == T(0);
    else
      found = found && nearest(near, self.at - other.at, core, size);
    const SideOverlap<T> overlap = region.measure();
    const T least = T(0x1.00001p-26) * smaller;  // least_depth
    found = found && overlap.section > least && overlap.variance > T(0) && overlap.depth > least;

    depth = overlap.depth;
    spread = select(overlap.spread > T(0), overlap.spread, T(0));
    centre = (tip - gap * out) + world(overlap.u, overlap.h);
    const Flat<T> force = world(overlap.force.u, overlap.force.h);
    gain = sqrt(dot(force, force));
    const T inverse = T(1) / gain;
    normal = inverse * force;
    level = inverse * (overlap.force.u * T(0) - overlap.force.h * T(0));
    const Flat<T> shift{normal.y * overlap.moment, -(normal.x * overlap.moment)};
    point = centre + inverse * shift;
    return found;
  }

 private:
  [[gnu::always_inline]] Flat<T> world(const T& u, const T& h) const {
    const Flat<T> along{-out.y, out.x};
    return u * along - h * out;
  }

  // (1): facet_is_alone of facet_alone.h.
  [[gnu::always_inline]] Mask nearest(const SideCorners<T>& c, const Flat<T>& between, const T& core,
                                      const T& size) const {
    const T d = c.depth, margin = T(0x1p-46) * size, e = T(0x1p-48) * size;
    const T reach = lesser(-c.from, c.to);
    const T rise = lesser(lesser(c.before.h, c.after.h), d - larger(c.left[0].h, c.right[0].h));
    const T full = T(0.875) * reach / d, t = lesser(full, T(8));
    const T w = T(1) / (T(1) + t * t), sine = T(2) * t * w, cosine = (T(1) - t * t) * w;
    const T along = dot(between, out);
    const Flat<T> rest = between - along * out;
    const T square = dot(rest, rest), above = along * cosine + core - (d + margin), turn = along * sine;
    const T bound = square * (cosine * cosine);
    return core > T(0) && d > margin && reach > T(0x1p-20) * size && rise * reach > (T(4) * margin + e) * size &&
           sine * (reach - d * t) > margin && above > T(0) && above * above > square * (sine * sine) &&
           ((cosine <= T(0) && (turn <= T(0) || turn * turn <= bound)) ||
            (cosine > T(0) && turn <= T(0) && turn * turn >= bound));
  }
};

}  // namespace contact
