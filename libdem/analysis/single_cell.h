// The Voronoi cell of one seed from the definition: the box cut by the plane towards every other seed, nearest first.
// Slow, O(seeds) a cell, and without cases that fail: what the cells of Voro++ are checked and mended with.
// Accuracy: 1e-14 of the cell. Tests: tests/libdem/analysis_voronoi.cpp.
#pragma once

#include "libdem/analysis/voronoi_cells.h"

namespace dem::analysis {

// Volume, m³; seeds with left_out[j] != 0 do not count (empty: all do). Along periodic axes the images next to the box
// are there.
double single_cell_volume(const CellBox& box, const Seeds& seeds, const std::vector<std::uint8_t>& left_out,
                          std::size_t i);

}  // namespace dem::analysis
