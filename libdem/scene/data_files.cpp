#include "libdem/scene/data_files.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>

#include "libdem/scene/node.h"

namespace dem {

namespace fs = std::filesystem;

namespace {

struct Collection {
  std::string_view prefix, folder, extension;
};
constexpr std::array<Collection, 4> collections{{{"grain:", "ct_hull_coarse", ".off"},
                                                 {"grain-fine:", "ct_hull_fine", ".off"},
                                                 {"solid:", "solids", ".off"},
                                                 {"ct:", "ct_dims", ".csv"}}};

// Named by the environment; else installed beside the program that runs; else that of the tree that was built, or,
// where that is gone, that of the prefix it was built for.
std::string folder_named(const char* variable, const char* tree, const char* installed) {
  const char* named = std::getenv(variable);
  if (named && *named) return named;
  std::error_code none;
  const fs::path program = fs::read_symlink("/proc/self/exe", none),
                 beside = program.parent_path().parent_path() / "share/contact_mechanics" / installed;
  if (!none && fs::is_directory(beside, none)) return beside.string();
  if (fs::is_directory(tree, none)) return tree;
  return (fs::path(DEM_INSTALLED_FILES) / installed).string();
}

}  // namespace

std::string data_folder() { return folder_named("DEM_DATA", DEM_SOURCE_DATA_DIR, "shapes"); }

std::string scenes_folder() { return folder_named("DEM_SCENES", DEM_SOURCE_SCENES_DIR, "scenes"); }
std::string materials_folder() { return folder_named("DEM_MATERIALS", DEM_SOURCE_MATERIALS_DIR, "materials"); }

std::string resolve_file(const std::string& name, const std::string& base) {
  for (const auto& [prefix, folder, extension] : collections)
    if (name.starts_with(prefix))
      return (fs::path(data_folder()) / folder / (name.substr(prefix.size()) + std::string(extension))).string();
  return fs::absolute(fs::path(base) / name).lexically_normal().string();
}

std::string shipped_name(const std::string& path) {
  const fs::path p(path);
  for (const auto& [prefix, folder, extension] : collections)
    if (p.extension() == extension && p.parent_path() == fs::path(data_folder()) / folder)
      return std::string(prefix) + p.stem().string();
  return path;
}

bool is_shipped(std::string_view name) {
  return std::any_of(collections.begin(), collections.end(), [&](const auto& c) { return name.starts_with(c.prefix); });
}

std::string path_of_scene(const std::string& name) { return (fs::path(scenes_folder()) / (name + ".toml")).string(); }

std::vector<std::string> shipped_scenes() {
  std::vector<std::string> names;
  std::error_code missing;
  for (const auto& entry : fs::directory_iterator(scenes_folder(), missing))
    if (entry.path().extension() == ".toml") names.push_back(entry.path().stem().string());
  std::sort(names.begin(), names.end());
  return names;
}

std::string title_of_scene(const std::string& name) {
  const Node root = read_toml_file(path_of_scene(name));
  const Node* title = root.get("title");
  return title ? title->text : "";
}

std::vector<std::string> shipped_names() {
  std::vector<std::string> names;
  for (const auto& [prefix, folder, extension] : collections) {
    std::error_code missing;
    for (const auto& entry : fs::directory_iterator(fs::path(data_folder()) / folder, missing))
      if (entry.path().extension() == extension) names.push_back(std::string(prefix) + entry.path().stem().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace dem
