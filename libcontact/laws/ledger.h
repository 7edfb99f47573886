// Where the work of a contact goes, step by step. With F the force and ds the relative motion over a step, by the
// trapezoidal rule between the forces at its ends, which is what a leapfrog step does to the kinetic energy:
//   W = ½ (F_before + F) · v dt                                                           (1)
// with the whole step also where the contact began within it: that is how long the loop lets the force act. The balance
// of an impact then errs at second order in dt, force jumps of dashpots and of adhesion included.
//   viscous    the dashpots' part of W, normal and tangential
//   friction   W of the tangential force and of the moments, less dashpots and stored energy
//   plastic    W of a normal law's elastic part less its stored energy, where the law loses by yielding (Loss::plastic)
//   adhesive   the same of a law that lets go later than it took hold, and of cohesion
// For a law without loss that rest is the error of (1) and is not booked: an energy balance shows it. Positive is lost;
// a bond that forms books the energy that it gains as a loss below zero until it is broken.
#pragma once

#include <array>
#include <cstddef>

#include "libcontact/export.h"
#include "libcontact/kernels/stages.h"
#include "libcontact/laws/state.h"

namespace contact {

enum class Mechanism { viscous, friction, plastic, adhesive };
inline constexpr std::size_t mechanism_count = 4;
inline constexpr const char* mechanism_names[mechanism_count] = {"viscous", "friction", "plastic", "adhesive"};

struct Ledger {
  double elastic = 0, dashpot = 0, pull = 0;         // N, of the last step, along the normal
  shapes::Vec3d tangential{}, tangential_dashpot{};  // N
  shapes::Vec3d moment{};                            // N m
  double normal_energy = 0, tangential_energy = 0, moment_energy = 0, pull_energy = 0;  // J
  std::array<double, mechanism_count> lost{};                                           // J, up to now
};

// Books lane i, after LawModel::run over a step of length dt. The velocities are those of the middle of the step.
CONTACT_API void book(const kernels::LawChunk& chunk, const kernels::LawWork& work, std::size_t i, double dt, Loss loss,
                      Ledger& ledger);

}  // namespace contact
