// The keys of the tables of a scene that have a file of their own.
#pragma once

#include <vector>

#include "libdem/scene/schema.h"

namespace dem {

std::vector<Key> analysis_keys();     // of [analysis]
std::vector<Key> wall_keys();         // of [[wall]]
std::vector<Key> periodic_keys();     // of [periodic]
std::vector<Key> drag_keys();         // of [drag]
std::vector<Key> law_keys();          // of [law]
std::vector<Key> material_keys();     // of [[material]]
std::vector<Key> pair_keys();         // of [[material_pair]]
std::vector<Key> part_keys();         // of [[shape]], kinds clump and union
std::vector<Key> grain_keys();        // of [[shape]], kinds generated and voronoi
std::vector<Key> insertion_tables();  // [[region]], [[species]], [[fill]], [[rain]], [[outlet]], [[event]]

}  // namespace dem
