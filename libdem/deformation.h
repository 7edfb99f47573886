// How the periodic cell deforms, and what it bears. Bodies follow the homogeneous flow of the cell and have their own
// velocity v on top (cell.h):
//   dx/dt = v + G (x − centre),  m dv/dt = F − m G v                                                              (1)
// (the equations known as SLLOD: Evans and Morriss, Statistical Mechanics of Nonequilibrium Liquids, 1990). Stress is
// that of the bodies on what surrounds them, compression positive, as Love and Weber have it, with the kinetic part:
//   V σ = Σ m v⊗v − Σ f⊗d,   f: force on a, d: from the centre of a to that of b                                   (2)
// By (1) the energy of undamped bodies changes by −V σ : G, the work of the cell, and Σ m v = 0 stays zero. Over a step
// G is constant and (1) is advanced to second order: a length at constant rate r grows as exp(r t).
// Servo: the rate of a length L, or one rate for several, follows from what its stress lacks,
//   rate = −(target − σ₀)/(L sqrt(ρ M)/gain + η),  at most rate_limit either way                                   (3)
// M, η: stiffness of the touching normal springs, and viscosity of their dashpots, under a homogeneous strain, Pa,
// Pa s; ρ: mass over volume; L: the shortest of the lengths; σ₀: the stress without what η bears at the present rate
// (else stress and rate would call each other up from step to step). The strain that is lacking, (target − σ)/M, is
// worked off as fast as sound, sqrt(M/ρ), crosses L. True packings are softer than M, so it takes longer, but does not
// overshoot. Without contacts the rate is rate_limit.
#pragma once

#include "libdem/integrators/bodies.h"
#include "libdem/world.h"

namespace dem {

// The cell of a scene at t = 0; taking the bodies into it is the caller's.
void make_cell(World& world);
// Before the first step, with forces: stress and rates. Throws InputError when a rate is too fast for the time step.
void start_cell(World& world);
// Deforms the box by one step; the bodies are the caller's.
CellStep deform_box(Cell& cell, double dt);
// −m G v over half a step goes into the balance of momentum.
void book_flow(World& world, const CellStep& step);
// After the forces: stress, work, and the rates of the next step. Throws RunError when the box has become too short.
void finish_cell_step(World& world, int threads, double dt);

// Whether the box is periodic along every axis of the scene: it then has a volume, a stress, a solid fraction. In the
// plane the volume is that over the thickness of the prisms (a layer of spheres has none), and the fraction one of
// areas.
bool is_whole(const World& world);
double cell_volume(const World& world);  // m³
Mat3d cell_stress(const World& world);   // (2), Pa; row: force, column: face
double solid_fraction(const World& world);

// Contacts of bodies with bodies, a pair that touches at several points counted once. A rattler has fewer contacts with
// bodies that are not rattlers than hold it: dimension + 1 without friction, else 2.
struct Coordination {
  double all = 0;         // contacts per body
  double rattlers = 0;    // their share of the bodies
  double backbone = 0;    // contacts per body among those that are not rattlers
  std::size_t pairs = 0;  // that touch
};
Coordination coordination(const World& world);

}  // namespace dem
