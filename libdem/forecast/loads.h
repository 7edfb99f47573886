// What the bodies of a scene will feel, before it is run: how fast they meet and how hard they are pressed. Bounds and
// means from the scene alone, for judging stiffness and time step; nothing of a run depends on them.
#pragma once

#include <string>
#include <vector>

#include "libdem/time_step.h"
#include "libdem/world.h"

namespace dem::forecast {

struct Pressure {
  std::string source;  // "weight of the bed", "wall \"lid\""
  double value = 0;    // Pa
};

struct Loads {
  double fall = 0;              // m, longest way of a body down to where it comes to lie
  double fall_time = 0;         // s, until all lie; 0: nothing falls
  std::size_t unsupported = 0;  // bodies with gravity on them and no wall below
  double body_speed = 0;        // m/s, of bodies at the start, against each other or against what rests
  double wall_speed = 0;        // m/s, fastest point of any wall during the run
  double flow_speed = 0;        // m/s, of neighbours in a box that deforms
  double impact = 0;            // m/s, fastest meeting to expect: the start, the fall, the walls and the flow together
  double ground_area = 0;       // m², of the bodies seen along gravity; in the plane width times thickness
  double bed_height = 0;        // m, of all bodies at solid_fraction over the ground that they stand on now
  std::vector<Pressure> pressures;
  double solid_fraction = 0.6, contacts = 6;  // of a packed bed; of the plane 0.8 and 4
  double thickness = 0;                       // m, of the plane's bodies
};
Loads expected_loads(const World& world);

// A pair of groups, or a group and a wall, under those loads.
struct PairForecast {
  PairLimit limit;
  double duration = 0;        // s, of its shortest collision; +infinity where nothing moves
  double impact_overlap = 0;  // deepest, in radii of the smaller one
  double press_overlap = 0;   // mean, under the largest of the pressures, likewise
};
std::vector<PairForecast> pair_forecasts(const World& world, const std::vector<BodyGroup>& groups, const Loads& loads);

// Time that a Rayleigh wave takes around half the smallest body of each material, s; materials without Young's modulus
// or bodies are left out.
struct RayleighTime {
  std::uint32_t material = 0;
  double radius = 0, time = 0;  // m, s
};
std::vector<RayleighTime> rayleigh_times(const World& world);

}  // namespace dem::forecast
