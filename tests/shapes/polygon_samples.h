// Convex polygons of all sorts: regular ones, a bar, a lopsided one.
#pragma once

#include <vector>

#include "shapes/polygon_build.h"

namespace shape_tests {

inline const std::vector<shapes::Polygon>& polygons() {
  static const std::vector<shapes::Polygon> list{
      shapes::make_regular_polygon(3, 1), shapes::make_regular_polygon(4, 1), shapes::make_regular_polygon(7, 1),
      shapes::polygon_hull(std::vector<shapes::Vec3d>{{-1, -0.125, 0}, {1, -0.125, 0}, {1, 0.125, 0}, {-1, 0.125, 0}}),
      shapes::polygon_hull(
          std::vector<shapes::Vec3d>{{-0.5, -0.5, 0}, {1, -0.25, 0}, {0.25, 0.75, 0}, {-0.75, 0.5, 0}})};
  return list;
}

}  // namespace shape_tests
