// Every validation that the program knows, in the order of `dem validate`.
#pragma once

#include <vector>

#include "libdem/validate/validation.h"

namespace dem::validate {

const std::vector<const Validation*>& validations();

}  // namespace dem::validate
