// Polygons, convex or not, by the area of their overlap and the line of contact.
//
//   A, x_c   area and centroid of the overlap
//   S = Σ n·length over those sides of the overlap that lie on a's outline; on b's outline the sum is −S         (1)
//   method_overlap = A/|S|,   method_normal = S/|S|,   method_point = x_c                                       (2)
//
// |S| is the length of the contact line: of a region that both outlines cross twice, the chord of the crossings, which
// S is normal to. S is the gradient of A as b moves, so that a force A k/|S| along S, or any other function of A, comes
// from a potential; the mean depth (2) does so while |S| is constant. Cuts between convex parts give no side.
//
// The gap of convex polygons is the support separation along the normal, with gap <= −(depth of x_c in a + in b). Of
// others gap and bounds are those of `planar`. Apart, touching, or one inside the other (S = 0), `planar` answers.
//
// Source: Y. T. Feng & D. R. J. Owen, Eng. Comput. 21 (2004) 265, for a force along the gradient of an area. Cost: one
// clip for each pair of parts whose circles meet, 0.6 us a pair of octagons. Accuracy: measures 32 eps L in length
// where |S| is of the order of L. Tests: tests/libcontact/approximate_polygons.cpp, contract.cpp.
#pragma once

#include "libcontact/contact.h"
#include "libcontact/export.h"

namespace contact {

struct CONTACT_API Clip {
  static constexpr const char* name = "clip";
  static constexpr int cost_rank = 40;
  static constexpr const char* remark = "area of the overlap over the length of the contact line (Feng & Owen 2004)";
  static constexpr bool exact = false;

  static Contact query(const Placed<shapes::Polygon>& a, const Placed<shapes::Polygon>& b, const Vec3d& offset,
                       const Options& options, Cache* cache);
};

struct ClippedArea {
  double area = 0;              // A, m²
  Vec3d surface{}, centroid{};  // S, m; x_c relative to a's origin, m
  double moment = 0;            // ∫(x − x_c) × n ds over the same sides, about z, m²
};

CONTACT_API ClippedArea clipped_area(const Placed<shapes::Polygon>& a, const Placed<shapes::Polygon>& b,
                                     const Vec3d& offset);

}  // namespace contact
