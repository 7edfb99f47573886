// Time that this program has computed, s: other programs on the machine do not count.
#pragma once

#include <ctime>

namespace dem::forecast {

inline double seconds_of(clockid_t clock) {
  timespec t{};
  clock_gettime(clock, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}
inline double thread_seconds() { return seconds_of(CLOCK_THREAD_CPUTIME_ID); }    // of this thread
inline double process_seconds() { return seconds_of(CLOCK_PROCESS_CPUTIME_ID); }  // of all threads together
inline double wall_seconds() { return seconds_of(CLOCK_MONOTONIC); }

}  // namespace dem::forecast
