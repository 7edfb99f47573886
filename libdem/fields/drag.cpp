#include "libdem/fields/drag.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "shapes/math/exponential.h"

namespace dem {

const DragLawInfo* find_drag_law(std::string_view name) {
  for (const DragLawInfo& info : drag_laws)
    if (info.name == name) return &info;
  return nullptr;
}

double drag_per_speed(DragLaw law, const Flow& flow, double diameter, double speed) {
  using std::numbers::pi;
  const double stokes = 3 * pi * flow.viscosity * diameter;  // (2)
  switch (law) {
    case DragLaw::schiller_naumann: {
      const double reynolds = flow.density * speed * diameter / flow.viscosity;  // (1)
      const double power = reynolds > 0 ? shapes::exponential(0.687 * shapes::logarithm(reynolds)) : 0;
      return stokes * std::max(1 + 0.15 * power, 0.44 / 24 * reynolds);  // (3)
    }
    case DragLaw::quadratic:
      return pi / 8 * flow.drag_coefficient * flow.density * (diameter * diameter) * speed;  // (4)
    default:
      return stokes;
  }
}

Vec3d drag(DragLaw law, const Flow& flow, double diameter, const Vec3d& relative) {
  return relative * drag_per_speed(law, flow, diameter, norm(relative));
}

}  // namespace dem
