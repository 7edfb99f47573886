// Nanoseconds per query of every pair: own methods, libccd and FCL, on the same pairs in one run.
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

#include "bench/pairs/entries.h"
#include "libcontact/kernels/chunk.h"

namespace {

constexpr const char* usage =
    "bench_pairs [--filter TEXT] [--reps N] [--pairs N] [--sample SECONDS] [--no-peers] [--csv FILE]\n"
    "  --filter   only pairs whose name (FAMILY/CONFIG) holds the text; the sphere pair is always there\n"
    "  --reps     interleaved repetitions of which the median is printed (9)\n"
    "  --pairs    pairs per set (200; a quarter of it for the dear ones)\n"
    "  --sample   least processor time of one repetition of one row (2e-4)\n"
    "Times are processor time of one thread. error, worst: of the gap over the size of the pair; own rows: half the\n"
    "width of the proven interval; peers: distance of their gap from ours. lost: pairs without an answer, not timed.\n";

}  // namespace

int main(int argc, char** argv) {
  std::string filter, csv;
  int repetitions = 9;
  std::size_t count = 200;
  double sample = 2e-4;
  bool peers = true;
  for (int i = 1; i < argc; ++i) {
    const auto is = [&](const char* name) { return std::strcmp(argv[i], name) == 0 && i + 1 < argc; };
    if (is("--filter"))
      filter = argv[++i];
    else if (is("--reps"))
      repetitions = std::atoi(argv[++i]);
    else if (is("--pairs"))
      count = static_cast<std::size_t>(std::max(4, std::atoi(argv[++i])));
    else if (is("--sample"))
      sample = std::atof(argv[++i]);
    else if (is("--csv"))
      csv = argv[++i];
    else if (std::strcmp(argv[i], "--no-peers") == 0)
      peers = false;
    else {
      const bool help = std::strcmp(argv[i], "--help") == 0;
      std::fputs(usage, help ? stdout : stderr);
      return help ? 0 : 2;
    }
  }
  const auto sets = pairs::all_sets(filter, count);
  std::vector<pairs::Entry> entries;
  for (const auto& set : sets) {
    pairs::add_own(*set, entries);
    if (peers) pairs::add_peers(*set, entries);
  }
  pairs::time_all(entries, repetitions, sample);
  std::printf("kernels %s, %s; median of %d interleaved repetitions\n", contact::kernels::kernels().name,
              peers ? pairs::peers_note() : "without peers", repetitions);
  pairs::print_table(entries);
  const int missed = pairs::print_bars(entries);
  std::printf("%d bars missed\n", missed);
  if (!csv.empty()) pairs::print_csv(entries, csv);
  return 0;
}
