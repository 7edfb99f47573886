// A run with rain, outlets and events as a user starts it: what it ends with, what it writes, and its resume.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/program/program.h"

namespace {

using program::Folder;
using program::Outcome;

const char* const more = R"([[region]]
name = "above"
kind = "cylinder"
centre = [0, 0, 0.1]
radius = 0.05
height = 0.05
[[species]]
name = "old"
material = "glass"
[[species]]
name = "new"
[[rain]]
name = "shower"
region = "above"
rate = 2e4
velocity = [0, 0, -5]
items = [{ shape = "ball", material = "glass", scale = [0.5, 1], species = "new" }]
[[wall]]
name = "lid"
kind = "plane"
material = "glass"
present = false
point = [0, 0, 0.5]
normal = [0, 0, -1]
[[outlet]]
name = "west"
point = [-0.02, 0, 0]
normal = [1, 0, 0]
recycle_to = "above"
[[outlet]]
name = "east"
point = [0.02, 0, 0]
normal = [-1, 0, 0]
[[event]]
name = "close"
when = "count > 10"
delay = 1e-3
insert_wall = "lid"
gravity = [0, 0, -20]
)";

nlohmann::json summary(const std::string& folder) {
  return nlohmann::json::parse(program::read(folder + "/summary.json"));
}

std::string scene_text() {
  return program::replaced(program::small_scene, "steps = 200",
                           "steps = 900\nuntil = \"count >= 60\"\ncheck_every = 50") +
         more;
}

TEST(RunInTime, EndsByItsConditionAndSaysWhatHappened) {
  const Folder folder;
  const Outcome o =
      program::dem({"run", folder.write("scene.toml", scene_text()), "--out", folder.path("a"), "--quiet"});
  ASSERT_EQ(o.exit_code, 0) << o.err;
  EXPECT_NE(o.out.find("ended by run.until: count >= 60"), std::string::npos) << o.out;
  const auto s = summary(folder.path("a"));
  EXPECT_EQ(s["end"], "finished: run.until: count >= 60");
  EXPECT_LT(s["steps"].get<int>(), 900);
  EXPECT_EQ(s["steps"].get<int>() % 50, 0);
  EXPECT_GE(s["particles"].get<int>(), 60);
  EXPECT_LT(s["mass_balance"]["relative_error"].get<double>(), 1e-13);
  EXPECT_LT(s["momentum_balance"]["relative_error"].get<double>(), 1e-12);
  EXPECT_EQ(s["mass_balance"]["initial_count"], 3);
  EXPECT_EQ(s["mass_balance"]["inserted_count"], s["rain"][0]["count"]);
  EXPECT_GT(s["events"][0]["time"].get<double>(), 0);
  EXPECT_EQ(s["species"]["none"], 0);
  EXPECT_GT(s["species"]["new"].get<int>(), 50);
  const int left = s["outlets"][0]["count"].get<int>() + s["outlets"][1]["count"].get<int>();
  EXPECT_GT(left, 0);
  std::ifstream file(folder.path("a/discharge.csv"));
  std::string line;
  std::getline(file, line);
  EXPECT_EQ(line, "time,count,mass,outlet,outlet_count,outlet_mass,species");
  int rows = 0;
  while (std::getline(file, line)) ++rows;
  EXPECT_EQ(rows, left);
  EXPECT_NE(program::read(folder.path("a/final.csv")).find(",wz,species\n"), std::string::npos);
}

// Every file but the times of the summary is the same; a resume of a finished run says so.
TEST(RunInTime, AResumedRunEndsTheSame) {
  const Folder folder;
  const std::string scene = folder.write("scene.toml", scene_text());
  ASSERT_EQ(program::dem({"run", scene, "--out", folder.path("a"), "--quiet"}).exit_code, 0);
  ASSERT_EQ(
      program::dem({"run", scene, "--out", folder.path("b"), "--quiet", "--set", "output.checkpoint_interval=1e-3"})
          .exit_code,
      0);
  std::string last;  // the older of the two checkpoints is the one to go on from
  for (const auto& entry : std::filesystem::directory_iterator(folder.path("b")))
    if (entry.path().extension() == ".bin" && entry.path().string() > last) last = entry.path().string();
  std::filesystem::remove(last);
  std::filesystem::remove(folder.path("b/summary.json"));
  ASSERT_EQ(program::dem({"resume", folder.path("b"), "--quiet"}).exit_code, 0);
  EXPECT_EQ(summary(folder.path("b"))["state_hash"], summary(folder.path("a"))["state_hash"]);
  for (const char* name : {"/final.csv", "/discharge.csv"})
    EXPECT_EQ(program::read(folder.path("b") + name), program::read(folder.path("a") + name)) << name;
  const Outcome again = program::dem({"resume", folder.path("b")});
  EXPECT_NE(again.out.find("finished already"), std::string::npos) << again.out << again.err;
}

}  // namespace
