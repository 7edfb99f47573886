// Random numbers of a run: shapes/math/random.h.
#pragma once

#include "shapes/math/random.h"

namespace dem {

using shapes::Random;

}  // namespace dem
