// One contact led by hand through the laws that a scene would run: what `dem law`, tests and bench/laws drive.
//
//   Drive drive(contact);
//   const Answer& a = drive.step({.overlap = 1e-6, .velocity = {0, 0, 0.1}, .dt = 1e-7});
//
// As in the loop of libdem the overlap is that of the end of the step, the velocity that of its middle; a law that
// holds on is asked across the gap until it lets go; then, and where other bodies are apart, everything is forgotten.
#pragma once

#include <memory>
#include <vector>

#include "libcontact/laws/ledger.h"
#include "libcontact/laws/model.h"

namespace dem::law_driver {

using shapes::Vec3d;

// The two that meet, as the laws see them.
struct LawContact {
  contact::LawModel model;
  contact::PairParameters pair;
  contact::LawOptions options;
  double radius_eff = 0;  // R*, m
  double mass_eff = 1;    // m*, kg
};

struct Move {
  double overlap = 0;      // m, < 0: a gap
  Vec3d normal{0, 0, 1};   // from a to b
  Vec3d velocity{};        // of a relative to b at the contact, m/s
  double turn = 0;         // of both about the normal, rad/s
  Vec3d relative_spin{};   // ω_a − ω_b, rad/s
  double dt = 0;           // s; 0: the force as it stands
  bool prescribed = true;  // the motion; else forces move the bodies, by kicks that last the whole step (ledger.h)
  Vec3d turned{};          // what the velocity of a relative to b is more where the last step's force acted, m/s
};

struct Answer {
  bool touching = false;
  Vec3d force{};                                              // on a, N
  Vec3d moment{};                                             // on a, of the rolling law, N m
  double normal = 0;                                          // on b along the normal, less attraction, N
  Vec3d tangential{};                                         // on b, N
  double contact_radius = 0, stiffness = 0, stiffness_t = 0;  // m, N/m, N/m
  double damping = 0, damping_t = 0;                          // c of the dashpots, N s/m
  double energy = 0;                                          // stored, J
};

class Drive {
 public:
  explicit Drive(const LawContact& contact);
  const Answer& step(const Move& move);
  const Answer& answer() const { return answer_; }
  const LawContact& contact() const { return contact_; }
  // What the record remembers beside its tangential force; all zero when apart.
  std::vector<double> memory() const;
  // J, over all steps; the step with dt = 0 that begins a path loses nothing.
  double lost(contact::Mechanism m) const;
  double lost() const;

 private:
  void end(const Move& move);

  LawContact contact_;
  std::unique_ptr<contact::kernels::LawChunk> chunk_;
  std::unique_ptr<contact::kernels::LawWork> work_;
  contact::Ledger ledger_;
  std::array<double, contact::mechanism_count> lost_{};  // in contacts that have ended
  Answer answer_;
};

// Largest stable step of a contact of this overlap: of the normal and of the sticking mode, with their inverse masses w
// (1/kg) at the contact's point, the smaller
//   (2/ω)(sqrt(1 + β²) − β),   ω² = k w,   β = c w/(2 ω)                                  [s]
// The dashpots are those of the contact's m*: with the 7/2 of a ball that sticks, β is 1.87 times that along the
// normal.
double stable_step(const LawContact& contact, double overlap, double inverse_mass_n, double inverse_mass_t);

}  // namespace dem::law_driver
