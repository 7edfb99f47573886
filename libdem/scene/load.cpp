#include <filesystem>
#include <string>
#include <vector>

#include "libdem/scene/reader.h"
#include "libdem/scene/scene.h"

namespace dem {

Scene load_scene(const std::string& path, const std::vector<std::string>& overrides) {
  if (!std::filesystem::is_regular_file(path)) input_error({path, 0, 0}, "no such scene file");
  Node root = read_toml_file(path);
  apply_overrides(root, overrides);
  Scene scene;
  scene.path = path;
  Errors errors(path);
  read_by_schema(root, std::filesystem::path(path).parent_path().string(), scene, errors);
  errors.throw_if_any();
  check_rules(root, scene, errors);  // needs a scene whose every value is sound
  errors.throw_if_any();
  return scene;
}

}  // namespace dem
