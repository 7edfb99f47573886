// The folder of a run: which files in it are ours.
#pragma once

#include <string>

#include "libdem/world.h"

namespace dem::cli {

// Refuses (InputError) a folder that holds anything, unless `force`, and always the one whose scene.toml is the scene
// to run, which the resolved one would replace. Changes nothing.
void check_folder(const std::string& folder, const std::string& scene, bool force);
// Removes the files that a run, a render, an analysis or a report writes into it, and nothing else; scene.toml stays
// until a new one takes its place.
void clear_folder(const std::string& folder);
// The scene of a run, from its folder; InputError when it holds none.
Scene scene_of_run(const std::string& folder);

}  // namespace dem::cli
