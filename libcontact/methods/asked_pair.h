// A pair of convex bodies as another library asks about it by support functions, and what its questions have proven of
// the gap: whatever that library makes of the answers. Inner header.
//
//   separation = max over the questions n of n·(b − a),  a, b the farthest points of A along n and of B along −n   (1)
//   nearest    = least distance of the origin from the simplices of a − b that come nearer with each question    (2)
//
// After `question_limit` questions both bodies are a point: the loops of libccd and FCL, which have no cap of their
// own, end there.
#pragma once

#include <cmath>
#include <limits>

#include "libcontact/methods/convex_search.h"
#include "libcontact/scale.h"

namespace contact {

class AskedPair {
 public:
  static constexpr int question_limit = 1000;
  // How far what a library says may lie from what its own direction gives, over the extent.
  static constexpr double agreement = 1e-3;

  explicit AskedPair(const ConvexPair& pair) : pair_(pair) {}

  const ConvexPair& pair() const { return pair_; }
  bool given_up() const { return questions_ > question_limit; }
  double separation() const { return separation_; }

  // Which body a library holds in its hands.
  struct Side {
    AskedPair* asked;
    bool first;
  };
  static Vec3d farthest(const Side& side, const Vec3d& n) {
    AskedPair& asked = *side.asked;
    if (asked.given_up()) return {};
    Vec3d unit;
    length_and_direction(n, unit);
    return side.first ? asked.of_a(unit) : asked.of_b(unit);
  }
  static Vec3d inside(const Side& side) {
    const ConvexPair& pair = side.asked->pair_;
    return side.first ? pair.a.inner_centre() : pair.d + pair.b.inner_centre();
  }

  // A rotation that is not finite must not enter the loops of a library; the caller of a method refuses it.
  bool has_finite_answers() const {
    for (const Vec3d& n : {Vec3d{1, 0, 0}, Vec3d{0, 1, 0}, Vec3d{0, 0, 1}})
      if (!is_finite(pair_.support(n).at)) return false;
    return true;
  }
  // max of n·x over A − B.
  double depth_along(const Vec3d& n) const { return dot(n, pair_.support(n).at) + pair_.margins(); }

  // By the question that separates most.
  ConvexMeasure apart(bool agreed) const {
    ConvexMeasure m;
    m.normal = normal_;
    m.overlap = questions_ > 0 ? -separation_ : 0;
    m.point = middle_;
    m.upper = near_.count > 0 && near_.count < 4 ? norm(near_.nearest()) : std::numeric_limits<double>::infinity();
    m.iterations = questions_;
    m.converged = agreed && !given_up();
    return m;
  }
  // By what a library says.
  ConvexMeasure as_told(const Vec3d& normal, double overlap, const Vec3d& point, bool agreed) const {
    ConvexMeasure m = apart(agreed);
    m.normal = normal;
    m.overlap = overlap;
    m.point = point;
    return m;
  }

 private:
  Vec3d of_a(const Vec3d& n) {
    ++questions_;
    toward_ = n;
    return on_a_ = pair_.a.support(n).at + pair_.a.margin * n;
  }
  Vec3d of_b(const Vec3d& n) {
    const Vec3d on_b = pair_.d + (pair_.b.support(n).at + pair_.b.margin * n);
    if (!(n == -toward_)) return on_b;  // of another question
    if (const double s = dot(toward_, on_b - on_a_); s > separation_) {
      separation_ = s;
      normal_ = toward_;
      middle_ = 0.5 * (on_a_ + on_b);
    }
    if (near_.count == 4) return on_b;  // the origin is inside
    Simplex next = near_;
    next.p[next.count++] = {on_a_ - on_b, on_a_};
    if (next.count > 1) next.reduce();
    if (near_.count == 0 || next.count == 4 || norm(next.nearest()) < norm(near_.nearest())) near_ = next;
    return on_b;
  }

  const ConvexPair& pair_;
  int questions_ = 0;
  Vec3d toward_{}, on_a_{};                                       // the last question about A
  double separation_ = -std::numeric_limits<double>::infinity();  // (1)
  Vec3d normal_{0, 0, 1}, middle_{};
  Simplex near_{};  // (2)
};

}  // namespace contact
