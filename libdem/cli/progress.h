// Progress of a run on stderr: one line redrawn on a terminal, otherwise a line per tenth.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

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

// Progress of work in equal pieces on stderr: one line redrawn on a terminal once a second has passed, else nothing.
class WorkProgress {
 public:
  WorkProgress(std::size_t pieces, bool quiet);
  void show(std::size_t done, const std::string& what);
  void end() const;

 private:
  bool shown_ = false, wanted_;
  std::size_t pieces_;
  std::chrono::steady_clock::time_point start_, last_;
};

// "1 h 02 min", "3 min 20 s", "12 s", "0.4 s".
std::string duration_text(double seconds);
// 12345678 -> "12.3 M": three digits, a space and the prefix of the unit that follows.
std::string rate_text(double value);

}  // namespace dem::cli
