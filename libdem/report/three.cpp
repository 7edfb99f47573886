#include "libdem/report/three.h"

#include <cstdlib>
#include <filesystem>
#include <vector>

#include "libdem/io/files.h"

namespace dem::report {

namespace {

namespace fs = std::filesystem;

// A script in a page ends at the first "</script".
bool fits(const std::string& script) { return !script.empty() && script.find("</script") == std::string::npos; }

}  // namespace

Three find_three() {
  std::vector<fs::path> folders{"/usr/share/javascript/three", "/usr/share/nodejs/three"};
  if (const char* named = std::getenv("DEM_THREE"); named != nullptr && *named != 0) folders = {named};
  for (const fs::path& folder : folders) {
    Three three{io::read_file(folder / "build/three.min.js"),
                io::read_file(folder / "examples/js/controls/OrbitControls.js"), ""};
    if (fits(three.library) && fits(three.controls)) return three;
    if (!three.library.empty())
      return {"", "",
              folder.string() + " has no examples/js/controls/OrbitControls.js: not the version of libjs-three"};
  }
  return {"", "", "libjs-three is not installed"};
}

}  // namespace dem::report
