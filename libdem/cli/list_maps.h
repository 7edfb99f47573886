// The table of law.map: what dem list maps prints.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace dem::cli {

using MapRow = std::vector<std::pair<std::string, std::string>>;  // heading, text
// Pairs of shapes, then laws, against the maps: "theory", "model: what it is" or "refused: why".
std::vector<MapRow> map_rows();

}  // namespace dem::cli
