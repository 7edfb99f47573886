// pair_fuzz FOLDER SEED CASES [PAIRS]: random and adversarial pairs through every method and pair of kinds in the
// catalogue, CASES each (of potential particles, which cost up to 3 ms, a hundredth), checked by
// tests/fuzz/pair_checks.h. PAIRS: a text that "METHOD KIND KIND" holds, or K/N for every N-th entry from the K-th on.
// Prints a row for each, and the first case that breaks each rule: it stands in FOLDER, for `dem contact`. Exit status
// 1 when a rule was broken or a good pair refused. The same seed gives the same cases, whatever PAIRS is. 10^7 of each:
// tests/fuzz/run_pair_fuzz.sh
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>
#include <string>

#include "tests/fuzz/pair_checks.h"

namespace {

using namespace pair_fuzz;

struct Row {
  long cases = 0, uncertified = 0, not_converged = 0, wider = 0, off = 0, refused = 0, broken = 0;
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

Row run(const MethodInfo& m, std::uint64_t seed, long count, const std::string& folder) {
  Row row;
  std::set<std::string> seen;  // rules that were broken
  for (; row.cases < count; ++row.cases) {
    Source source(seed * 0x9e3779b97f4a7c15u + static_cast<std::uint64_t>(row.cases));
    const PairCase pair = draw_pair(m, source);
    const Judgement j = judge(pair, m, source);
    row.uncertified += j.uncertified && !j.refused;
    row.not_converged += j.not_converged;
    row.wider += j.width > 256;
    row.off += j.points > 64;
    row.farthest = std::max(row.farthest, j.points);
    row.widest = std::max(row.widest, j.width);
    row.refused += j.refused;
    row.broken += j.broken != nullptr;
    const char* what = j.refused ? "refused" : j.broken;
    if (what && seen.insert(what).second) report(m, pair, what, j.by, seed, row.cases, folder);
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
      "{:<17}{:<19}{:<19}{:>9}{:>12}{:>14}{:>7}{:>10}{:>7}{:>10}{:>8}{:>7}\n",
      "method", "a", "b", "cases", "uncertified", "not converged", "wider", "widest", "off", "farthest", "refused",
      "broken");
  long bad = 0, rows = 0;
  for (const MethodInfo* m = contact::methods_begin(); m != contact::methods_end(); ++m) {
    const std::string name = fmt::format("{} {} {}", m->name, shapes::name_of(m->a), shapes::name_of(m->b));
    if (by_number ? (m - contact::methods_begin()) % shards != shard : name.find(only) == std::string::npos) continue;
    const bool dear = m->a == Kind::potential_particle || m->b == Kind::potential_particle;
    const Row r = run(*m, seed, dear ? count / 100 : count, folder);
    fmt::print("{:<17}{:<19}{:<19}{:>9}{:>12}{:>14}{:>7}{:>10.3g}{:>7}{:>10.3g}{:>8}{:>7}\n", m->name,
               shapes::name_of(m->a), shapes::name_of(m->b), r.cases, r.uncertified, r.not_converged, r.wider, r.widest,
               r.off, r.farthest, r.refused, r.broken);
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
