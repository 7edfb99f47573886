// The drag of a given flow on a sphere, which does not act back on the flow.
//   u = v_fluid(x) − v                      relative velocity     [m/s]
//   Re = ρ |u| d/η                                                [–]     (1)
//   stokes             F = 3π η d u                               [N]     (2)
//   schiller_naumann   F = 3π η d u max(1 + 0.15 Re^0.687, 0.44 Re/24)    (3)
//   quadratic          F = (π/8) C ρ d² |u| u                             (4)
// (3) is (2) for Re → 0; its second form, C = 0.44, takes over at Re = 988.948, where both agree.
// Source: Schiller & Naumann, Z. VDI 77 (1933) 318; C = 0.44 above Re of about 1000: Newton's range, as is usual. Valid
// for (2) Re << 1, (3) Re < 2e5, single spheres far from others and from walls; of other bodies with the diameter of
// the sphere of their volume. Left out: lift, added mass, history and the torque. Cost: 0.25 us (3). Accuracy: 8 ulp.
// Test: tests/libdem/drag.cpp
#pragma once

#include <string_view>

#include "shapes/math/vec.h"

namespace dem {

using shapes::Mat3d;
using shapes::Vec3d;

enum class DragLaw { stokes, schiller_naumann, quadratic };

struct DragLawInfo {
  std::string_view name;
  DragLaw law;
  std::string_view parameters, remark;
};
inline constexpr DragLawInfo drag_laws[] = {
    {"stokes", DragLaw::stokes, "viscosity (Pa s)", "3 pi eta d u, for Re << 1"},
    {"schiller_naumann", DragLaw::schiller_naumann, "density (kg/m3), viscosity (Pa s)",
     "Stokes' times 1 + 0.15 Re^0.687, C = 0.44 above Re = 989"},
    {"quadratic", DragLaw::quadratic, "density (kg/m3), drag_coefficient",
     "constant coefficient C, of pi/8 C rho d^2 u^2"},
};
const DragLawInfo* find_drag_law(std::string_view name);  // null: unknown

// A fluid and its flow: steady, a uniform velocity and a linear part.
struct Flow {
  double density = 0;           // ρ, kg/m³
  double viscosity = 0;         // η, Pa s
  double drag_coefficient = 0;  // C of (4), –
  Vec3d velocity{};             // at the origin, m/s
  Mat3d gradient{};             // ∂v_i/∂x_j, 1/s

  Vec3d velocity_at(const Vec3d& x) const { return velocity + gradient * x; }  // m/s
};

// |F|/|u|, N s/m. The relaxation time m/this bounds the step: an explicit one must stay below twice it, and below it
// once for `quadratic`, whose slope dF/du is twice this.
double drag_per_speed(DragLaw law, const Flow& flow, double diameter, double speed);
// On the body, N; relative = flow.velocity_at(x) − v, m/s.
Vec3d drag(DragLaw law, const Flow& flow, double diameter, const Vec3d& relative);

}  // namespace dem
