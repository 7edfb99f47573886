// States of a periodic box at the end of each entry of periodic.deform, where a packing had its time to come to rest,
// and straight lines through them.
#pragma once

#include <vector>

#include "libdem/validate/validation.h"

namespace dem::validate {

struct HeldState {
  double pressure = 0;        // Pa, mean normal stress
  double solid_fraction = 0;  // of spheres of full size: overlaps count twice
  double coordination = 0;    // contacts per body without rattlers
  double rattlers = 0;        // their share
};

// One state for each entry: the last one before the next entry starts, or the run ends.
std::vector<HeldState> held_states(Runs& runs, const std::vector<std::string>& overrides, const std::string& label);

struct Line {  // y = at_zero + slope x, of least squares
  double at_zero = 0, slope = 0;
  double misfit = 0;  // sum of the squares that are left
};
Line line_through(const std::vector<double>& x, const std::vector<double>& y);

}  // namespace dem::validate
