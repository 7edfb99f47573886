// What a run will take: time, memory and room on the disk. Measured on copies of the world, not modelled: its first
// steps, a packed sample of its bodies (packing.h), one rebuild of the list, one frame, one checkpoint, a small
// picture.
//
//   steps: as they begin, and more and more as packed (the dearer of the two) while bodies come down
//   rebuilds: each time that the speed to expect takes a body through half the skin
//
// Accuracy: within a factor of 2 of the time and memory of the run (bench/forecast compares). How many bodies leave
// through an outlet is not foreseen, only that some do; a bed that a driver stirs is taken as packed all the time.
#pragma once

#include <cstdint>
#include <functional>

#include "libdem/forecast/loads.h"
#include "libdem/forecast/memory.h"
#include "libdem/world.h"

namespace dem::forecast {

struct StepCost {
  double step = 0;     // s, without rebuilds
  double rebuild = 0;  // s, each
};

struct Cost {
  std::uint64_t steps = 0, frames = 0, checkpoints = 0;
  StepCost beginning, packed;                     // on one thread
  bool packs = false;                             // bodies come to lie on each other, or lie already
  double packed_share = 0;                        // of the steps, as they are counted
  double rebuilds = 0;                            // in the whole run
  double frame = 0, checkpoint = 0, picture = 0;  // s, each; the picture on one thread
  double frame_bytes = 0, checkpoint_bytes = 0;   // each
  double set_up = 0;                              // s, as given
  int threads = 1;                                // of the run
  double speed_up = 1;                            // of the steps, by them

  double loop = 0, output = 0;  // s on one thread
  double total = 0;             // s on one thread
  double total_on_threads = 0;  // s
  Bytes memory;                 // at the peak, without the program itself
  double picture_memory = 0;    // bytes
  double disk = 0;              // bytes
};

// Takes a few seconds. `set_up`: how long reading and building took, s; `threads` as the run would use. Writes one
// frame into a folder of its own under the system's folder for temporary files, and removes it; where that fails,
// output counts as nothing.
Cost expected_cost(const World& world, const Loads& loads, int threads, double set_up);

}  // namespace dem::forecast
