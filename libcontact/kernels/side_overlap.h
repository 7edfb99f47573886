// The overlap of two convex loops about one corner of `other` behind a side of `self`, in closed form and without a
// branch per pair: T is double or a pack, and the bits of a lane are those of double.
//
//   corners   (u, h): u along the side from the foot of the deepest corner C = (0, D), h the depth behind the side
//   border    Q, R, C, L, P of other, from right to left, and S, S' of self back to Q: R and L are corners next to C or
//             C itself, S and S' the ends of the side or the crossings P and Q themselves                         (1)
//   chord     t = (Q − P)/|Q − P|, the direction of the vector area of overlap_depth.h is across it               (2)
//   moments   of triangles about P, in the axes of the chord                                                      (3)
//   cuts      of parts of a body are no borders of it: where the overlap ends at one, an end of (2) is midway between
//             the ends of what the two bodies have of its border                                                   (4)
//
// It is all of the overlap when each crossing lies on the side or on the next one, with one corner of other at most
// between it and C, when the next corners of self lie deeper than D, and when those ends of the side that count lie
// within a hull of corners of other. Depth, force and moment are (1)–(4) of overlap_depth.h with `other` as the body
// that moves. Source: own derivation. Cost: 3 roots, 8 divisions. Accuracy: that of the corners, for all counts from C.
// Tests: tests/libcontact/polygon_pair.cpp, tests/libcontact/overlap_depth.cpp.
#pragma once

#include <cmath>
#include <iterator>

#include "shapes/math/select.h"

namespace contact {

using shapes::larger;
using shapes::select;

template <class T>
struct SidePoint {
  T u, h;
  [[gnu::always_inline]] friend SidePoint operator-(const SidePoint& x, const SidePoint& y) {
    return {x.u - y.u, x.h - y.h};
  }
  [[gnu::always_inline]] friend T cross(const SidePoint& x, const SidePoint& y) { return x.u * y.h - x.h * y.u; }
  [[gnu::always_inline]] SidePoint mirrored() const { return {-u, h}; }
};

template <class T>
using MaskOf = decltype(T() < T());

template <class T>
struct SideCorners {
  T depth;                         // D
  T from, to;                      // where the side begins and ends, about 0
  SidePoint<T> before, after;      // the next corners of self there
  SidePoint<T> left[2], right[2];  // the next corners of other from C on either side, nearest first
  SidePoint<T> far;                // a corner of other between left[1] and right[1]
  // Which sides are cuts: the next ones of self, and of other those from C to left[0] and on to left[1]; so to the
  // right
  MaskOf<T> cut_before{}, cut_after{}, cut_left[2]{}, cut_right[2]{};
};

template <class T>
struct SideOverlap {
  T area, u, h, spread;  // its centroid; variance along the side
  T section;             // |Q − P|
  T variance, depth;     // of overlap_depth.h: σ², d
  SidePoint<T> force;    // −∂d/∂x of other
  T moment;              // the same of its turn about the centroid
};

template <class T>
class SideRegion {
 public:
  using P = SidePoint<T>;
  using Mask = MaskOf<T>;

  // Mask of the lanes of which this is the overlap; of others the answer means nothing.
  [[gnu::always_inline]] Mask find(const SideCorners<T>& c) {
    corner_ = {T(0), c.depth};
    right_ = end_of(c.depth, c.to, c.after, c.cut_after, c.right, c.cut_right);
    left_ = end_of(c.depth, -c.from, c.before.mirrored(), c.cut_before, c.left, c.cut_left, true);
    // Each end's corners within the other end's line, and the ends of the side within other.
    const auto within = [](const End& e, const P& x) { return !(e.height(x) < T(0)); };
    const P l = left_.corner.mirrored(), p = left_.crossing.mirrored();
    const P r = right_.corner.mirrored(), q = right_.crossing.mirrored();
    return right_.fits && left_.fits && within(right_, l) && within(right_, p) && within(left_, r) &&
           within(left_, q) && (right_.on_side || held(c, {c.to, T(0)}, T(0))) &&
           (left_.on_side || held(c, {c.from, T(0)}, T(0)));
  }

  // Of parts, after `find`: mask of the lanes where every corner of the overlap is clear of where another side of
  // either part would begin, where it ends at a cut only if that begins, within the other part, at the reflex corner of
  // it, where C is the deepest corner of other in self, and where other is less deep behind this side than it is, or
  // self is, behind any other of the border. Marks are shapes::CutMark; size: that of the pair.
  [[gnu::always_inline]] Mask alone(const SideCorners<T>& c, const T& mark_before, const T& mark_after,
                                    const T (&mark_left)[2], const T (&mark_right)[2], const T& size) const {
    const T m = T(0x1p-40) * size, wide = T(0x1p-30) * size, area = m * size;
    const T deepest = larger(c.depth, larger(c.left[0].h, c.right[0].h)), enough = (deepest + m) * (deepest + m);
    const P from{c.from, T(0)}, to{c.to, T(0)};
    const P its[6] = {corner_, c.left[0], c.left[1], c.right[0], c.right[1], c.far};
    const P own[4] = {from, to, c.before, c.after};
    const auto most = [](const auto& list, const auto& inside) {
      T top = inside(list[0]);
      for (std::size_t i = 1; i < std::size(list); ++i) top = larger(top, inside(list[i]));
      return top;
    };
    // Some corner of the list is farther within a side along `along`.
    const auto farther = [&](const T& top, const P& along) {
      return top > T(0) && top * top > enough * (along.u * along.u + along.h * along.h);
    };
    const auto end = [&](const End& e, const End& across, const P& next, const T& mark_self, const T(&mark)[2],
                         const P(&corners)[2], bool mirror) {
      const auto at = [&](const P& x) { return mirror ? x.mirrored() : x; };
      const P first = at(corners[0]), second = at(corners[1]), r = e.corner.mirrored();
      Mask ok = e.corner.h > m && e.height(e.corner) > area && e.height(corner_) > area && across.height(r) > area &&
                (e.beyond.h < -m || e.height(e.beyond) < -area) && next.h > deepest + m &&
                (!e.has_one || c.depth > e.corner.h + m);
      ok = ok && ((e.on_side && e.start.u - e.crossing.u > wide) || (!e.on_side && e.crossing.h > wide));
      // The end of the side within other.
      const Mask inside = cross(e.corner - e.beyond, e.start - e.beyond) > area && held(c, at(e.start), area);
      ok = ok && (e.on_side || inside) && (!e.cut_self || mark_self == T(1)) &&
           (!e.cut_other || select(e.has_one, mark[1], mark[0]) == T(1));
      ok = ok && (e.on_side || e.cut_self || farther(most(its, [&](const P& x) { return e.height(at(x)); }), e.edge));
      const auto within = [&](const P& x, const P& y) {
        return farther(most(own, [&](const P& v) { return cross(x - y, at(v) - y); }), x - y);
      };
      return ok && (mark[0] > T(0) || within(corner_, first)) &&
             (!e.has_one || mark[1] > T(0) || within(first, second));
    };
    return c.depth > wide && c.left[1].h < deepest && c.right[1].h < deepest && right_.turn.u + left_.turn.u > wide &&
           end(right_, left_, c.after, mark_after, mark_right, c.right, false) &&
           end(left_, right_, c.before.mirrored(), mark_before, mark_left, c.left, true);
  }

  [[gnu::always_inline]] SideOverlap<T> measure() const {
    using std::sqrt;
    SideOverlap<T> out;
    const P origin = left_.crossing.mirrored(), chord = right_.border() - left_.border().mirrored();
    out.section = sqrt(chord.u * chord.u + chord.h * chord.h);
    const T inverse = T(1) / out.section;
    const P t{chord.u * inverse, chord.h * inverse};  // (2)
    const auto turned = [&](const P& x) { return P{t.u * x.u + t.h * x.h, t.u * x.h - t.h * x.u}; };
    const P zero{T(0), T(0)}, straight{out.section, T(0)},
        q = choose(right_.cut() || left_.cut(), turned(right_.crossing - origin), straight),
        r = turned(right_.corner - origin), c = turned(corner_ - origin), l = turned(left_.corner.mirrored() - origin),
        first = turned(left_.turn.mirrored() - origin), second = turned(right_.turn - origin);

    T area(0), fa(0), fm(0), aa(0), mm(0), am(0);  // (3)
    const auto add = [&](const P& x, const P& y) {
      const T w = T(0.5) * cross(x, y);
      area += w;
      fa += w * (x.u + y.u);
      fm += w * (x.h + y.h);
      aa += w * (x.u * x.u + x.u * y.u + y.u * y.u);
      mm += w * (x.h * x.h + x.h * y.h + y.h * y.h);
      am += w * (T(2) * (x.u * x.h + y.u * y.h) + (x.u * y.h + y.u * x.h));
    };
    add(q, r);
    add(r, c);
    add(c, l);
    add(first, second);
    add(second, q);
    const T per_area = T(1) / area, ca = fa * (T(1.0 / 3) * per_area), cm = fm * (T(1.0 / 3) * per_area);
    aa = aa * (T(1.0 / 6) * per_area) - ca * ca;
    mm = mm * (T(1.0 / 6) * per_area) - cm * cm;
    am = am * (T(1.0 / 12) * per_area) - ca * cm;
    out.area = area;
    out.u = origin.u + (ca * t.u - cm * t.h);
    out.h = origin.h + (ca * t.h + cm * t.u);
    out.spread = t.u * t.u * aa - T(2) * (t.u * t.h * am) + t.h * t.h * mm;

    const T beta = am / aa;
    out.variance = mm - beta * am;
    out.depth = sqrt(T(12) * out.variance);
    const T half = T(0.5) * out.variance, scale = out.depth / (T(2) * out.variance * area),
            turn = -(beta * out.depth * inverse);
    T force_a(0), force_m(0), moment(0);
    const auto residual = [&](const P& x) { return (x.h - cm) - beta * (x.u - ca); };
    const auto press = [&](const T& weight, const P& at, const P& along) {  // along a side of other
      force_a -= weight * along.h;
      force_m += weight * along.u;
      moment += weight * ((at.u - ca) * along.u + (at.h - cm) * along.h);
    };
    const auto side = [&](const P& x, const T& rx, const P& y, const T& ry) {
      const P along = y - x;
      const T both = T(2) * (rx * ry), xx = rx * rx, yy = ry * ry;
      press(scale * (T(1.0 / 12) * (T(3) * xx + both + yy) - half), x, along);
      press(scale * (T(1.0 / 12) * (T(3) * yy + both + xx) - half), y, along);
    };
    const T rq = residual(q), rr = residual(r), rc = residual(c), rl = residual(l), rp = residual(zero);
    side(q, rq, r, rr);
    side(r, rr, c, rc);
    side(c, rc, l, rl);
    side(l, rl, zero, rp);
    // How an end of the chord moves: with the crossing, by half of that at a cut, and by half with the corner of other
    // that its border ends in.
    const auto rim = [&](const P& at, const P& own, const P& its, const Mask& cut_self, const Mask& cut_other) {
      const P along = turned(its);
      const T sine = cross(own, its), height = turn * (t.u * own.h - t.h * own.u);
      const T size = select(sine < T(0), -sine, sine);
      const T one = select(cut_self, T(0.5), T(1)), share = select(cut_other, one - T(0.5), one);
      press(share * (select(size > T(0), height, T(0)) / select(size > T(0), size, T(1))), at, along);
    };
    rim(q, right_.own, right_.its, right_.cut_self, right_.cut_other);
    rim(zero, {left_.own.u, -left_.own.h}, {left_.its.u, -left_.its.h}, left_.cut_self, left_.cut_other);
    const P ahead{T(1), T(0)};
    press(select(right_.cut_other, T(-0.5) * turn, T(0)), r, ahead);
    press(select(left_.cut_other, T(0.5) * turn, T(0)), l, ahead);
    out.force = {t.u * force_a - t.h * force_m, t.h * force_a + t.u * force_m};
    out.moment = moment;
    return out;
  }

 private:
  // Where the border of other comes out of self, on the right; on the left in the mirror.
  struct End {
    P corner, crossing, turn;  // R, Q, S'
    P beyond;                  // the corner of other that its side runs to
    P own, its;                // sides of self and other there, as their borders run
    P start, edge;             // the next side of self
    Mask has_one, on_side, fits;
    Mask cut_self, cut_other;  // the overlap ends at a cut there
    [[gnu::always_inline]] Mask cut() const { return cut_self || cut_other; }
    [[gnu::always_inline]] P border() const {  // (4)
      const P x = choose(cut_self, start, crossing), y = choose(cut_other, corner, crossing);
      return {T(0.5) * (x.u + y.u), T(0.5) * (x.h + y.h)};
    }
    // > 0 within the next side of self
    [[gnu::always_inline]] T height(const P& x) const { return cross(edge, x - start); }
  };

  // Within other, as far as its corners are known, by `area` over the length of a side: left of the lines from the
  // corners that the two ends run to over the farthest one, or beside these over the ones next to them.
  [[gnu::always_inline]] Mask held(const SideCorners<T>& c, const P& s, const T& area) const {
    const auto left_of = [&](const P& x, const P& y) {  // where they are one corner there is no line
      const P along = y - x;
      return cross(along, s - x) >= area || (along.u == T(0) && along.h == T(0));
    };
    const P right = right_.beyond, left = left_.beyond.mirrored();
    return (left_of(c.far, right) || (left_of(c.far, c.right[1]) && left_of(c.right[1], right))) &&
           (left_of(left, c.far) || (left_of(left, c.left[1]) && left_of(c.left[1], c.far)));
  }

  [[gnu::always_inline]] static P choose(const Mask& mask, const P& x, const P& y) {
    return {select(mask, x.u, y.u), select(mask, x.h, y.h)};
  }

  [[gnu::always_inline]] End end_of(const T& depth, const T& to, const P& next, const Mask& cut_next,
                                    const P (&corners)[2], const Mask (&cuts)[2], bool mirror = false) const {
    End e;
    e.start = {to, T(0)};
    e.edge = next - e.start;
    const P one = mirror ? corners[0].mirrored() : corners[0], two = mirror ? corners[1].mirrored() : corners[1];
    const T of_corner = e.height(corner_), of_one = e.height(one), of_two = e.height(two);
    const Mask has_one = one.h > T(0) && of_one > T(0), has_two = has_one && two.h > T(0) && of_two > T(0);
    e.has_one = has_one;
    e.corner = choose(has_one, one, corner_);
    e.beyond = choose(has_one, two, one);
    const T inside = select(has_one, of_one, of_corner), outside = select(has_one, of_two, of_one);
    const T fall = e.corner.h - e.beyond.h, leave = inside - outside;
    e.on_side = e.beyond.h <= T(0) && (outside > T(0) || e.corner.h * leave <= inside * fall);
    const T part = select(e.on_side, e.corner.h, inside) / select(e.on_side, fall, leave);
    e.crossing = {e.corner.u + part * (e.beyond.u - e.corner.u),
                  select(e.on_side, T(0), e.corner.h + part * (e.beyond.h - e.corner.h))};
    e.turn = choose(e.on_side, e.crossing, e.start);
    e.own = choose(e.on_side, {T(1), T(0)}, e.edge);
    e.its = e.corner - e.beyond;
    e.cut_self = !e.on_side && cut_next;
    e.cut_other = (has_one && cuts[1]) || (!has_one && cuts[0]);
    e.fits =
        !has_two && of_corner > T(0) && next.h >= depth && next.h >= e.crossing.h && to > T(0) && !(has_one && cuts[0]);
    return e;
  }

  P corner_;
  End left_, right_;
};

}  // namespace contact
