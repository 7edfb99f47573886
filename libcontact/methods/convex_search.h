// What is known of the gap of a pair while gjk_epa searches: every support point gives a lower bound of it, every point
// of K, or ball in K about the origin, an upper one. Inner header.
#pragma once

#include <cmath>
#include <limits>

#include "libcontact/methods/convex_pair.h"

namespace contact {

// A part of K that its corners span, and the point of it that is nearest to the origin.
struct Simplex {
  ConvexPair::Corner p[4];
  double weight[4] = {1, 0, 0, 0};
  int count = 0, full = 4;  // corners, and how many of them hold an inside: 3 in the plane

  Vec3d nearest() const {
    Vec3d v{};
    for (int i = 0; i < count; ++i) v += weight[i] * p[i].at;
    return v;
  }
  Vec3d on_a() const {
    Vec3d v{};
    for (int i = 0; i < count; ++i) v += weight[i] * p[i].on_a;
    return v;
  }
  // Leaves the corners whose inside holds the nearest point; the weights are positive and sum to 1.
  void reduce();
};

struct ConvexSearch {
  const ConvexPair& pair;
  double ball;  // bound of the gap of the cores by the balls inside them
  double lower = -std::numeric_limits<double>::infinity(), upper = std::numeric_limits<double>::infinity();
  Vec3d normal{};  // that gave `lower`
  Simplex near{};  // of K, apart: the nearest known; else the face of the polytope that gave `normal`
  bool dear;       // the corner before is kept
  ConvexPair::Corner last{};
  int steps = 0;

  explicit ConvexSearch(const ConvexPair& p)
      : pair(p), ball(norm(p.inside()) - (p.inner_radius() - p.margins())), dear(p.is_dear()) {
    near.full = p.a.is_flat() ? 3 : 4;
  }

  // The farthest corner along a unit n, which bounds the gap of the cores.
  ConvexPair::Corner probe(const Vec3d& n) {
    const ConvexPair::Corner w = dear && steps > 0 ? pair.support(n, last) : pair.support(n);
    if (dear) last = w;
    if (const double value = -dot(n, w.at); value > lower) lower = value, normal = n;
    ++steps;
    return w;
  }
  // The simplex of one point between the bodies.
  void set_near(const Vec3d& at, const Vec3d& on_a) {
    near.p[0] = {at, on_a};
    near.weight[0] = 1;
    near.count = 1;
  }
  // Rounding of a separation, and the width at which the search ends: of corners alone it does by itself.
  double rounding() const { return 0x1p-46 * pair.size; }
  double stop_width() const {
    const double part = pair.tolerance > 0 ? pair.tolerance : pair.a.has_corners() && pair.b.has_corners() ? 0 : 1e-10;
    return std::fmax(part * pair.small, rounding());
  }
  double width() const { return std::fmin(upper, ball) - lower; }
  bool closed() const { return width() <= stop_width(); }
  // Nothing is left to finish.
  bool finished() const { return pair.tolerance > 0 ? closed() : width() <= 2 * rounding(); }
};

// The depth of the origin in K, which lies in a tetrahedron of corners of it, or a triangle in the plane, the border
// included.
void expand(ConvexSearch& search, Simplex full);

// Better normals from the features of polyhedra and polygons that the corners of `near` name.
void finish_on_features(ConvexSearch& search);

// Better normals, and nearest points where the bodies are apart, near those found, by the curvature of round bodies.
void finish_on_curvature(ConvexSearch& search);

}  // namespace contact
