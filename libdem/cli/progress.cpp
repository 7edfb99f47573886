#include "libdem/cli/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace dem::cli {

bool stderr_is_terminal() { return isatty(STDERR_FILENO) == 1; }
bool stderr_has_color() {
  const char* refused = std::getenv("NO_COLOR");
  return stderr_is_terminal() && !(refused && *refused);
}

namespace {

// A line of the terminal over the one before, of at most `width` columns without colour.
void write_over(const std::string& line, int width) {
  if (stderr_has_color())
    fmt::print(stderr, "\r\033[K\033[36m{}\033[0m", line);
  else
    fmt::print(stderr, "\r{:<{}}", line, width);
}

}  // namespace

std::string duration_text(double seconds) {
  if (!(seconds >= 0 && seconds < 1e9)) return "unknown";
  if (seconds < 10) return fmt::format("{:.1f} s", seconds);
  const long whole = std::lround(seconds);
  if (whole < 60) return fmt::format("{} s", whole);
  if (whole < 3600) return fmt::format("{} min {:02} s", whole / 60, whole % 60);
  return fmt::format("{} h {:02} min", whole / 3600, whole % 3600 / 60);
}

std::string rate_text(double value) {
  const char* prefix[] = {" ", " k", " M", " G", " T"};
  std::size_t i = 0;
  while (value >= 999.5 && i + 1 < std::size(prefix)) value /= 1000, ++i;
  return fmt::format("{:.3g}{}", value, prefix[i]);
}

Progress::Progress(const World& world, std::uint64_t last_step)
    : terminal_(stderr_is_terminal()),
      first_(world.step),
      last_(last_step),
      tenth_(last_step ? 10 * world.step / last_step : 10),
      step_(world.step),
      start_(std::chrono::steady_clock::now()) {}

void Progress::show(const World& world) {
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  particle_steps_ += static_cast<double>(world.particles.count()) * static_cast<double>(world.step - step_);
  step_ = world.step;
  const std::uint64_t tenth = last_ ? 10 * world.step / last_ : 10;
  if (!terminal_ && tenth == tenth_) return;
  tenth_ = tenth;
  const double done = static_cast<double>(world.step - first_), rate = seconds > 0 ? done / seconds : 0;
  const double left = rate > 0 ? static_cast<double>(last_ - world.step) / rate : -1;
  const double share = last_ ? 100.0 * static_cast<double>(world.step) / static_cast<double>(last_) : 100.0;
  const std::string line = fmt::format("{:5.1f} %  t = {:.4g} s  {} particles  {}steps/s  {}particle-steps/s  {} left",
                                       share, world.time(), world.particles.count(), rate_text(rate),
                                       rate_text(seconds > 0 ? particle_steps_ / seconds : 0), duration_text(left));
  if (terminal_)
    write_over(line, 100);
  else
    fmt::print(stderr, "{}\n", line);
  std::fflush(stderr);
}

void Progress::end() const {
  if (terminal_) fmt::print(stderr, "\n");
}

WorkProgress::WorkProgress(std::size_t pieces, bool quiet)
    : wanted_(!quiet && stderr_is_terminal()),
      pieces_(pieces),
      start_(std::chrono::steady_clock::now()),
      last_(start_) {}

void WorkProgress::show(std::size_t done, const std::string& what) {
  const auto now = std::chrono::steady_clock::now();
  if (!wanted_ || std::chrono::duration<double>(now - last_).count() < (shown_ ? 0.1 : 1.0)) return;
  last_ = now;
  shown_ = true;
  const double seconds = std::chrono::duration<double>(now - start_).count(), share = static_cast<double>(done);
  const double left = done > 0 ? seconds / share * static_cast<double>(pieces_ - done) : -1;
  const std::string line =
      fmt::format("{:5.1f} %  {}  {} left", 100 * share / static_cast<double>(pieces_), what, duration_text(left));
  write_over(line, 80);
  std::fflush(stderr);
}

void WorkProgress::end() const {
  if (shown_) fmt::print(stderr, "\n");
}

}  // namespace dem::cli
