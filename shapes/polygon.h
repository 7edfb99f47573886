// Simple polygon, convex or not, in the plane z = 0 of its body frame. Canonical: counter-clockwise, first the vertex
// of lowest (x, y), no vertex on the line through its neighbours. Built by shapes/polygon_build.h.
#pragma once

#include <vector>

#include "shapes/math/vec.h"

namespace shapes {

struct Polygon {
  static constexpr const char* name = "polygon";
  std::vector<Vec3d> vertices;  // m, counter-clockwise, z = 0
  std::vector<Vec3d> normals;   // unit, outward, of the edge from vertex i to vertex i + 1
  std::vector<double> offsets;  // m, normals[i]·x = offsets[i] on edge i
  double area = 0;              // m²
  Vec3d centroid{};             // m
  double second_moment = 0;     // ∫|x − centroid|² dA, m⁴
  double circumradius = 0;      // m, largest |vertex|
  double inscribed_radius = 0;  // m, least distance from the origin to an edge's line where convex; 0 otherwise
  bool convex = false;
};

}  // namespace shapes
