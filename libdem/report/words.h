// Names of the program as words for people.
#pragma once

#include <algorithm>
#include <string>

namespace dem::report {

inline std::string words(std::string name) {
  std::replace(name.begin(), name.end(), '_', ' ');
  return name;
}

}  // namespace dem::report
