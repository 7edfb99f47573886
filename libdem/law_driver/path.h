// One contact led along a prescribed path: straight between its points, `substeps` steps each. The normal stands still
// along z; slip is along x and y; a rotation turns both bodies about the normal, and what the contact remembers with
// them.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "libdem/law_driver/impact.h"

namespace dem::law_driver {

struct PathPoint {
  double time = 0, overlap = 0, slip_x = 0, slip_y = 0, rotation = 0;  // s, m, m, m, rad; from the start of the path
};

// CSV with columns t, overlap, slip_x, slip_y and maybe rotation; InputError with file:line:column.
std::vector<PathPoint> read_path(const std::string& file);

struct PathResult {
  double peak_overlap = 0, peak_force = 0, least_force = 0, peak_tangential = 0;  // m, N
  double work = 0;    // done on the contact, trapezoidal rule between the steps, J
  double stored = 0;  // at the end, J
  double largest_stored = 0;
  std::array<double, contact::mechanism_count> lost{};  // J
};

// The first point is the state at the start: a contact that is there already has not slipped.
PathResult follow(Drive& drive, const std::vector<PathPoint>& path, int substeps,
                  const std::function<void(const Look&)>& look = {});

}  // namespace dem::law_driver
