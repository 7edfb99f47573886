// Simple polygon, convex or not, in the plane z = 0 of its body frame. Canonical: counter-clockwise, first the vertex
// of lowest (x, y), no vertex on the line through its neighbours. Built by shapes/polygon_build.h.
//
// A polygon that is not convex is cut into convex parts, from every reflex corner along its bisector to the first wall
// or earlier cut (shapes/polygon_parts.h). The cuts follow from the outline alone: however a body was put together, it
// is the same body. What is an edge of the outline and what is a cut stays known.
//
// Bands along chains (shapes/polygon_band.h) are walls alone: their vertices begin with the chain, and a closed one is
// a ring, with a second border about its hole.
#pragma once

#include <cstdint>
#include <vector>

#include "shapes/math/vec.h"
#include "shapes/polygon_rows.h"

namespace shapes {

struct Polygon {
  static constexpr const char* name = "polygon";
  static constexpr std::uint32_t none = 0xffffffffu;

  struct Part {                       // convex, counter-clockwise; side k runs from vertex k to vertex k + 1
    std::vector<Vec3d> vertices;      // m
    std::vector<Vec3d> normals;       // unit, outward
    std::vector<double> offsets;      // m
    std::vector<std::uint32_t> edge;  // of the outline, that side k lies on; none: a cut
    Vec3d centre;                     // of a circle about the part, m
    double radius = 0;                // of that circle, m
    // Of vertex k and of side k; of bands none.
    std::vector<CornerRow> corner_rows;
    std::vector<SideRow> side_rows;
  };
  struct Seam {  // where two parts meet along a cut
    std::uint32_t part[2];
    Vec3d end[2];             // m
    std::uint32_t corner[2];  // reflex corners of the outline at the ends of the whole cut; the second may be none
  };

  std::vector<Vec3d> vertices;  // m, counter-clockwise, z = 0
  std::vector<Vec3d> normals;   // unit, outward, of the edge from vertex i to vertex i + 1
  std::vector<double> offsets;  // m, normals[i]·x = offsets[i] on edge i
  std::vector<Part> parts;      // one, the polygon itself, when it is convex
  std::vector<Seam> seams;
  double area = 0;              // m²
  Vec3d centroid{};             // m
  double second_moment = 0;     // ∫|x − centroid|² dA, m⁴
  double circumradius = 0;      // m, largest |vertex|
  double inscribed_radius = 0;  // m, least distance from the origin to an edge's line where convex; 0 otherwise
  bool convex = false;
  std::uint32_t second_border = 0;  // its first vertex; of an outline, which has one border: the number of vertices

  // The neighbours of a vertex along its border.
  std::uint32_t next(std::uint32_t i) const {
    return i + 1 == second_border ? 0 : i + 1 == vertices.size() ? second_border : i + 1;
  }
  std::uint32_t before(std::uint32_t i) const {
    return i == 0 ? second_border - 1 : (i == second_border ? static_cast<std::uint32_t>(vertices.size()) : i) - 1;
  }
};

}  // namespace shapes
