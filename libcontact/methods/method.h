// What a contact method is, and the few lines that all methods of smooth bodies share.
//
// A method is a struct without state, with the members
//   name         the name that scenes and options use
//   cost_rank    lower is cheaper; ranks the methods of one pair of kinds (a bench keeps it honest); a number, or a
//                template <class A, class B> of one
//   remark       one clause for the catalogue
//   certified    optional, true when absent: are all answers certified?
//   exact        optional, true when absent: is the gap right to rounding? Else the method is approximate: its gap is
//   the
//                support separation along its own normal, never above the true one, `auto` never takes it, and its own
//                measure counts in a scene that names it
//   reach        optional: the narrowest proven interval that it may be asked for, over the smaller circumradius;
//   absent:
//                0 of an exact method, infinite of others
//   query        static Contact (const Placed<A>&, const Placed<B>&, const Vec3d& offset, const Options&, Cache*),
// one for each pair of kinds A <= B that it answers. It is added by naming it in methods/list.h; the
// table, the catalogue and the property tests follow from the overloads that exist.
#pragma once

#include <limits>

#include "libcontact/contact.h"

namespace contact {

// The pair of shapes A, B (A <= B in kind order) is answered by method M.
template <class M, class A, class B>
concept Answers = requires(const Placed<A>& a, const Placed<B>& b, const Vec3d& offset, const Options& o, Cache* c) {
  { M::query(a, b, offset, o, c) } -> std::same_as<Contact>;
};

// Methods may answer many pairs of one pair of kinds together: bit for bit what `query` answers one by one.
//   static void query_chunk(KindPair<A, B>, std::size_t n, const Body*, const Body*, const Vec3d* offset, const
//   Options&,
//                           Cache*, Contact*);      null cache or n entries
template <class A, class B>
struct KindPair {};
struct Body;

template <class M, class A, class B>
concept AnswersChunks = requires(std::size_t n, const Body* a, const Vec3d* offset, const Options& o, Cache* c,
                                 Contact* out) {
  M::query_chunk(KindPair<A, B>{}, n, a, a, offset, o, c, out);
};

template <class M, class A, class B>
constexpr bool always_certified() {
  if constexpr (requires { bool(M::certified); }) {
    return M::certified;
  } else if constexpr (requires { M::template certified<A, B>; }) {
    return M::template certified<A, B>;
  } else {
    return true;
  }
}

template <class M, class A, class B>
constexpr int cost_of() {
  if constexpr (requires { int(M::cost_rank); })
    return M::cost_rank;
  else
    return M::template cost_rank<A, B>;
}

template <class M>
constexpr bool is_exact() {
  if constexpr (requires { bool(M::exact); })
    return M::exact;
  else
    return true;
}

template <class M>
constexpr double reach_of() {
  if constexpr (requires { M::reach; })
    return M::reach;
  else
    return is_exact<M>() ? 0 : std::numeric_limits<double>::infinity();
}

// The answer as a law sees it that acts on the method's own measure. A proof of separation, without points, stays.
inline void act_on_own_measure(Contact& c) {
  if (c.status == Status::refused || !(c.gap_upper <= std::numeric_limits<double>::max())) return;
  c.gap = -c.method_overlap;
  c.normal = c.method_normal;
  c.patch.centre = c.method_point;
}

// Rounding allowance of a support separation of bodies of this extent L = |offset| + circumradii: rotation matrices are
// orthonormal to 4 eps, a three-term product errs by 1.5 eps, a norm by 2 eps, each times a length below L.
inline double rounding(double extent) { return 16 * epsilon * extent; }

// A support separation above this proves separation, with a full solution agreeing on it whatever its own rounding.
inline double proof_margin(double extent) { return 64 * epsilon * extent; }

inline Contact refused() {
  Contact c;
  c.gap_lower = -std::numeric_limits<double>::infinity();
  c.gap_upper = std::numeric_limits<double>::infinity();
  return c;
}

// The answer for smooth bodies: bounds decide the status, the contact acts midway between the witness points. Lengths
// are given in units of `up`, a power of two.
inline Contact smooth_contact(double gap, double lower, double upper, const Vec3d& normal, const Vec3d& given_a,
                              const Vec3d& given_b, double up = 1, int iterations = 0) {
  const Vec3d point_a = up * given_a, point_b = up * given_b, centre = 0.5 * (point_a + point_b);
  // Every member is named: clearing the answer first would cost as much as a pair of spheres.
  return {.status = lower > 0 ? Status::separated : (upper < 0 ? Status::overlapping : Status::touching),
          .certified = true,
          .gap = gap * up,
          .gap_lower = lower * up,
          .gap_upper = upper * up,
          .normal = normal,
          .point_a = point_a,
          .point_b = point_b,
          .patch = {.centre = centre, .spread = {0, 0, 0, 0, 0, 0}, .weight = 0},
          .method_overlap = -gap * up,
          .method_normal = normal,
          .method_point = centre,
          .iterations = iterations};
}

// The answer when a direction with a support separation above the margin ends an `overlap_only` query; in units of
// `up`.
inline Contact separation_proof(double separation, double extent, const Vec3d& normal, double up, int iterations = 0) {
  Contact c;
  c.status = Status::separated;
  c.certified = true;
  c.gap = c.gap_lower = (separation - rounding(extent)) * up;
  c.gap_upper = std::numeric_limits<double>::infinity();
  c.normal = c.method_normal = normal;
  c.method_overlap = -c.gap;
  c.iterations = iterations;
  return c;
}

// Of two bodies of one kind, the one that a method solves from: an exact choice, so that both orders give the same
// bits.
inline bool seen_from_b(const Vec3d& offset) {
  for (int i = 0; i < 3; ++i)
    if (offset[i] != 0) return offset[i] < 0;
  return false;
}

// The answer of (b, a, −offset) as the answer of (a, b, offset).
inline void exchange(OverlapDepth& d, const Vec3d& offset) {
  d.normal = -d.normal;
  d.point += offset;
}
inline void exchange(Contact& c, const Vec3d& offset) {
  c.normal = -c.normal;
  c.method_normal = -c.method_normal;
  if (!(c.gap_upper <= std::numeric_limits<double>::max())) return;  // refused or stopped at a proof: no points
  const Vec3d point_a = c.point_b + offset;
  c.point_b = c.point_a + offset;
  c.point_a = point_a;
  c.patch.centre += offset;
  c.method_point += offset;
  exchange(c.measure, offset);
}
inline Contact exchanged(Contact c, const Vec3d& offset) {
  exchange(c, offset);
  return c;
}

// Unit vector along a cached axis; false when there is none.
inline bool cached_direction(const Cache* cache, Vec3d& direction) {
  if (cache == nullptr) return false;
  const double square = dot(cache->axis, cache->axis);
  if (!(square > 0x1p-100 && square < 0x1p100)) return false;
  direction = cache->axis * (1 / std::sqrt(square));
  return true;
}

}  // namespace contact
