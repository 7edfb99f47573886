// From a tree of values to a Scene, by the schema alone: types, ranges, missing and unknown keys, names, files.
#pragma once

#include <string>
#include <vector>

#include "libdem/scene/errors.h"
#include "libdem/scene/node.h"
#include "libdem/scene/scene.h"

namespace dem {

namespace scene_format {
struct Section;  // schema.h
}

// Puts `key=value` overrides into the tree; material[0].young and material.NAME.young address entries of arrays.
void apply_overrides(Node& root, const std::vector<std::string>& overrides);
// A scene file with the files that it includes merged into it; `files` receives the name of each.
Node read_with_includes(const std::string& path, std::vector<std::string>& files);
// Fills the scene and resolves file names relative to the file that states them; what is wrong goes to `errors`.
void read_by_schema(const Node& root, Scene& scene, Errors& errors);
// Another file than a scene, by a schema of its own: into the struct that the section fills.
void read_table(const scene_format::Section& section, const Node& root, void* spec, Errors& errors);
// Values of named materials and published friction: what `like` and `published` stand for.
void apply_libraries(const Node& root, Scene& scene, Errors& errors);
// What the schema cannot say: rules that join several keys.
void check_rules(const Node& root, const Scene& scene, Errors& errors);
// The part that concerns two-dimensional scenes.
void check_planar_rules(const Node& root, const Scene& scene, Errors& errors);

}  // namespace dem
