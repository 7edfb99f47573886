// dem validate: the frame, and the quick ones of its list.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "libdem/scene/data_files.h"
#include "libdem/validate/list.h"
#include "tests/program/program.h"

namespace {

using namespace dem::validate;
using dem::World;
using program::Folder;
using program::Outcome;

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(Validate, EveryEntryHasASceneAndItsOwnName) {
  std::set<std::string> names;
  for (const Validation* v : validations()) {
    EXPECT_TRUE(names.insert(v->name).second) << v->name;
    EXPECT_TRUE(std::filesystem::exists(dem::scenes_folder() + "/" + v->scene)) << v->scene;
    EXPECT_GT(std::string(v->criterion).size(), 10u) << v->name;
    EXPECT_NE(v->check, nullptr) << v->name;
  }
  const Outcome o = program::dem({"validate", "--list"});
  EXPECT_EQ(o.exit_code, 0) << o.err;
  EXPECT_EQ(static_cast<std::size_t>(std::count(o.out.begin(), o.out.end(), '\n')), validations().size());
}

TEST(Validate, RunsAScenePrintsItsTableAndKeepsTheRun) {
  const Folder folder;
  const std::string out = folder.path("out"), csv = folder.path("table.csv");
  const Outcome o = program::dem({"validate", "two_bodies", "--out", out, "--csv", csv, "--threads", "1"});
  EXPECT_EQ(o.exit_code, 0) << o.out << o.err;
  EXPECT_TRUE(has(o.out, "criterion") && has(o.out, "restitution") && has(o.out, "1 of 1 scenes pass")) << o.out;
  for (const char* name : {"scene.toml", "summary.json", "final.csv"})
    EXPECT_TRUE(std::filesystem::exists(out + "/two_bodies/" + name)) << name;
  const std::string table = program::read(csv);
  EXPECT_EQ(table.find("scene,criterion,expected,got,pass,seconds\n"), 0u);
  EXPECT_TRUE(has(table, "two_bodies,restitution,")) << table;
  EXPECT_FALSE(has(table, ",no,")) << table;

  const Outcome again = program::dem({"validate", "two_bodies", "--out", out});
  EXPECT_EQ(again.exit_code, 2);
  EXPECT_TRUE(has(again.err, "is not empty")) << again.err;
  EXPECT_EQ(program::dem({"validate", "two_bodies", "--out", out, "--force"}).exit_code, 0);
}

TEST(Validate, UnknownNamesAreRefused) {
  const Outcome o = program::dem({"validate", "two_bodys"});
  EXPECT_EQ(o.exit_code, 2);
  EXPECT_TRUE(has(o.err, "did you mean two_bodies?")) << o.err;
}

TEST(Validate, WhatFailsIsARowThatDoesNotPass) {
  const Validation wrong{"x", "two_bodies.toml", "x", [](Runs& runs) -> std::vector<Row> {
                           const World w = runs.run({"run.steps=1"});
                           return {within("steps", static_cast<double>(w.step), 2, 0.1)};
                         }};
  EXPECT_FALSE(carry_out(wrong, "", 1).pass());
  const Validation refused{"x", "two_bodies.toml", "x", [](Runs& runs) -> std::vector<Row> {
                             return runs.run({"run.steps=-1"}), std::vector<Row>{};
                           }};
  const Result r = carry_out(refused, "", 1);
  EXPECT_FALSE(r.pass());
  EXPECT_TRUE(has(r.rows.at(0).got, "run.steps"));
  const Validation fails{"x", "two_bodies.toml", "x",
                         [](Runs&) -> std::vector<Row> { throw dem::RunError("step 3: broken"); }};
  const Result failed = carry_out(fails, "", 1);
  EXPECT_FALSE(failed.pass());
  EXPECT_EQ(failed.rows.at(0).got, "step 3: broken");
}

TEST(Validate, WhatIsToldForInformationDecidesNothing) {
  const Row told = for_information("angle", 37.6, "deg"), good = at_least("x", 1, 0), bad = at_least("x", -1, 0);
  EXPECT_EQ(told.got, "37.6 deg");
  EXPECT_TRUE((Result{{told, good}}.pass()));
  EXPECT_FALSE((Result{{told, bad}}.pass()));
  EXPECT_FALSE(Result{{told}}.pass());
}

TEST(Validate, RowsJudgeTheirBands) {
  EXPECT_TRUE(in_band("", 2, 1, 2).pass);
  EXPECT_FALSE(in_band("", 2.1, 1, 2).pass);
  EXPECT_TRUE(within("", -1.02, -1, 0.03).pass);
  EXPECT_FALSE(within("", -1.04, -1, 0.03).pass);
  EXPECT_TRUE(near("", 0.1, 0, 0.2).pass);
  EXPECT_FALSE(near("", 0.3, 0, 0.2).pass);
  EXPECT_FALSE(at_most("", 3, 2).pass);
  EXPECT_FALSE(at_least("", 1, 2).pass);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const Row& row :
       {in_band("", nan, 0, 1), within("", nan, 0, 1), near("", nan, 0, 1), at_most("", nan, 1), at_least("", nan, 1)})
    EXPECT_FALSE(row.pass);
}

}  // namespace
