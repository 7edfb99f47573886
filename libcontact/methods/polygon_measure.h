// What the approximate methods of polygons share: the pair in units, and the answer along the normal that they find.
#pragma once

#include <limits>

#include "libcontact/methods/method.h"
#include "libcontact/methods/planar_outline.h"

namespace contact {

struct PlacedPolygons {
  const shapes::Polygon &a, &b;
  Placement place_a, place_b;  // units, about the origin of a
  double size;                 // twice the extent, units
};

struct PolygonMeasure {
  bool found = false;  // else the exact method answers
  double overlap = 0;
  Vec3d normal{}, point{};
  Vec3d inside{};  // in both bodies
};

// In units of `up`; size 0 when out of range.
PlacedPolygons placed_polygons(const Placed<shapes::Polygon>& a, const Placed<shapes::Polygon>& b, const Vec3d& offset,
                               double& up);

using PolygonMethod = PolygonMeasure (*)(const PlacedPolygons& pair);

// Runs a method from the body that gives the same bits in both orders. Of convex polygons gap and bounds belong to the
// normal found; of others they are those of `planar`.
Contact by_polygon_method(const Placed<shapes::Polygon>& a, const Placed<shapes::Polygon>& b, const Vec3d& offset,
                          PolygonMethod method);

}  // namespace contact
