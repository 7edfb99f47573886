// A material that every law finds its parameters in, and a liquid.
#pragma once

#include "libcontact/laws/law.h"

namespace contact {

inline Material stone() {
  Material m;
  m.young = 1e8;
  m.poisson = 0.3;
  m.density = 2500;
  m.restitution = 0.6;
  m.friction = 0.4;
  m.stiffness = 1e4;
  m.viscous_time = 1e-6;
  m.yield_pressure = 1e6;
  m.work_of_adhesion = 0.1;
  m.plastic_stiffness = 3e4;
  m.adhesive_stiffness = 5e3;
  m.plastic_depth = 0.05;
  m.rolling_friction = 0.1;
  m.rolling_viscosity = 0.01;
  m.rolling_damping = 0.3;
  m.twisting_friction = 0.1;
  m.cohesion = 1e-3;
  m.contact_angle = 0.2;
  return m;
}

inline LawOptions wet() {
  LawOptions o;
  o.surface_tension = 0.07;
  o.bridge_volume = 1e-12;
  return o;
}

}  // namespace contact
