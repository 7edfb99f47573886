// A SIMD pack of doubles: the standard library's native width for the instruction set that a source is compiled for.
// Lanes are independent and contraction is off, so every width gives the same bits as the scalar template. Only sources
// compiled per instruction set may include this.
#pragma once

#include <cmath>
#include <experimental/simd>

#include "shapes/math/select.h"

namespace shapes {

using Pack = std::experimental::native_simd<double>;

}  // namespace shapes
