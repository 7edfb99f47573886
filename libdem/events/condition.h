// Conditions of a scene: `quantity op number`, joined by `and`; op is < <= > or >=.
//
//   time, step
//   count, mass                                   of the bodies present; kg
//   kinetic_energy (also: energy), kinetic_energy_per_body      translation and rotation, J
//   max_speed, mean_speed                         of the centres, m/s
//   unbalanced_force                              mean net force on a body over mean contact force, –
//   contacts, contacts_per_body, max_overlap      touching; overlap of spheres of equal volume, in radii of the smaller
//   inserted_count, inserted_mass                 since the start
//   discharged_count, discharged_mass             by all outlets
//   outlet.NAME.count, outlet.NAME.mass, rain.NAME.count, rain.NAME.mass, wall.NAME.force (N), wall.NAME.torque (N m)
//
// Sums run in order of id, so a condition holds or not whatever the threads. Cost: O(bodies log bodies) per look.
#pragma once

#include <string>
#include <vector>

#include "libdem/scene/scene.h"

namespace dem {

struct World;

enum class Quantity {
  time,
  step,
  count,
  mass,
  kinetic_energy,
  kinetic_energy_per_body,
  max_speed,
  mean_speed,
  unbalanced_force,
  contacts,
  contacts_per_body,
  max_overlap,
  inserted_count,
  inserted_mass,
  discharged_count,
  discharged_mass,
  outlet_count,
  outlet_mass,
  rain_count,
  rain_mass,
  wall_force,
  wall_torque
};

enum class Comparison { less, less_equal, greater, greater_equal };

struct Term {
  Quantity quantity;
  std::size_t index = 0;  // of the outlet, rain or wall
  Comparison comparison;
  double value;
};

using Condition = std::vector<Term>;

// What is wrong with the text of a condition, and at which letter (from 0).
struct ConditionFault {
  std::size_t at = 0;
  std::string problem;
};

// Reads a condition; the names of outlets, rains and walls are those of the scene. False: `fault` says why.
bool parse_condition(const std::string& text, const Scene& scene, Condition& condition, ConditionFault& fault);

double measure(const World& world, const Term& term);
bool holds(const World& world, const Condition& condition);  // an empty one does not

}  // namespace dem
