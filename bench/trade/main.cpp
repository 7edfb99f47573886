// What each digit costs on this machine.
#include <fmt/format.h>
#include <unistd.h>

#include <cstdlib>
#include <cstring>

#include "bench/trade/trade.h"
#include "libcontact/kernels/chunk.h"

namespace {

constexpr const char* usage =
    "bench_trade [--filter TEXT] [--pairs N] [--truth N] [--reps N] [--sample SECONDS] [--csv FILE] [--json FILE]\n"
    "  --filter   only pairs whose name (FAMILY/CONFIG) holds the text\n"
    "  --pairs    pairs per set (64); fewer of ways that are slow\n"
    "  --truth    pairs of each set whose truth is found in 50 digits (8); 2 of the largest polyhedra\n"
    "  --reps     interleaved repetitions of which median and range are printed (7)\n"
    "  --sample   least processor time of one repetition of one row (2e-4)\n"
    "Every method of the catalogue, auto to tolerances, in chunks and warm: time, errors, shares. "
    "bench/trade/figures.py\n"
    "draws the figures from the CSV file.\n";

constexpr const char* families[] = {"sphere",
                                    "ellipsoid_1_1_1.5",
                                    "ellipsoid_1_1_3",
                                    "ellipsoid_1_1_10",
                                    "ellipsoid_1_1_100",
                                    "ellipsoid_1_10_10",
                                    "cube",
                                    "poly12",
                                    "poly50",
                                    "poly200",
                                    "poly1000",
                                    "grain_coarse",
                                    "grain_fine",
                                    "rounded50",
                                    "potential",
                                    "disc",
                                    "ellipse_1_1.5",
                                    "ellipse_1_3",
                                    "ellipse_1_10",
                                    "ellipse_1_100",
                                    "octagon"};
constexpr pairs::Config configs[] = {{"apart", 0.05}, {"touch", -1e-3}, {"graze", -1e-5}, {"deep", -0.2}};

}  // namespace

int main(int argc, char** argv) {
  trade::Settings settings;
  std::string filter, csv, json;
  for (int i = 1; i < argc; ++i) {
    const auto is = [&](const char* name) { return std::strcmp(argv[i], name) == 0 && i + 1 < argc; };
    if (is("--filter"))
      filter = argv[++i];
    else if (is("--pairs"))
      settings.pairs = static_cast<std::size_t>(std::max(4, std::atoi(argv[++i])));
    else if (is("--truth"))
      settings.truth = static_cast<std::size_t>(std::max(0, std::atoi(argv[++i])));
    else if (is("--reps"))
      settings.repetitions = std::max(1, std::atoi(argv[++i]));
    else if (is("--sample"))
      settings.sample = std::atof(argv[++i]);
    else if (is("--csv"))
      csv = argv[++i];
    else if (is("--json"))
      json = argv[++i];
    else {
      const bool help = std::strcmp(argv[i], "--help") == 0;
      std::fputs(usage, help ? stdout : stderr);
      return help ? 0 : 2;
    }
  }
  std::vector<std::unique_ptr<pairs::Set>> sets;
  std::vector<trade::Row> rows;
  const bool terminal = isatty(2) != 0;
  for (const char* family : families)
    for (const pairs::Config& config : configs) {
      const std::string name = std::string(family) + "/" + config.name;
      if (name.find(filter) == std::string::npos) continue;
      if (terminal) fmt::print(stderr, "\r\033[K{}", name);
      const bool large = std::strcmp(family, "poly200") == 0 || std::strcmp(family, "poly1000") == 0;
      trade::Settings these = settings;
      if (large) these.truth = std::min<std::size_t>(2, settings.truth);
      sets.push_back(pairs::make_set(family, family, config, settings.pairs));
      for (trade::Row& row : trade::measure(*sets.back(), these)) rows.push_back(std::move(row));
    }
  if (terminal) fmt::print(stderr, "\r\033[K");
  fmt::print("kernels {}; {} pairs a set, {} with the truth in 50 digits; median of {} interleaved repetitions\n",
             contact::kernels::kernels().name, settings.pairs, settings.truth, settings.repetitions);
  trade::print_rows(rows);
  trade::print_choice(rows);
  const int missed = trade::print_bars(rows);
  fmt::print("{} bars missed\n", missed);
  if (!csv.empty()) trade::write_csv(rows, csv);
  if (!json.empty()) trade::write_json(rows, settings, json);
  return 0;
}
