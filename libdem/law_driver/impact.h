// Two bodies that meet, a ball and a ball or a plane, with the step of the loop of libdem: kick – drift – kick, forces
// from the positions at the end of a step and the velocities of its middle, both ways about the contact's centre.
//
// The ball a comes from below along z, the tangential part of its velocity points along x. Spins are about y: a's point
// at the contact moves along x with a positive one. Without gravity.
#pragma once

#include <functional>
#include <limits>

#include "libdem/law_driver/drive.h"

namespace dem::law_driver {

struct Ball {
  double radius = 0;                                         // m; 0: a plane
  double mass = std::numeric_limits<double>::infinity();     // kg; infinite: held
  double inertia = std::numeric_limits<double>::infinity();  // kg m²
};
// 2/5 m R².
Ball solid_ball(double radius, double mass);

// How they meet.
struct Approach {
  double normal_speed = 0, tangential_speed = 0;  // of a relative to b, m/s
  double spin_a = 0, spin_b = 0;                  // rad/s
  double dt = 0;                                  // s
  double phase = 0;  // when in its step the contact begins: the share that is over by then, 0 <= phase < 1
};

struct Rebound {
  double restitution = 0;                         // of the centres along the normal
  double tangential_restitution = 0;              // of the centres across, rebound over impact
  double contact_slip = 0;                        // of a's point over b's afterwards, m/s
  double normal_speed = 0, tangential_speed = 0;  // of a relative to b afterwards, m/s
  double spin_a = 0, spin_b = 0;                  // rad/s
  double peak_time = 0;                           // s, of the largest overlap
  double duration = 0;                            // s, with the parts of the first and last step in contact
  double peak_overlap = 0, peak_force = 0;        // m, N
  double kinetic_before = 0, kinetic_after = 0;   // J, in the frame of the common centre of mass
  double largest_kinetic = 0;                     // J, of all steps
  double work_error = 0;    // J, largest |ΔKE − Σ F·v̄ dt − Σ T·ω̄ dt| of all steps added up
  double energy_error = 0;  // J, largest |KE + PE + lost − E0| at the end of a step
  std::array<double, contact::mechanism_count> lost{};  // J
  std::size_t steps = 0;                                // in contact
  bool ended = false;                                   // false: they stay together, or the contact never ends
};

// One step in contact, for whoever wants to look on.
struct Look {
  double time, overlap, slip_x, slip_y;  // s since the contact began, m, m (sum over the steps), m
  const Move& move;
  const Drive& drive;
};

// Radii and masses decide R* and m*, whatever stands in the contact. At most `most_steps` steps.
Rebound impact(LawContact contact, const Ball& a, const Ball& b, const Approach& approach,
               const std::function<void(const Look&)>& look = {}, std::size_t most_steps = 10000000);

// R* and m* of the two.
void set_bodies(LawContact& contact, const Ball& a, const Ball& b);

// The step that dt = "auto" gives a scene of the two: `fraction` of the limit at overlap_share of the smaller radius,
// with `contacts` contacts a body.
double automatic_step(LawContact contact, const Ball& a, const Ball& b, double fraction = 0.1,
                      double overlap_share = 0.01, int contacts = 6);

}  // namespace dem::law_driver
