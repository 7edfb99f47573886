// pair_fuzz FOLDER SEED CASES [PAIRS]: random and adversarial pairs through every method and pair of kinds in the
// catalogue, CASES each (of potential particles, which cost up to 3 ms, and of other libraries a hundredth), checked by
// tests/fuzz/pair_checks.h. Other libraries are asked in a child process, a second for each case: what is lost there is
// counted and is no fault of ours. PAIRS: a text that "METHOD KIND KIND" holds, or K/N for every N-th entry from the
// K-th on. Prints a row for each, and the first case that breaks each rule: it stands in FOLDER, for `dem contact`.
// Exit status 1 when a rule was broken or a good pair refused. The same seed gives the same cases, whatever PAIRS is.
// 10^7 of each: tests/fuzz/run_pair_fuzz.sh
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "libcontact/methods/other_libraries.h"
#include "tests/fuzz/pair_checks.h"
#include "tests/guard/child.h"

namespace {

using namespace pair_fuzz;

struct Row {
  long cases = 0, lost = 0, uncertified = 0, not_converged = 0, wider = 0, off = 0, refused = 0, broken = 0;
  double widest = 0, farthest = 0;
};

void report(const MethodInfo& m, const PairCase& pair, const char* what, double by, std::uint64_t seed, long index,
            const std::string& folder) {
  const std::string name = fmt::format("{}_{}_{}", m.name, shapes::name_of(m.a), shapes::name_of(m.b));
  const std::string text = case_file(pair, fmt::format("{}_{}_{}", name, seed, index));
  fmt::print("  {} seed {} case {}: {}{}\n", name, seed, index, what,
             by > 0 ? fmt::format(" by {:.3g} eps L", by) : "");
  if (text.empty()) return;
  const std::string path = fmt::format("{}/{}_{}_{}.json", folder, name, seed, index);
  std::ofstream(path) << text;
  fmt::print("  dem contact {}\n", path);
}

bool by_another_library(const MethodInfo& m) { return m.cost_rank >= contact::first_rank_of_other_libraries; }

std::uint64_t seed_of_case(std::uint64_t seed, long index) {
  return seed * 0x9e3779b97f4a7c15u + static_cast<std::uint64_t>(index);
}

Judgement judge_case(const MethodInfo& m, std::uint64_t seed, long index) {
  Source source(seed_of_case(seed, index));
  const PairCase pair = draw_pair(m, source);
  return judge(pair, m, source);
}

// What becomes of the cases from `first` on.
std::vector<std::optional<Judgement>> judge_cases(const MethodInfo& m, std::uint64_t seed, long first, long count) {
  const auto one = [&](std::size_t i) { return judge_case(m, seed, first + static_cast<long>(i)); };
  const auto n = static_cast<std::size_t>(count);
  if (by_another_library(m)) return guard::in_child(n, 1, one);
  std::vector<std::optional<Judgement>> out;
  for (std::size_t i = 0; i < n; ++i) out.emplace_back(one(i));
  return out;
}

Row run(const MethodInfo& m, std::uint64_t seed, long count, const std::string& folder) {
  constexpr long at_once = 256;
  Row row;
  std::set<std::string> seen;  // rules that were broken
  while (row.cases < count)
    for (const std::optional<Judgement>& one : judge_cases(m, seed, row.cases, std::min(at_once, count - row.cases))) {
      const long index = row.cases++;
      row.lost += !one;
      if (!one) continue;
      const Judgement& j = *one;
      row.uncertified += j.uncertified && !j.refused;
      row.not_converged += j.not_converged;
      row.wider += j.width > 256;
      row.off += j.points > 64;
      row.farthest = std::max(row.farthest, j.points);
      row.widest = std::max(row.widest, j.width);
      row.refused += j.refused;
      row.broken += j.broken != nullptr;
      const char* what = j.refused ? "refused" : j.broken;
      if (!what || !seen.insert(what).second) continue;
      Source source(seed_of_case(seed, index));
      report(m, draw_pair(m, source), what, j.by, seed, index, folder);
    }
  return row;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 4) {
    fmt::print(stderr, "pair_fuzz FOLDER SEED CASES [PAIRS]\n");
    return 2;
  }
  const std::string folder = argv[1], only = argc > 4 ? argv[4] : "";
  long shard = 0, shards = 1;
  const bool by_number = std::sscanf(only.c_str(), "%ld/%ld", &shard, &shards) == 2 && shards > 0;
  const auto seed = static_cast<std::uint64_t>(std::strtoull(argv[2], nullptr, 10));
  const long count = std::strtol(argv[3], nullptr, 10);
  std::filesystem::create_directories(folder);
  fmt::print(
      "bounds are wider than 256 eps L, witness points off by more than 64 eps L (and the worst of either, in eps L)\n"
      "{:<25}{:<19}{:<19}{:>9}{:>6}{:>12}{:>14}{:>9}{:>10}{:>9}{:>10}{:>8}{:>7}\n",
      "method", "a", "b", "cases", "lost", "uncertified", "not converged", "wider", "widest", "off", "farthest",
      "refused", "broken");
  long bad = 0, rows = 0;
  for (const MethodInfo* m = contact::methods_begin(); m != contact::methods_end(); ++m) {
    const std::string name = fmt::format("{} {} {}", m->name, shapes::name_of(m->a), shapes::name_of(m->b));
    if (by_number ? (m - contact::methods_begin()) % shards != shard : name.find(only) == std::string::npos) continue;
    const bool dear = m->a == Kind::potential_particle || m->b == Kind::potential_particle || by_another_library(*m);
    const Row r = run(*m, seed, dear ? count / 100 : count, folder);
    fmt::print("{:<25}{:<19}{:<19}{:>9}{:>6}{:>12}{:>14}{:>9}{:>10.3g}{:>9}{:>10.3g}{:>8}{:>7}\n", m->name,
               shapes::name_of(m->a), shapes::name_of(m->b), r.cases, r.lost, r.uncertified, r.not_converged, r.wider,
               r.widest, r.off, r.farthest, r.refused, r.broken);
    std::fflush(stdout);
    bad += r.refused + r.broken;
    ++rows;
  }
  if (rows == 0) {
    fmt::print(stderr, "PAIRS \"{}\": no entry of the catalogue holds it\n", only);
    return 2;
  }
  return bad > 0 ? 1 : 0;
}
