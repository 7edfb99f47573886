// Contacts of a pair with a polygon that is not convex: one for each region of the overlap.
//
//   region   connected part of the overlap, taken together across the cuts between convex parts, but not across a cut
//            whose reflex corner lies inside the other body: a block in the corner of an L touches both legs (1)
//   edge e   of either outline on the region's border, outward normal n, line n·x = h: its depth is that of the other
//            body's parts in the region                                                                             (2)
//                d(e) = max (h − n·x),   gap = −min d(e),   normal n (of a) or −n (of b)
//   line     normal of the line, depth of the deepest corner of the region                                          (3)
//   disc, ellipse   the edges that they cross, and convex corners inside them within their Voronoi regions (4)
//
// Cuts never give a normal and never double a contact. (2) is the separating axis of contact.h between the convex parts
// that meet, limited to edges of the outlines that are met. The patch of polygons and lines is the region itself:
// centroid of its area and spread along the edge. A second contact of one pair appears with depth 0 where a body comes
// to a second edge, and at once, with the depth that it has, where a corner has slid past a reflex corner beneath the
// surface.
//
// On request the depth of overlap_depth.h. Where a region ends at a cut its chord ends midway between where what it has
// of either outline does, and the cut moves with the body that it is of: the force is the slope of the depth there too.
// Patch and depth of a region of two parts about one corner are in closed form (side_overlap.h); others are clipped.
//
// Bounds: 32 eps L on (2)–(4). Cost: pairs of parts whose circles meet, each a clip, and a few operations for every
// other part: two crosses in one region 1 us. Not on the heap while convex parts have up to 16 corners, polygons up to
// 64 parts, and no more than 16 pairs of parts overlap. Tests: tests/libcontact/polygon_regions.cpp,
// polygon_region_slope.cpp.
#pragma once

#include <cstddef>

#include "libcontact/dispatch.h"
#include "libcontact/export.h"
#include "libcontact/methods/polygon_pair.h"

namespace contact {

// More regions than this in one pair: the shallowest are left out, and none of the answers is certified.
inline constexpr std::size_t max_regions = 8;

// Whether one of the two is a polygon that is not convex: then the pair may touch in several regions.
CONTACT_API bool meets_in_regions(const Body& a, const Body& b);

// A corner of a convex part of one body behind a side of a part of the other; kind none: something else answered.
struct PartSide {
  SideContact at;
  std::uint32_t part_a = 0, part_b = 0;
};

// What a search of two polygons learns beside the regions.
struct RegionSearch {
  double clearance = 0;        // m, proven: convex parts that share none are farther apart; 0: nothing is known
  PartSide side[max_regions];  // of each region: what answered it, where it lies about one corner
};

// Overlapping regions of a pair in kind order, into out[0 … max_regions): their number. Polygon with disc, ellipse,
// polygon or line. A pair out of range gives one answer, refused.
CONTACT_API std::size_t polygon_regions(const Body& a, const Body& b, const Vec3d& offset, const Options& options,
                                        Contact* out, RegionSearch* search = nullptr);

}  // namespace contact
