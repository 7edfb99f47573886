#include "libdem/scene/data_files.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <utility>

namespace dem {

namespace fs = std::filesystem;

namespace {

constexpr std::array<std::pair<std::string_view, std::string_view>, 3> collections{
    {{"grain:", "ct_hull_coarse"}, {"grain-fine:", "ct_hull_fine"}, {"solid:", "solids"}}};

}  // namespace

std::string data_folder() {
  const char* named = std::getenv("DEM_DATA");
  return named && *named ? named : DEM_SOURCE_DATA_DIR;
}

std::string scenes_folder() {
  const char* named = std::getenv("DEM_SCENES");
  return named && *named ? named : DEM_SOURCE_SCENES_DIR;
}

std::string resolve_file(const std::string& name, const std::string& base) {
  for (const auto& [prefix, folder] : collections)
    if (name.starts_with(prefix))
      return (fs::path(data_folder()) / folder / (name.substr(prefix.size()) + ".off")).string();
  return fs::absolute(fs::path(base) / name).lexically_normal().string();
}

std::string shipped_name(const std::string& path) {
  const fs::path p(path);
  for (const auto& [prefix, folder] : collections)
    if (p.extension() == ".off" && p.parent_path() == fs::path(data_folder()) / folder)
      return std::string(prefix) + p.stem().string();
  return path;
}

bool is_shipped(std::string_view name) {
  return std::any_of(collections.begin(), collections.end(), [&](const auto& c) { return name.starts_with(c.first); });
}

std::vector<std::string> shipped_names() {
  std::vector<std::string> names;
  for (const auto& [prefix, folder] : collections) {
    std::error_code missing;
    for (const auto& entry : fs::directory_iterator(fs::path(data_folder()) / folder, missing))
      if (entry.path().extension() == ".off") names.push_back(std::string(prefix) + entry.path().stem().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace dem
