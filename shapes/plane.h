// Plane wall: the half-space z <= 0 of its body frame is solid, bodies live at z > 0.
#pragma once

namespace shapes {

struct Plane {
  static constexpr const char* name = "plane";
};

}  // namespace shapes
