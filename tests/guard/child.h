// Jobs that may abort or hang, done in a child process, so that each loses its own answer alone.
//
// in_child(count, seconds, job): job(i) for every i, in order, and what it gave; nothing for those that threw, ended
// the process, or took more than `seconds` of processor time. A lost job costs a fork; what jobs change in memory is
// lost with the child. Answers are trivially copyable: they come back through shared memory. Test:
// tests/libcontact/child.cpp.
#pragma once

#include <sys/mman.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <exception>
#include <new>
#include <optional>
#include <type_traits>
#include <vector>

namespace guard {

template <class Job>
auto in_child(std::size_t count, double seconds, const Job& job) {
  using Answer = std::decay_t<decltype(job(std::size_t{}))>;
  static_assert(std::is_trivially_copyable_v<Answer>);
  enum State : unsigned char { not_asked, asked, answered };
  struct Slot {
    State state;
    alignas(Answer) unsigned char answer[sizeof(Answer)];
  };
  std::vector<std::optional<Answer>> out(count);
  if (count == 0) return out;
  void* const memory =
      mmap(nullptr, count * sizeof(Slot), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);  // zeros
  if (memory == MAP_FAILED) throw std::bad_alloc();
  Slot* const slots = static_cast<Slot*>(memory);
  const double whole = std::floor(seconds);
  const itimerval limit{{0, 0}, {static_cast<time_t>(whole), static_cast<suseconds_t>((seconds - whole) * 1e6)}};
  for (std::size_t next = 0; next < count;) {
    const pid_t child = fork();
    if (child < 0) break;  // the rest stays unanswered
    if (child == 0) {
      for (std::size_t i = next; i < count; ++i) {
        slots[i].state = asked;
        setitimer(ITIMER_PROF, &limit, nullptr);
        try {
          ::new (static_cast<void*>(slots[i].answer)) Answer(job(i));
          slots[i].state = answered;
        } catch (const std::exception&) {
        }
      }
      _exit(0);
    }
    int status = 0;
    waitpid(child, &status, 0);
    while (next < count && slots[next].state != not_asked) ++next;  // the last one begun is lost
    if (WIFEXITED(status) && WEXITSTATUS(status) == 0) break;
  }
  for (std::size_t i = 0; i < count; ++i)
    if (slots[i].state == answered) out[i] = *std::launder(reinterpret_cast<const Answer*>(slots[i].answer));
  munmap(memory, count * sizeof(Slot));
  return out;
}

}  // namespace guard
