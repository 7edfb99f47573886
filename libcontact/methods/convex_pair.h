// A pair of convex bodies and its difference K = A − B, as gjk_epa and mpr search it; what they find, and the answer.
#pragma once

#include "libcontact/methods/convex_body.h"

namespace contact {

struct ConvexPair {
  ConvexBody a, b;  // lengths in units
  Vec3d d;          // origin of b from that of a
  double size;      // |d| + circumradii
  double small;     // the smaller circumradius
  double tolerance;

  struct Corner {  // of the difference of the cores
    Vec3d at, on_a;
    std::uint32_t vertex_a = ConvexBody::no_vertex, vertex_b = ConvexBody::no_vertex;
  };
  // `near`: a corner along a direction close by.
  Corner support(const Vec3d& n) const { return corner(a.support(n), b.support(-n)); }
  Corner support(const Vec3d& n, const Corner& near) const {
    const Vec3d near_b = near.on_a - near.at - d;
    return corner(a.support(n, &near.on_a), b.support(-n, &near_b));
  }
  bool is_dear() const {  // worth the `near`
    return a.kind == shapes::Kind::potential_particle || b.kind == shapes::Kind::potential_particle;
  }
  double margins() const { return a.margin + b.margin; }
  Vec3d inside() const { return a.inner_centre() - (d + b.inner_centre()); }   // a point of K
  double inner_radius() const { return a.inner_radius() + b.inner_radius(); }  // of a ball of K about it

 private:
  Corner corner(const ConvexBody::Far& p, const ConvexBody::Far& q) const {
    return {p.at - (d + q.at), p.at, p.vertex, q.vertex};
  }
};

// What a method has found, in units.
struct ConvexMeasure {
  bool converged = false;
  int iterations = 0;
  Vec3d normal{};
  double upper = 0;  // proven bound of the gap; infinite: none
  double overlap = 0;
  Vec3d point{};
  bool meets = false;  // `point` lies midway between points of A and B that are as far apart as the gap
};

using ConvexMethod = ConvexMeasure (*)(const ConvexPair& pair);

// Runs a method on a pair; gap and lower bound are the separation along its normal. From the body that gives the same
// bits in both orders. A plane has one normal: the support point against it is the answer, whatever the method.
Contact by_convex_method(const ConvexBody& a, const ConvexBody& b, const Vec3d& offset, const Options& options,
                         ConvexMethod method);

}  // namespace contact
