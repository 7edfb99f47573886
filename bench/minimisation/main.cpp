// The linear program of constrained_minimisation (the largest ball between the planes of two polyhedra) by its own
// solver and by algorithms of NLopt, on the same pairs in one run.
//
// Right: the ball that is feasible where the search ended is within 1e-6 of the size below the proven optimum. Times
// are processor time of one thread per program: planes are prepared before for NLopt, not for our solver, which has no
// such form; medians over repetitions in which every solver has its turn. A program that does not end within 50 ms (in
// a child process, which tries all of them first) is lost: it counts as wrong and is not timed.
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <functional>

#include "bench/pairs/sets.h"
#include "libcontact/methods/half_space_program.h"
#include "libcontact/methods/nlopt_program.h"
#include "tests/guard/child.h"

namespace {

using contact::Body;
using shapes::Mat3d;
using shapes::Vec3d;
namespace other = contact::nlopt_program;

constexpr double right_within = 1e-6, tolerance = 1e-8;  // over the size
constexpr double give_up = 0.05;                         // s

struct Problem {
  contact::PolyhedronPair pair;
  other::HalfSpaces planes;
  Vec3d start;
  double size, least;  // what the optimum is proven to reach
};

const shapes::Polyhedron& shape_of(const Body& b) { return *static_cast<const shapes::Polyhedron*>(b.geometry); }

// In the frame of a, as the method asks.
Problem problem(const Body& a, const Body& b, const Vec3d& offset) {
  const Mat3d turn = transposed(a.rotation) * b.rotation;
  const Vec3d d = transposed_times(a.rotation, offset);
  Problem p{{&shape_of(a), &shape_of(b), a.size.x, b.size.x, turn, d}, {}, 0.5 * d, 0, 0};
  p.size = norm(d) + circumradius(a) + circumradius(b);
  for (const auto& f : shape_of(a).faces) {
    p.planes.normal.push_back(f.normal);
    p.planes.offset.push_back(a.size.x * f.offset);
  }
  p.planes.of_a = p.planes.normal.size();
  for (const auto& f : shape_of(b).faces) {
    p.planes.normal.push_back(turn * f.normal);
    p.planes.offset.push_back(b.size.x * f.offset + dot(p.planes.normal.back(), d));
  }
  p.least = contact::largest_ball(p.pair, p.size).lower;
  return p;
}

struct Solver {
  std::string name;
  std::function<double(const Problem&)> solve;  // t
  std::vector<std::size_t> answered{};          // of the problems
  double right = 0;                             // share
  std::vector<double> seconds{};                // per program, by repetition
  double median() const {
    std::vector<double> s = seconds;
    std::sort(s.begin(), s.end());
    return s.empty() ? 0 : s[s.size() / 2];
  }
};

std::vector<Solver> solvers() {
  std::vector<Solver> list{{"own dual simplex", [](const Problem& p) { return largest_ball(p.pair, p.size).lower; }}};
  for (const other::Algorithm algorithm : other::algorithms)
    list.push_back({other::name_of(algorithm), [algorithm](const Problem& p) {
                      return other::largest_ball(p.planes, p.start, p.size, tolerance * p.size, algorithm).t;
                    }});
  return list;
}

double processor_seconds() {
  timespec t;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

// At least 2 ms of it.
double seconds_each(const Solver& s, const std::vector<Problem>& problems) {
  const double begin = processor_seconds();
  std::size_t done = 0;
  volatile double sink = 0;
  do {
    for (const std::size_t i : s.answered) sink = sink + s.solve(problems[i]);
    done += s.answered.size();
  } while (processor_seconds() - begin < 2e-3);
  return (processor_seconds() - begin) / static_cast<double>(done);
}

struct Bars {
  double by_slsqp = 1e300, by_fastest = 1e300;
};

void measure(const pairs::Set& set, int repetitions, Bars& bars) {
  std::vector<Problem> problems;
  for (const pairs::Pair& p : set.list) problems.push_back(problem(set.bodies[p.a], set.bodies[p.b], p.offset));
  std::vector<Solver> list = solvers();
  for (Solver& s : list) {
    const auto t = guard::in_child(problems.size(), give_up, [&](std::size_t i) { return s.solve(problems[i]); });
    std::size_t right = 0;
    for (std::size_t i = 0; i < t.size(); ++i) {
      if (!t[i]) continue;
      s.answered.push_back(i);
      right += *t[i] >= problems[i].least - right_within * problems[i].size;
    }
    s.right = static_cast<double>(right) / static_cast<double>(problems.size());
  }
  for (int r = 0; r < repetitions; ++r)
    for (Solver& s : list)
      if (!s.answered.empty()) s.seconds.push_back(seconds_each(s, problems));
  const double own = list.front().median();
  double fastest = 1e300;
  fmt::print("{} ({} programs, {} planes in the first)\n", set.name(), problems.size(),
             problems.front().planes.normal.size());
  for (const Solver& s : list) {
    const double ratio = s.median() / own;
    const bool timed = !s.answered.empty();
    fmt::print("  {:<24} {:>6.1f} % right {:>4} lost {:>12} us {:>9} x own\n", s.name, 100 * s.right,
               problems.size() - s.answered.size(), timed ? fmt::format("{:.2f}", 1e6 * s.median()) : "-",
               timed ? fmt::format("{:.1f}", ratio) : "-");
    if (&s == &list.front() || !timed) continue;
    if (s.name == other::name_of(other::Algorithm::slsqp)) bars.by_slsqp = std::min(bars.by_slsqp, ratio);
    if (s.right >= 0.95) fastest = std::min(fastest, ratio);
  }
  bars.by_fastest = std::min(bars.by_fastest, fastest);
  std::fflush(stdout);
}

constexpr const char* usage =
    "bench_minimisation [--filter TEXT] [--pairs N] [--reps N]\n"
    "  --filter  only polyhedron pairs whose name (FAMILY/CONFIG) holds the text\n"
    "  --pairs   per set (20)\n"
    "  --reps    repetitions of which the median is printed (5)\n";

}  // namespace

int main(int argc, char** argv) {
  std::string filter;
  int repetitions = 5;
  std::size_t count = 20;
  for (int i = 1; i < argc; ++i) {
    const auto is = [&](const char* name) { return std::strcmp(argv[i], name) == 0 && i + 1 < argc; };
    if (is("--filter"))
      filter = argv[++i];
    else if (is("--pairs"))
      count = static_cast<std::size_t>(std::max(4, std::atoi(argv[++i])));
    else if (is("--reps"))
      repetitions = std::max(1, std::atoi(argv[++i]));
    else {
      const bool help = std::strcmp(argv[i], "--help") == 0;
      std::fputs(usage, help ? stdout : stderr);
      return help ? 0 : 2;
    }
  }
  Bars bars;
  for (const auto& set : pairs::all_sets(filter, count))
    if (set->a == shapes::Kind::polyhedron && set->b == shapes::Kind::polyhedron) measure(*set, repetitions, bars);
  fmt::print(
      "\nbars, over all sets: SLSQP over own {:.1f} (>= 20: {}); fastest right on 95 % over own {:.1f} (>= 100: {})\n",
      bars.by_slsqp, bars.by_slsqp >= 20 ? "pass" : "MISSED", bars.by_fastest,
      bars.by_fastest >= 100 ? "pass" : "MISSED");
  return 0;
}
