// Force laws: materials, how two of them meet, and the history a contact carries. Laws know no shape and no method;
// they see Kinematics (overlap, normal, velocities, effective radius and mass) and answer with a force.
// What a law is: state.h. The lists: list.h. One law per family chosen by name: model.h.
#pragma once

#include "shapes/math/vec.h"

namespace contact {

// What a law does not read may stay as it is.
struct Material {
  double young = 0;               // Pa
  double poisson = 0;             // –
  double density = 0;             // kg/m³
  double restitution = 1;         // –
  double friction = 0;            // –
  double stiffness = 0;           // N/m (linear laws)
  bool rigid = false;             // out of both E* and G*
  double viscous_time = 0;        // A of Kuwabara & Kono, s
  double yield_pressure = 0;      // of the first yield, Pa; 0: never
  double work_of_adhesion = 0;    // W of two surfaces of it, J/m²; 2 γ, γ the energy of one surface
  double plastic_stiffness = 0;   // limit of the unloading stiffness, N/m
  double adhesive_stiffness = 0;  // slope of the adhesive branch, N/m
  double plastic_depth = 0;       // part of the diameter 2 R* at which the plastic stiffness is reached, –
  double rolling_friction = 0;    // –
  double rolling_viscosity = 0;   // s/m
  double rolling_damping = 0;     // of the rolling spring, part of critical, –
  double twisting_friction = 0;   // –
  double cohesion = 0;            // constant attraction, N
  double contact_angle = 0;       // of the liquid on it, rad
};

// Parameters of a pair of materials, over a scalar, a pack, or the lanes of a chunk.
template <class T>
struct PairOf {
  T young_eff{};           // E*: 1/E* = (1−ν₁²)/E₁ + (1−ν₂²)/E₂, Pa
  T shear_eff{};           // G*: 1/G* = (2−ν₁)/G₁ + (2−ν₂)/G₂, Pa
  T stiffness_n{};         // N/m (linear laws)
  T stiffness_t{};         // N/m: kn · 2(1−ν)/(2−ν) = kn / κ with κ = E*/(4G*)
  T friction{};            // –
  T damping{};             // β that gives `restitution` with the end of contact that the law has (mix.h), –
  T shear_twist{};         // 1/(1/G₁ + 1/G₂), Pa
  T loading_ratio{};       // e², of a spring that latches: k1/k2, –
  T viscous_time{};        // A, s
  T yield_pressure{};      // Pa; infinite: never yields
  T work_of_adhesion{};    // J/m²
  T plastic_stiffness{};   // N/m
  T adhesive_stiffness{};  // N/m
  T plastic_depth{};       // –
  T rolling_friction{};    // –
  T rolling_viscosity{};   // s/m
  T rolling_damping{};     // –
  T twisting_friction{};   // –
  T cohesion{};            // N
  T contact_angle{};       // rad
  T wetting{};             // cos of the contact angle, mean of both
};

// f(a.member, b.member) for every member.
template <class A, class B, class F>
constexpr void each_parameter(A& a, B& b, F&& f) {
  f(a.young_eff, b.young_eff);
  f(a.shear_eff, b.shear_eff);
  f(a.stiffness_n, b.stiffness_n);
  f(a.stiffness_t, b.stiffness_t);
  f(a.friction, b.friction);
  f(a.damping, b.damping);
  f(a.shear_twist, b.shear_twist);
  f(a.loading_ratio, b.loading_ratio);
  f(a.viscous_time, b.viscous_time);
  f(a.yield_pressure, b.yield_pressure);
  f(a.work_of_adhesion, b.work_of_adhesion);
  f(a.plastic_stiffness, b.plastic_stiffness);
  f(a.adhesive_stiffness, b.adhesive_stiffness);
  f(a.plastic_depth, b.plastic_depth);
  f(a.rolling_friction, b.rolling_friction);
  f(a.rolling_viscosity, b.rolling_viscosity);
  f(a.rolling_damping, b.rolling_damping);
  f(a.twisting_friction, b.twisting_friction);
  f(a.cohesion, b.cohesion);
  f(a.contact_angle, b.contact_angle);
  f(a.wetting, b.wetting);
}

// Those that are a share λ of a contact's when its springs are: forces and stiffnesses then add to those of one.
template <class P, class F>
constexpr void each_extensive_parameter(P& p, F&& f) {
  f(p.young_eff);
  f(p.shear_eff);
  f(p.stiffness_n);
  f(p.stiffness_t);
  f(p.shear_twist);
  f(p.yield_pressure);
  f(p.work_of_adhesion);
  f(p.plastic_stiffness);
  f(p.adhesive_stiffness);
  f(p.cohesion);
}

// Mixed once per pair of materials.
struct PairParameters : PairOf<double> {
  double restitution = 1;  // –
};

// What is one for all contacts of a scene.
struct LawOptions {
  bool rescale = true;         // shorten the tangential spring when the contact radius shrinks
  bool clip = true;            // a contact ends at zero force; else at zero overlap: until then its dashpot may pull
  bool deficit = false;        // hertz_mindlin_deresiewicz: a memory of the slip that an increment did not make
  double surface_tension = 0;  // of the liquid in bridges, N/m
  double bridge_volume = 0;    // of one liquid bridge, m³
};

// One contact record's memory, in world axes. Laws that remember more keep it beside (model.h).
struct alignas(64) History {  // one cache line
  shapes::Vec3d force_t{};    // elastic tangential force on b's side, N (spring stretched by the slip of a over b)
  double overlap = 0;         // of the last step, m; 0: was not touching; < 0: bonded across a gap
  shapes::Vec3d normal{};     // of the last step
  double twist = 0;           // patch only: elastic moment about the normal, N m
};
static_assert(sizeof(History) == 64);

}  // namespace contact
