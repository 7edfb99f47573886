#include "tests/fuzz/scene_words.h"

#include "libdem/scene/schema.h"

std::vector<std::string> scene_words() {
  std::vector<std::string> words;
  for (const std::string& path : dem::key_paths()) {
    words.push_back(path.substr(path.rfind('.') + 1));
    for (const std::string& word : dem::find_key(path)->choices) words.push_back('"' + word + '"');
  }
  for (const char* condition : {"time > 0", "energy < 1e-9 and contacts_per_body >= 2", "rain.shower.count > 3"})
    words.push_back('"' + std::string(condition) + '"');
  return words;
}
