// Half-plane y <= 0 of its body frame: an infinite straight wall of two-dimensional scenes.
#pragma once

namespace shapes {

struct Line {
  static constexpr const char* name = "line";
};

}  // namespace shapes
