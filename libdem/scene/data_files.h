// Files that a scene names: shipped grains and solids by a prefix, everything else relative to the scene file.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace dem {

// The folder of the shipped shapes: $DEM_DATA, or shapes/data of the source tree.
std::string data_folder();
// The folder of the shipped scenes: $DEM_SCENES, or libdem/scenes of the source tree.
std::string scenes_folder();

// The folder of the tables of materials: $DEM_MATERIALS, or libdem/data of the source tree.
std::string materials_folder();

// "grain:ma165_01" (20 to 24 vertices), "grain-fine:ma165_01" (48 to 85), "solid:cube" and "ct:all" (measures of
// scanned grains) name shipped files; another path is relative to `base` (the folder of the scene file). The result is
// absolute; nothing is checked.
std::string resolve_file(const std::string& name, const std::string& base);
// The reverse for the shipped files: the name with its prefix, or the path as it is.
std::string shipped_name(const std::string& path);
// True for a name with one of the prefixes.
bool is_shipped(std::string_view name);
// Shipped scenes by name (the file without .toml), sorted; their files and titles.
std::vector<std::string> shipped_scenes();
std::string path_of_scene(const std::string& name);
std::string title_of_scene(const std::string& name);
// All shipped names, sorted, with prefix.
std::vector<std::string> shipped_names();

}  // namespace dem
