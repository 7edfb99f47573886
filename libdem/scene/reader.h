// From a tree of values to a Scene, by the schema alone: types, ranges, missing and unknown keys, names, files.
#pragma once

#include <string>
#include <vector>

#include "libdem/scene/errors.h"
#include "libdem/scene/node.h"
#include "libdem/scene/scene.h"

namespace dem {

// Puts `key=value` overrides into the tree; material[0].young and material.NAME.young address entries of arrays.
void apply_overrides(Node& root, const std::vector<std::string>& overrides);
// Fills the scene and resolves file names relative to `base`; what is wrong goes to `errors`.
void read_by_schema(const Node& root, const std::string& base, Scene& scene, Errors& errors);
// What the schema cannot say: rules that join several keys.
void check_rules(const Node& root, const Scene& scene, Errors& errors);

}  // namespace dem
