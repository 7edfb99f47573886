// Where the work of a contact goes, step by step. With F the force and ds the relative motion over a step, by the
// trapezoidal rule between the forces at its ends, which is what a leapfrog step does to the kinetic energy:
//   W = ½ (F_before + F) · ds                                                             (1)
// Along the normal ds is the overlap's growth, across it each force meets the velocity of the point where it acts: of
// second order where the contact turns. In the step that ends a contact F is zero, the velocity that of the step
// before.
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
  double begun = 0, overlap = 0;                     // 1 after the first step; of the last step, m
  double elastic = 0, dashpot = 0, pull = 0;         // N, of the last step, along the normal
  double closing = 0;                                // m/s, of the last step
  shapes::Vec3d slip{}, relative_spin{};             // m/s, rad/s
  shapes::Vec3d arm_a{}, arm_b{};                    // of the contact's point, m, the caller's to keep
  shapes::Vec3d tangential{}, tangential_dashpot{};  // N
  shapes::Vec3d moment{};                            // of rolling and of the patch, N m
  double normal_energy = 0, tangential_energy = 0, moment_energy = 0, pull_energy = 0;  // J
  std::array<double, mechanism_count> lost{};                                           // J, up to now
};

// Books lane i, after LawModel::run over a step. The velocities are those of the middle of the step. `acts`: for how
// long the motion of a step does work: dt in the first step too where forces move the bodies, for they kick them for
// the whole of it; the part of it in contact, work.dt_contact, where their way is prescribed. `before`: the velocity of
// a relative to b, in this step, where the last step's force acts.
CONTACT_API void book(const kernels::LawChunk& chunk, const kernels::LawWork& work, std::size_t i, Loss loss,
                      double acts, const shapes::Vec3d& before, Ledger& ledger);
// Of all laws, and of the spring that twists a patch, J.
CONTACT_API double stored_energy(const kernels::LawChunk& chunk, const kernels::LawWork& work, std::size_t i);
// The contact has ended: the last forces' other half, and what is still stored is lost.
CONTACT_API void close(Loss loss, double acts, Ledger& ledger);

}  // namespace contact
