// Questions about the scene format for code that knows the world too (its contacts have keys of their own).
#pragma once

#include <string_view>

namespace dem {

// Whether the path of some key of the format holds this word ("friction" in material.friction).
bool some_key_holds(std::string_view word);

}  // namespace dem
