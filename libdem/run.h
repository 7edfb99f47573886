// Running a world: steps, output at its times, checkpoints, progress, interruption. Used by `dem run` and `dem resume`.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <string>

#include "libdem/world.h"

namespace dem {

struct RunOptions {
  std::string folder;  // empty: nothing is written
  int threads = 1;
  const std::atomic<bool>* interrupt = nullptr;  // set by a signal handler: write a checkpoint and return
  std::function<void(const World&)> progress;    // called about ten times a second of wall time
  std::function<void(const World&)> observe;     // called after every step
};

// Threads that a run of this world keeps busy, at most the machine's.
int default_threads(const World& world);

enum class RunEnd { finished, interrupted };

// Starts (resumed = false) or continues a run in its folder, writing frames, record, checkpoints; at the end final.csv,
// summary.json and a picture. Throws RunError after writing a checkpoint-free but complete summary of what went wrong.
RunEnd run(World& world, const RunOptions& options, bool resumed);

}  // namespace dem
