#include "libdem/scene/format_words.h"

#include <algorithm>

#include "libdem/scene/schema.h"

namespace dem {

bool some_key_holds(std::string_view word) {
  const std::vector<std::string> paths = key_paths();
  return std::any_of(paths.begin(), paths.end(),
                     [&](const std::string& path) { return path.find(word) != std::string::npos; });
}

}  // namespace dem
