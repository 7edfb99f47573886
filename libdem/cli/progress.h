// Progress of a run on stderr: one line redrawn on a terminal, otherwise a line per tenth.
#pragma once

#include <chrono>
#include <cstdint>

#include "libdem/world.h"

namespace dem::cli {

bool stderr_is_terminal();
// Whether colour may be used on stderr: a terminal, and NO_COLOR is not set.
bool stderr_has_color();

class Progress {
 public:
  Progress(const World& world, std::uint64_t last_step);
  void show(const World& world);
  void end() const;  // leaves the redrawn line

 private:
  bool terminal_;
  std::uint64_t first_, last_, tenth_;
  double particle_steps_ = 0;
  std::uint64_t step_;
  std::chrono::steady_clock::time_point start_;
};

// "1 h 02 min", "3 min 20 s", "12 s", "0.4 s".
std::string duration_text(double seconds);
// 12345678 -> "12.3 M": three digits, a space and the prefix of the unit that follows.
std::string rate_text(double value);

}  // namespace dem::cli
