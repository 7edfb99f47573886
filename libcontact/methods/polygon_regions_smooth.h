// Regions in which a disc or an ellipse overlaps a polygon that is not convex: (1) and (4) of polygon_regions.h.
#pragma once

#include <cstddef>

#include "libcontact/methods/region_parts.h"

namespace contact {

std::size_t disc_regions(double radius, const Placed<shapes::Polygon>& b, const Vec3d& offset, RegionList list);
std::size_t ellipse_regions(const Placed<shapes::Ellipse>& a, const Placed<shapes::Polygon>& b, const Vec3d& offset,
                            RegionList list);

}  // namespace contact
