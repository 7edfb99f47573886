// One number or one group per body, to colour pictures and movies by: deformation as it shows.
//
//   bands fixed at a reference frame, so that they go with the bodies (groups.h): layers (along gravity), layers_x,
//     layers_y, layers_z, position (lower and upper half), density, sizes; bodies that the reference lacks have none
//   since the reference (displacement.h): displacement |u| [m], strain (deviator of E) [1], volume_change [1], rotation
//     |∇ × u| [rad], non_affine [m]
//   of this frame: vorticity |∇ × v| [1/s], shear_rate [1/s], contacts (with other bodies and walls, each once) [1]
// Cost: that of displacement.h. Tests: tests/libdem/analysis_body_colours.cpp.
#pragma once

#include <string>
#include <vector>

#include "libdem/analysis/snapshot.h"

namespace dem::analysis {

struct BodyColours {
  std::string label;               // with the unit
  std::vector<std::string> names;  // not empty: values are places in it, else quantities
  std::vector<double> values;      // of each body; not a number: it has none
};

const std::vector<std::string>& body_colour_words();
// Whether it compares with another frame.
bool needs_reference(const std::string& word);
// Throws InputError with the words that there are when it is none of them. reference null: the snapshot itself.
BodyColours body_colours(const Snapshot& snapshot, const std::string& word, const Snapshot* reference);

}  // namespace dem::analysis
