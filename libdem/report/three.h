// three.js as it is installed (Debian: libjs-three), to be part of a page.
#pragma once

#include <string>

namespace dem::report {

struct Three {
  std::string library, controls;  // scripts; empty: not found
  std::string why;                // then: what is missing
};
// In the folder that DEM_THREE names, else in /usr/share/javascript/three, else in /usr/share/nodejs/three.
Three find_three();

}  // namespace dem::report
