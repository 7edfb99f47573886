// One law of each family, chosen by name: what a scene or a host picks once and runs over its contacts.
//
//   const auto model = contact::law_model(*contact::named_law("hertz_mindlin"));
//   model->run(chunk, work, count, dt, options, patch);
//
// A record's memory beside its History is `words` doubles, all zero at first contact; run() finds them in
// LawWork::memory. The two commonest combinations run in one fused kernel without any (fused()).
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "libcontact/export.h"
#include "libcontact/kernels/stages.h"
#include "libcontact/laws/state.h"

namespace contact {

struct LawNames {
  std::string normal, tangential, rolling = "none", cohesion = "none";
};

// Names of the laws that a classical combination is made of; none: no such name.
CONTACT_API std::optional<LawNames> named_law(std::string_view name);

struct Stiffness {
  double n = 0, t = 0;            // N/m
  double damping = 0;             // of a dashpot that does not go with sqrt(m* k), N s/m
  double rolling = 0, twist = 0;  // springs of the rolling law, N m/rad
  double rolling_damping = 0;     // its dashpot, N m s/rad, of a body of 1 kg; dry, without a spring: that times dt
};

class LawModel {
 public:
  std::size_t normal = 0, tangential = 0, rolling = 0, cohesion = 0;                              // places in the lists
  std::size_t memory_normal = 0, memory_tangential = 0, memory_rolling = 0, memory_cohesion = 0;  // first words
  std::size_t words = 0;  // of memory per record
  Loss loss = Loss::none;
  bool lingers = false;   // contacts may hold on without overlap: then a record is kept while its `bond` is 1
  bool rolls = false;     // reads the relative spin
  bool hertzian = false;  // δ, R* and E* enter; else the stiffness is given
  double damping_factor = 0;

  CONTACT_API bool fused() const;
  // One step of `count` contacts: answers force and couple (of the patch and of rolling; spheres: not yet that of the
  // force), new histories and memory in place. `work.gain` must be set.
  CONTACT_API void run(kernels::LawChunk& chunk, kernels::LawWork& work, std::size_t count, double dt,
                       const LawOptions& options, bool patch, const kernels::KernelSet& set = kernels::kernels()) const;
  // The widest gap that a contact reaches across, m.
  CONTACT_API double range(const PairParameters& pair, const LawOptions& options, double radius_eff) const;
  // Steepest springs of a contact at this overlap, with the memory that its record has; none: pressed for the first
  // time.
  CONTACT_API Stiffness stiffness(const PairParameters& pair, const LawOptions& options, double radius_eff,
                                  double overlap, const double* memory = nullptr) const;
  // Part of the critical damping that the law's dashpot has: c = 2 β sqrt(m* k).
  double damping_ratio(const PairParameters& pair) const { return 0.5 * damping_factor * pair.damping; }
};

// Empty where a name is not in its list.
CONTACT_API std::optional<LawModel> law_model(const LawNames& names);

}  // namespace contact
