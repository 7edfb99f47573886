// Force laws: materials, how two of them meet, and the history a contact carries. Laws know no shape and no method;
// they see Kinematics (overlap, normal, velocities, effective radius and mass) and answer with a force.
#pragma once

#include "shapes/math/vec.h"

namespace contact {

struct Material {
  double young = 0;        // Pa
  double poisson = 0;      // –
  double density = 0;      // kg/m³
  double restitution = 1;  // –
  double friction = 0;     // –
  double stiffness = 0;    // N/m (linear law)
  bool rigid = false;      // out of both E* and G*
};

// Mixed once per pair of materials.
struct PairParameters {
  double young_eff = 0;    // E*: 1/E* = (1−ν₁²)/E₁ + (1−ν₂²)/E₂, Pa
  double shear_eff = 0;    // G*: 1/G* = (2−ν₁)/G₁ + (2−ν₂)/G₂, Pa
  double stiffness_n = 0;  // N/m (linear law)
  double stiffness_t = 0;  // N/m: kn · 2(1−ν)/(2−ν) = kn / κ with κ = E*/(4G*)
  double friction = 0;     // –
  double damping = 0;      // β that gives `restitution` with the end of contact that the law has (mix.h), –
  double restitution = 1;  // –
};

// What is one for all contacts of a scene.
struct LawOptions {
  bool rescale = true;  // shorten the tangential spring when the contact radius shrinks
  bool clip = true;     // a contact ends at zero force; else at zero overlap: until then its dashpot may pull
};

// One contact record's memory, in world axes.
struct alignas(64) History {  // one cache line
  shapes::Vec3d force_t{};    // elastic tangential force on b's side, N (spring stretched by the slip of a over b)
  double overlap = 0;         // of the last step, m; 0: was not touching
  shapes::Vec3d normal{};     // of the last step
  double twist = 0;           // patch only: elastic moment about the normal, N m
};
static_assert(sizeof(History) == 64);

}  // namespace contact
