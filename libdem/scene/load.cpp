#include <filesystem>
#include <string>
#include <vector>

#include "libdem/scene/reader.h"
#include "libdem/scene/scene.h"

namespace dem {

Scene load_scene(const std::string& path, const std::vector<std::string>& overrides) {
  if (!std::filesystem::is_regular_file(path)) input_error({path, 0, 0}, "no such scene file");
  std::vector<std::string> files;
  Node root = read_with_includes(path, files);
  apply_overrides(root, overrides);
  Scene scene;
  scene.path = path;
  Errors errors(files);
  read_by_schema(root, scene, errors);
  errors.throw_if_any();
  apply_libraries(root, scene, errors);
  errors.throw_if_any();
  check_rules(root, scene, errors);  // needs a scene whose every value is sound
  errors.throw_if_any();
  return scene;
}

}  // namespace dem
