// bench_cells: what the search for neighbours costs against the side of its cells, for the settled bed of 10,000
// spheres and for the same spheres with radii spread over a factor of 20. One thread, processor time, medians over
// repetitions in turn.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <string>
#include <vector>

#include "libdem/broad_phase/levels.h"
#include "libdem/io/io.h"

namespace {

constexpr double skin = 2e-4;  // m
constexpr int repetitions = 9;

std::vector<dem::Motion> bed() {
  const dem::io::Table table = dem::io::read_csv(PROJECT_ROOT "/bench/data/spheres_1e4.csv.gz");
  const std::size_t columns[] = {dem::io::column(table, "x"), dem::io::column(table, "y"), dem::io::column(table, "z"),
                                 dem::io::column(table, "radius")};
  std::vector<dem::Motion> bodies(table.row_count());
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    for (int k = 0; k < 3; ++k) bodies[i].position[k] = dem::io::number(table, i, columns[k]);
    bodies[i].bounding_radius = dem::io::number(table, i, columns[3]);
  }
  return bodies;
}

// In order of storage as the loop has them.
std::vector<dem::Motion> sorted(const std::vector<dem::Motion>& bodies) {
  std::vector<dem::Motion> list;
  const std::vector<double> allowance(bodies.size(), skin / 2);
  for (const std::uint32_t i : dem::order_in_space(bodies, allowance, {})) list.push_back(bodies[i]);
  return list;
}

double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

void table(const std::string& title, const std::vector<dem::Motion>& bodies) {
  const std::vector<double> sides = {0.4, 0.5, 0.7, 1, 1.5, 2, 3, 4, 5};
  std::vector<std::vector<double>> times(sides.size());
  const std::vector<double> allowance(bodies.size(), skin / 2);
  std::size_t pairs = 0;
  for (int r = 0; r < repetitions; ++r)
    for (std::size_t s = 0; s < sides.size(); ++s) {
      const double began = processor_seconds();
      const dem::Levels levels(bodies, allowance, {}, sides[s]);
      pairs = 0;
      for (std::size_t i = 0; i < bodies.size(); ++i) levels.near(i, [&](std::uint32_t j) { pairs += j > i ? 1 : 0; });
      times[s].push_back(1e9 * (processor_seconds() - began) / static_cast<double>(bodies.size()));
    }
  std::vector<double> medians;
  for (auto& list : times) {
    std::sort(list.begin(), list.end());
    medians.push_back(list[list.size() / 2]);
  }
  const double best = *std::min_element(medians.begin(), medians.end());
  fmt::print("{}: {} bodies, {:.2f} pairs a body\n| side over reach | ns a body (range) | x best |\n|---|---|---|\n",
             title, bodies.size(), static_cast<double>(pairs) / static_cast<double>(bodies.size()));
  for (std::size_t s = 0; s < sides.size(); ++s)
    fmt::print("| {:g} | {:.0f} ({:.0f}–{:.0f}) | {:.2f} |\n", sides[s], medians[s], times[s].front(), times[s].back(),
               medians[s] / best);
}

}  // namespace

int main(int count, char**) {
  if (count > 1) {
    fmt::print(
        "bench_cells: nanoseconds a body of a search for neighbours, cells included, against the side of the cells\n"
        "over the reach (two radii and the skin). No options.\n");
    return 0;
  }
  std::vector<dem::Motion> bodies = sorted(bed());
  table("settled bed", bodies);
  for (std::size_t i = 0; i < bodies.size(); ++i)
    bodies[i].bounding_radius *= std::pow(20, -static_cast<double>(i % 97) / 96);
  fmt::print("\n");
  table("radii over a factor of 20", sorted(bodies));
}
