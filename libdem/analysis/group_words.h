// What bodies may be grouped by; see groups.h. Apart from it, so that scenes and the command line need no snapshots.
#pragma once

#include <string>
#include <vector>

namespace dem::analysis {

inline std::vector<std::string> group_words() {
  return {"species", "size", "shape", "material", "density", "position", "layers", "x", "y", "z"};
}

}  // namespace dem::analysis
