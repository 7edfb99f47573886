// Bodies of the plane z = 0: discs, ellipses, convex polygons, lines. The support separation is a function of one
// angle:
//
//   f(n) = n·d − h_A(n) − h_B(−n),   gap = max f                                                              (1)
//
// Its maximum lies at an edge normal, at the direction between the nearest two vertices, or, with an ellipse, at the
// normal of a foot of a vertex on it; every candidate is a lower bound, so the largest is the answer              (2)
// Two ellipses: Newton's step s = r/(K + f) along the tangent, r = t·(d − x_A + x_B), K the sum of the radii of
// curvature a²b²/h³; max f <= f + r²/(2(m + f)) with m the least K, where m + f > 0 (3) Two polygons act on the overlap
// itself: the centroid of its area and its spread along the edge are the patch.
//
// Disc and ellipse against disc and line, and disc against ellipse, are the sections of their counterparts in space by
// their plane of symmetry, in which the nearest points lie. Of a polygon that is not convex: apart, the nearest of its
// convex parts; overlapping, the deepest of the regions of polygon_regions.h. What a cache keeps of a pair: an axis
// along which it was apart, or the side that answered (polygon_pair.h). Cost: ellipses 0.16 us, in chunks 0.05 us with
// AVX-512, 0.07 us AVX2; octagons 0.29 us, 0.17 us from the cache, disc or ellipse and octagon 0.2–0.3 us; apart along
// a cached axis 0.03–0.06 us. Accuracy: 32 eps L, certified; two ellipses that overlap by more than m: best of 18
// starts, not certified. Tests: tests/libcontact/contract, ellipse_kernels, polygon_pair; tests/program/contact_cases.
#pragma once

#include "libcontact/export.h"
#include "libcontact/methods/method.h"

namespace contact {

struct CONTACT_API Planar {
  static constexpr const char* name = "planar";
  static constexpr int cost_rank = 0;
  static constexpr const char* remark = "plane bodies: closed forms, edge axes and vertices, one-angle Newton";
  template <class A, class B>
  static constexpr bool certified = !(std::is_same_v<A, shapes::Ellipse> && std::is_same_v<B, shapes::Ellipse>);

  static Contact query(const Placed<shapes::Disc>& a, const Placed<shapes::Disc>& b, const Vec3d& offset,
                       const Options& options, Cache* cache);
  static Contact query(const Placed<shapes::Disc>& a, const Placed<shapes::Ellipse>& b, const Vec3d& offset,
                       const Options& options, Cache* cache);
  static Contact query(const Placed<shapes::Disc>& a, const Placed<shapes::Polygon>& b, const Vec3d& offset,
                       const Options& options, Cache* cache);
  static Contact query(const Placed<shapes::Disc>& a, const Placed<shapes::Line>& b, const Vec3d& offset,
                       const Options& options, Cache* cache);
  static Contact query(const Placed<shapes::Ellipse>& a, const Placed<shapes::Ellipse>& b, const Vec3d& offset,
                       const Options& options, Cache* cache);
  static void query_chunk(KindPair<shapes::Ellipse, shapes::Ellipse>, std::size_t n, const Body* a, const Body* b,
                          const Vec3d* offset, const Options& options, Cache* cache, Contact* out);
  static Contact query(const Placed<shapes::Ellipse>& a, const Placed<shapes::Polygon>& b, const Vec3d& offset,
                       const Options& options, Cache* cache);
  static Contact query(const Placed<shapes::Ellipse>& a, const Placed<shapes::Line>& b, const Vec3d& offset,
                       const Options& options, Cache* cache);
  static Contact query(const Placed<shapes::Polygon>& a, const Placed<shapes::Polygon>& b, const Vec3d& offset,
                       const Options& options, Cache* cache);
  static Contact query(const Placed<shapes::Polygon>& a, const Placed<shapes::Line>& b, const Vec3d& offset,
                       const Options& options, Cache* cache);
};

}  // namespace contact
