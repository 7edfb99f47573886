// The known name nearest to a mistyped one.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace dem {

// Edits (insert, delete, replace, swap of neighbours) that turn a into b.
int edit_distance(std::string_view a, std::string_view b);

// The candidate with the fewest edits; empty when none is near (more than a third of the name's letters, at least 2).
std::string nearest_name(std::string_view name, const std::vector<std::string>& candidates);

// "; did you mean X?", or the list of candidates when none is near and they are few, or nothing.
std::string suggestion(std::string_view name, const std::vector<std::string>& candidates);

}  // namespace dem
