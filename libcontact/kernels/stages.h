// Any normal, tangential, rolling and cohesion law over a chunk of contacts, one kernel per law: kernels add, they do
// not multiply with the number of laws. Between them the chunk waits in a LawWork. laws/model.h runs them.
//
//   normal → tangential → rolling → cohesion → finish
//
// Per contact with n from a to b, F the normal law's force, P the pull, Ft the tangential force, J the gain:
//   force on a = −(n (J F − P) + Ft)                                                                        (1)
//   couple     = moment of the rolling law [+ patch_couple of law_kernel.h]                                  (2)
// With a gain (flat faces, map `volume`) laws see δ, J dδ/dt and m*/J²: F is then −dU/dδ along the body's own motion,
// (3) and P, which goes with the same overlap, is J times what the law gave. Contacts that hold on without overlap have
// `bond` 1 and history_overlap < 0. Where cohesion alone holds them, the other laws begin anew at the next touch.
#pragma once

#include "libcontact/kernels/chunk.h"
#include "libcontact/laws/kinematics.h"

namespace contact::kernels {

inline constexpr std::size_t memory_words = 96;  // a record's memory beside its History, at most

struct LawWork {
  Lane memory[memory_words];                                 // in and out; whose words begin where: StageCall
  Lane gain;                                                 // in: J, 1 unless the map gives another
  Lane depth, dt_contact, onset, overlap_before;             // of the kinematics, from the normal stage on
  NormalForce<Lane> normal;                                  // as the law gave it, times J; stiffness times J²
  Lane3 tangential, moment;                                  // on b; on a
  Lane tangential_energy, moment_energy, pull, pull_energy;  // pull times J
  Lane bond;                                                 // out: 1: keep the record although there is no overlap
};

struct StageCall {
  double dt;
  const LawOptions* options;
  std::size_t memory = 0;  // first word of the law's state
  bool patch = false;
};

using Stage = void (*)(LawChunk& chunk, LawWork& work, std::size_t count, const StageCall& call);

struct StageSet {  // in the order of the lists
  std::span<const Stage> normal, tangential, rolling, cohesion;
  Stage finish;
};

}  // namespace contact::kernels
