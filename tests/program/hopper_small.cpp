// A small hopper with 150 bodies of all kinds, through the program: nothing leaves by the walls, everything is counted,
// and neither threads nor the skin change a byte of the end.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/program/program.h"

namespace {

using nlohmann::json;
using program::Folder;

// A wedge of 45 degrees, 100 x 70 mm above a slot of 40 x 70 mm; the gate goes at 0.15 s.
const char* const scene = R"(title = "a small hopper"
[run]
time = 0.24
dt_fraction = 0.4
seed = 1
[output]
picture = false
[world]
gravity = [0, 0, -9.81]
[law]
name = "hertz_mindlin"
[[material]]
name = "grain"
young = 1e6
poisson = 0.3
density = 2500
restitution = 0.4
friction = 0.4
[[shape]]
name = "ball"
kind = "sphere"
radius = 0.005
[[shape]]
name = "bean"
kind = "ellipsoid"
semi_axes = [6.55e-3, 5.04e-3, 3.78e-3]
[[shape]]
name = "brick"
kind = "box"
extents = [10.86e-3, 7.76e-3, 6.21e-3]
[[shape]]
name = "stone"
kind = "polyhedron"
file = "grain:ma165_01"
diameter = 0.010
[[wall]]
name = "hopper"
kind = "mesh"
material = "grain"
vertices = [
  [-0.02, -0.035, 0], [-0.02, 0.035, 0], [0.02, -0.035, 0], [0.02, 0.035, 0],
  [-0.05, -0.035, 0.03], [-0.05, 0.035, 0.03], [0.05, -0.035, 0.03], [0.05, 0.035, 0.03],
  [-0.05, -0.035, 0.14], [-0.05, 0.035, 0.14], [0.05, -0.035, 0.14], [0.05, 0.035, 0.14],
]
triangles = [
  [0, 4, 1], [1, 4, 5], [2, 3, 6], [3, 7, 6],
  [4, 8, 5], [5, 8, 9], [6, 7, 10], [7, 11, 10],
  [0, 2, 4], [2, 6, 4], [4, 6, 8], [6, 10, 8],
  [1, 5, 3], [3, 5, 7], [5, 9, 7], [7, 9, 11],
]
[[wall]]
name = "gate"
kind = "mesh"
material = "grain"
vertices = [[-0.02, -0.035, 0], [-0.02, 0.035, 0], [0.02, -0.035, 0], [0.02, 0.035, 0]]
triangles = [[0, 2, 1], [1, 2, 3]]
remove_at = 0.15
[[outlet]]
name = "slot"
point = [0, 0, -0.01]
normal = [0, 0, 1]
[[fill]]
lower = [-0.05, -0.035, 0.032]
upper = [0.05, 0.035, 0.12]
count = 150
items = [
  {shape = "ball", material = "grain", weight = 1, scale = [0.6, 0.9]},
  {shape = "bean", material = "grain", weight = 1, scale = [0.6, 0.9]},
  {shape = "brick", material = "grain", weight = 1, scale = [0.6, 0.9]},
  {shape = "stone", material = "grain", weight = 1, scale = [0.6, 0.9]},
]
)";

struct Result {
  std::string final_csv;
  json summary;
};

Result run(const std::vector<std::string>& arguments) {
  const Folder folder;
  std::vector<std::string> words{"run", folder.write("scene.toml", scene), "--out", folder.path("out"), "--quiet"};
  words.insert(words.end(), arguments.begin(), arguments.end());
  const program::Outcome o = program::dem(words);
  EXPECT_EQ(o.exit_code, 0) << o.err;
  return {program::read(folder.path("out/final.csv")), json::parse(program::read(folder.path("out/summary.json")))};
}

// How many centres of final.csv lie in the hopper, under the slot and outside of the walls.
struct Places {
  int inside = 0, under = 0, outside = 0;
};
Places places(const std::string& csv) {
  Places places;
  std::istringstream lines(csv);
  std::string line;
  std::getline(lines, line);
  EXPECT_EQ(line.rfind("id,shape,material,x,y,z,", 0), 0u) << line;
  while (std::getline(lines, line)) {
    std::istringstream words(line);
    std::string word;
    double at[3] = {};
    for (int i = 0; i < 6 && std::getline(words, word, ','); ++i)
      if (i >= 3) at[i - 3] = std::stod(word);
    const auto [x, y, z] = at;
    if (z < 0) {
      ++places.under;
    } else {
      const double half_width = std::min(0.05, 0.02 + z);
      ++(std::abs(x) < half_width && std::abs(y) < 0.035 ? places.inside : places.outside);
    }
  }
  return places;
}

void expect_balanced(const json& summary) {
  const json &counters = summary["counters"], &mass = summary["mass_balance"];
  EXPECT_EQ(counters["inserted"], 150);
  EXPECT_EQ(counters["deleted"].get<int>() + summary["particles"].get<int>(), 150);
  EXPECT_EQ(counters["not_converged"], 0);
  EXPECT_EQ(mass["initial_count"], 150);
  EXPECT_EQ(mass["present_count"], summary["particles"]);
  EXPECT_EQ(mass["removed_count"], counters["deleted"]);
  EXPECT_EQ(summary["outlets"][0]["count"], counters["deleted"]);
  EXPECT_EQ(summary["outlets"][0]["mass"], mass["removed"]);
  EXPECT_LE(mass["relative_error"].get<double>(), 1e-14);  // a sum of 150 terms
  EXPECT_LE(summary["momentum_balance"]["relative_error"].get<double>(), 1e-10);
  EXPECT_GT(summary["momentum_balance"]["scale"].get<double>(), 0);
}

TEST(HopperSmall, TheClosedHopperKeepsEverything) {
  const Result closed = run({"--set", "run.time=0.14", "--threads", "1"});
  expect_balanced(closed.summary);
  const Places p = places(closed.final_csv);
  EXPECT_EQ(p.inside, 150);
  EXPECT_EQ(p.under, 0);
  EXPECT_EQ(p.outside, 0);
}

// The count of places must see what leaves: the same without a gate.
TEST(HopperSmall, WithoutAGateBodiesAreSeenUnderTheSlot) {
  const Result open = run({"--set", "run.time=0.1", "--set", "wall.gate.remove_at=0.001", "--threads", "1", "--set",
                           "outlet.slot.point=[0, 0, -1]"});
  const Places p = places(open.final_csv);
  EXPECT_GT(p.under, 0);
  EXPECT_EQ(p.inside + p.under, 150);
}

TEST(HopperSmall, TheOpenHopperRunsOutThroughItsSlot) {
  const Result open = run({"--threads", "1"});
  expect_balanced(open.summary);
  const Places p = places(open.final_csv);
  const int deleted = open.summary["counters"]["deleted"];
  EXPECT_EQ(p.outside, 0);
  EXPECT_EQ(p.inside + p.under + deleted, 150);
  EXPECT_GT(deleted, 30);
  EXPECT_GT(p.inside, 0);
}

// The gate goes early, so that bodies collide, run out and are deleted within a short run.
Result short_run(const std::string& threads, const std::vector<std::string>& more = {}) {
  std::vector<std::string> words{"--threads", threads, "--set", "run.time=0.13", "--set", "wall.gate.remove_at=0.08"};
  words.insert(words.end(), more.begin(), more.end());
  return run(words);
}

TEST(HopperSmall, ThreadsDoNotChangeTheEnd) {
  const Result one = short_run("1");
  EXPECT_GT(one.summary["counters"]["deleted"], 0);
  EXPECT_GT(one.summary["particles"], 0);
  for (const char* threads : {"2", "3"}) EXPECT_EQ(short_run(threads).final_csv, one.final_csv) << threads;
}

TEST(HopperSmall, TheSkinDoesNotChangeTheEnd) {
  const Result one = short_run("1");
  for (const char* skin : {"run.skin=3e-4", "run.skin=2e-3"}) {
    const Result other = short_run("1", {"--set", skin});
    EXPECT_EQ(other.final_csv, one.final_csv) << skin;
    EXPECT_NE(other.summary["counters"]["rebuilds"], one.summary["counters"]["rebuilds"]);
  }
}

}  // namespace
