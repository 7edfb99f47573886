// Voronoi cells in a box, periodic or cut by planes, by Voro++: plain cells, radical ones, or cells of groups of
// points.
//
//   plain      x is in the cell of the nearest seed
//   radical    of the seed with the least |x − s|² − r²: between spheres its faces are where tangents are equally long
//   groups     cells of seeds with one owner are one cell
//
// Lengths are brought near 1 by a power of two: tolerances of Voro++ are absolute (1e-11). Seeds outside the box or at
// the place of an earlier one have no cell. Rarely Voro++ 0.4.6 leaves out a cut (one cell of 3e5 points seen): where
// the sum of the cells is not the box, cells whose neighbours do not count them as theirs are made anew
// (single_cell.h). Source: C. H. Rycroft, Chaos 19 (2009) 041111. Accuracy: the cells' sum is the box to 1e-10. Cost:
// 10 us a cell in three dimensions. On several threads, the same bits on any number of them. Tests:
// tests/libdem/analysis_voronoi.cpp.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "libdem/analysis/result.h"
#include "libdem/analysis/snapshot.h"
#include "shapes/polyhedron_build.h"

namespace dem::analysis {

struct CellBox {
  Vec3d lower{}, upper{};  // m
  std::array<bool, 3> periodic{};
  std::vector<shapes::HalfSpace> planes;  // normal·x <= offset, unit normals, cut the box
  double volume = 0;                      // of what they leave, m³
};

struct Seeds {
  std::vector<Vec3d> position;       // m
  std::vector<double> radius;        // m; empty: plain cells
  std::vector<std::uint32_t> owner;  // empty: each its own
};

struct Cells {                            // per owner
  std::vector<double> volume;             // m³; 0: no cell
  std::vector<std::uint32_t> neighbours;  // faces to other owners, walls not counted; of single seeds alone
  std::size_t outside = 0, doubled = 0;   // seeds left out
  std::size_t mended = 0;                 // cells made anew
  Surface surface;                        // polygons that do not lie between seeds of one owner; column `owner`
};

// Whether the program was built with Voro++.
bool has_voronoi();
// `owners` > every owner. Throws RunError without Voro++.
Cells cells_of(const CellBox& box, const Seeds& seeds, std::size_t owners, bool surface);

}  // namespace dem::analysis
