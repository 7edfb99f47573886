#include "libcontact/methods/mpr.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "libcontact/methods/convex_pair.h"
#include "libcontact/scale.h"

namespace contact {

namespace {

using Corner = ConvexPair::Corner;

constexpr int step_limit = 200;

// Of the bodies with their margins; n unit.
Corner support(const ConvexPair& pair, const Vec3d& n, const Corner* near = nullptr) {
  const Corner c = near != nullptr && pair.is_dear() ? pair.support(n, *near) : pair.support(n);
  return {c.at + pair.margins() * n, c.on_a + pair.a.margin * n};
}

// Which way the ray from p through the origin passes the edge from u to v: positive on its left, seen from p.
double side(const Vec3d& p, const Corner& u, const Corner& v) { return -dot(cross(u.at, v.at), p); }

Vec3d direction(const Vec3d& v) {
  Vec3d n;
  length_and_direction(v, n);
  return n;
}

// A point of K, and midway between those of A and B that it is the difference of.
struct Place {
  Vec3d at, middle;
};
Place place(const Corner& c) { return {c.at, c.on_a - 0.5 * c.at}; }
// Where the ray passes the portal.
Place on_ray(const Vec3d& p, const Corner& u, const Corner& v, const Corner& w) {
  const double a = std::fmax(side(p, v, w), 0), b = std::fmax(side(p, w, u), 0), c = std::fmax(side(p, u, v), 0);
  const double sum = a + b + c;
  if (!(sum > 0)) return place(u);
  const Vec3d at = (1 / sum) * (a * u.at + b * v.at + c * w.at);
  return {at, (1 / sum) * (a * u.on_a + b * v.on_a + c * w.on_a) - 0.5 * at};
}

// Which way the ray passes a point of the plane.
double side(const Vec3d& p, const Corner& u) { return p.x * u.at.y - p.y * u.at.x; }
// Where it passes the segment to a point on its other side.
Place on_ray(const Vec3d& p, const Corner& u, const Corner& v) {
  const double a = std::abs(side(p, v)), b = std::abs(side(p, u)), sum = a + b;
  if (!(sum > 0)) return place(u);
  const Vec3d at = (1 / sum) * (a * u.at + b * v.at);
  return {at, (1 / sum) * (a * u.on_a + b * v.on_a) - 0.5 * at};
}

class Search {
 public:
  explicit Search(const ConvexPair& pair) : pair_(pair), p_(pair.inside()), ball_(pair.inner_radius()) {
    const double distance = norm(p_);
    if (distance > 0x1p-20 * ball_) return;
    p_ = {0.5 * ball_, 0, 0};
    ball_ = 0.5 * ball_ - distance;
  }

  ConvexMeasure run() { return pair_.a.is_flat() ? in_the_plane() : in_space(); }

 private:
  ConvexMeasure in_space();
  ConvexMeasure in_the_plane();
  ConvexMeasure apart(const Vec3d& n, const Corner& c) const {
    ConvexMeasure m = answer(n, place(c), true);
    m.upper = norm(c.at);  // (4)
    return m;
  }
  ConvexMeasure overlapping(const Vec3d& n, const Place& x, bool converged) const {
    ConvexMeasure m = answer(n, x, converged);
    const Vec3d e = x.at - p_;
    const double t = std::clamp(-dot(p_, e) / dot(e, e), 0.0, 1.0);
    m.upper = std::min(norm(x.at), norm(p_ + t * e) - (1 - t) * ball_);  // (4)
    return m;
  }
  ConvexMeasure answer(const Vec3d& n, const Place& x, bool converged) const {
    ConvexMeasure m;
    m.converged = converged;
    m.iterations = steps_;
    m.normal = n;
    m.overlap = dot(n, support(pair_, n).at);  // (3)
    m.point = x.middle;
    return m;
  }

  const ConvexPair& pair_;
  Vec3d p_;      // inner point
  double ball_;  // radius of a ball in K about it
  double stop_ = std::fmax((pair_.tolerance > 0 ? pair_.tolerance : 1e-10) * pair_.small, 0x1p-46 * pair_.size);
  int steps_ = 0;
};

ConvexMeasure Search::in_the_plane() {
  Vec3d n = direction(-p_);
  Corner v1 = support(pair_, n);
  if (!(dot(v1.at, n) > 0)) return apart(n, v1);  // (1)
  double s1 = side(p_, v1);
  if (!(std::abs(s1) > 0x1p-44 * pair_.size * norm(p_))) return overlapping(n, place(v1), true);
  // The line through p and v1 turns towards the origin until the ray lies between its ends.
  Corner v2;
  for (;; ++steps_) {
    n = direction({p_.y - v1.at.y, v1.at.x - p_.x, 0});
    if (dot(n, p_) > 0) n = -n;
    v2 = support(pair_, n);
    if (!(dot(v2.at, n) > 0)) return apart(n, v2);
    const double s2 = side(p_, v2);
    if (!(s1 * s2 > 0)) break;
    if (steps_ > step_limit) return overlapping(n, place(v1), false);
    v1 = v2;
    s1 = s2;
  }
  for (;; ++steps_) {
    n = direction({v1.at.y - v2.at.y, v2.at.x - v1.at.x, 0});
    if (dot(n, v1.at - p_) < 0) n = -n;
    if (steps_ > step_limit) return overlapping(n, on_ray(p_, v1, v2), false);
    const Corner v3 = support(pair_, n);
    if (!(dot(v3.at, n) > 0)) return apart(n, v3);                                        // (1)
    if (dot(v3.at - v1.at, n) <= stop_) return overlapping(n, on_ray(p_, v1, v2), true);  // (2)
    (side(p_, v3) * s1 > 0 ? v1 : v2) = v3;
  }
}

ConvexMeasure Search::in_space() {
  const Vec3d ray = direction(-p_);
  Vec3d n = ray;
  Corner v1 = support(pair_, n);
  if (!(dot(v1.at, n) > 0)) return apart(n, v1);  // (1)
  const Vec3d across = cross(v1.at, p_);
  // K's farthest point lies on the ray.
  if (!(norm(across) > 0x1p-44 * pair_.size * norm(p_))) return overlapping(n, place(v1), true);
  n = direction(across);
  Corner v2 = support(pair_, n);
  if (!(dot(v2.at, n) > 0)) return apart(n, v2);
  n = direction(cross(v1.at - p_, v2.at - p_));
  if (dot(n, p_) > 0) {
    std::swap(v1, v2);
    n = -n;
  }
  Corner v3;
  for (;; ++steps_) {
    if (steps_ > step_limit) {
      ConvexMeasure m = answer(ray, place(v1), false);
      m.upper = norm(v1.at);
      return m;
    }
    v3 = support(pair_, n, &v1);
    if (!(dot(v3.at, n) > 0)) return apart(n, v3);
    if (side(p_, v1, v3) > 0) {
      v2 = v3;
      n = direction(cross(v1.at - p_, v3.at - p_));
    } else if (side(p_, v3, v2) > 0) {
      v1 = v3;
      n = direction(cross(v3.at - p_, v2.at - p_));
    } else {
      break;
    }
  }
  for (;; ++steps_) {
    const Vec3d normal = cross(v2.at - v1.at, v3.at - v1.at);
    n = direction(dot(normal, v1.at - p_) < 0 ? -normal : normal);
    if (steps_ > step_limit) return overlapping(n, on_ray(p_, v1, v2, v3), false);
    const Corner v4 = support(pair_, n, &v1);
    if (!(dot(v4.at, n) > 0)) return apart(n, v4);                                            // (1)
    if (dot(v4.at - v1.at, n) <= stop_) return overlapping(n, on_ray(p_, v1, v2, v3), true);  // (2)
    // Of the three triangles at v4 the one that the ray passes through.
    const Vec3d c = cross(v4.at, p_);
    if (dot(v1.at, c) > 0)
      (dot(v2.at, c) > 0 ? v1 : v3) = v4;
    else
      (dot(v3.at, c) > 0 ? v2 : v1) = v4;
  }
}

ConvexMeasure measure(const ConvexPair& pair) { return Search(pair).run(); }

}  // namespace

Contact Mpr::answer(const ConvexBody& a, const ConvexBody& b, const Vec3d& offset, const Options& options) {
  return by_convex_method(a, b, offset, options, measure);
}

}  // namespace contact
