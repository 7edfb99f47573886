// Flow: profiles of mean velocity along the axes, what leaves and comes between two frames, and how long bodies stay.
//
//   v̄ = Σ m v/Σ m, T = <|v − v̄|²>/d of the bodies whose centres are in a slab; d the dimension                    (1)
//   discharge rate W = Σ m of bodies that are no longer there / (t − t_before)  [kg/s]; likewise number and inflow (2)
//   residence time of a body: from the first frame that has it to the middle between the last that has it and the next
//   one, so it is known to half the interval of frames                                                              (3)
// Bodies that an outlet recycles keep their id: they neither leave nor come here (discharge.csv of a run counts them).
// Cost: O(bodies). Tests: tests/libdem/analysis_flow.cpp.
#pragma once

#include <vector>

#include "libdem/analysis/grid.h"
#include "libdem/analysis/result.h"

namespace dem::analysis {

struct FlowSlab {
  double middle = 0;            // m, along the axis
  double bodies = 0, mass = 0;  // kg
  Vec3d velocity{}, spin{};     // mean over mass, m/s; over bodies, rad/s
  double temperature = 0;       // (1), m²/s²
  double mass_flux = 0;         // of the momentum along the axis over the slab's volume, kg/(m² s)
};
std::vector<FlowSlab> flow_profile(const Snapshot& snapshot, const Domain& region, int axis, int slabs);

struct Exchange {                         // (2)
  double interval = 0;                    // s
  std::vector<std::uint32_t> left, came;  // places in the frame before; in this one
  double left_mass = 0, came_mass = 0;    // kg
};
Exchange exchange_between(const Snapshot& before, const Snapshot& now);

// (3) over a series of frames, added in order of time.
class Residence {
 public:
  struct Stay {
    std::uint64_t id = 0;
    double entered = 0, left = 0;  // s
    bool from_start = false;       // it was in the first frame: it came no later than that
  };
  void add(const Snapshot& snapshot);
  const std::vector<Stay>& stays() const { return stays_; }  // of those that have left, in order of time and id

 private:
  struct Guest {
    std::uint64_t id;
    double entered;
    bool from_start;
  };
  std::vector<Guest> present_;  // in order of id
  std::vector<Stay> stays_;
  double time_ = 0;
  bool first_ = true;
};

Result report_flow(const Snapshot& snapshot, const Settings& settings);

}  // namespace dem::analysis
