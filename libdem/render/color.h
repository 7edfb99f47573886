// Colours, linear (light adds up in them) and as screens want them (sRGB).
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "shapes/math/vec.h"

namespace dem::render {

using Color = shapes::Vec3<float>;  // linear red, green, blue; 0 … 1

Color from_srgb(double r, double g, double b);
std::uint8_t to_srgb(float linear);

// Perceptual map from dark blue over green to yellow: lightness rises evenly with t in 0 … 1 (clamped).
Color sequential(double t);
// Distinct colours, repeated after ten.
Color categorical(std::size_t index);

}  // namespace dem::render
