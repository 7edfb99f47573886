// Mass properties of a solid of unit density.
#pragma once

#include "shapes/math/vec.h"

namespace shapes {

struct MassProperties {
  double volume{};  // m³
  Vec3d centre{};   // centre of mass in the frame the solid was given in, m
  Mat3d inertia{};  // about the centre of mass, axes of that frame, per unit density, m⁵
};

}  // namespace shapes
