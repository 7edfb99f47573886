// Generated grains in scenes: what a user writes, and what is refused.
#include <gtest/gtest.h>

#include "libdem/scene/scene.h"
#include "tests/program/program.h"

namespace {

using program::Folder;
using program::Outcome;

const std::string grains = R"(
[[shape]]
name = "gravel"
kind = "generated"
statistic = "sample.csv"
set = "a"
variants = 8
diameter = 0.004
[[shape]]
name = "chips"
kind = "voronoi"
relaxations = 1
variants = 70
diameter = 0.003
[[fill]]
lower = [-0.05, 0.02, 0.01]
upper = [0.05, 0.06, 0.03]
count = 40
items = [{ shape = "gravel", material = "glass", weight = 1 }, { shape = "chips", material = "glass", weight = 1 }]
[[body]]
shape = "gravel"
material = "glass"
position = [0, -0.03, 0.02]
)";
const std::string sample = "set,L,W,T,sphericity\na,10,8,6,0.8\na,10,7,5,0.75\nb,3,3,3,0.9\n";

TEST(GeneratedGrains, ASceneRunsIsWrittenAndReadsBack) {
  const Folder folder;
  folder.write("sample.csv", sample);
  const std::string scene = folder.write("scene.toml", program::small_scene + grains);
  const Outcome run = program::dem({"run", scene, "--out", folder.path("out")});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const std::string text = program::read(folder.path("out/scene.toml"));
  EXPECT_EQ(dem::scene_to_toml(dem::load_scene(folder.path("out/scene.toml"))), text);
  EXPECT_NE(program::read(folder.path("out/final.csv")).find(",gravel#4,glass,"), std::string::npos);
  const Outcome check = program::dem({"check", scene});
  ASSERT_EQ(check.exit_code, 0) << check.err;
  EXPECT_NE(check.out.find("8 variants of kind polyhedron"), std::string::npos) << check.out;
  const Outcome list = program::dem({"list", "grains"});
  EXPECT_NE(list.out.find("ct:all"), std::string::npos);
}

struct Bad {
  const char* name;
  const char* from;
  const char* to;
  const char* sample_from;
  const char* sample_to;
  std::vector<const char*> message;
};
void PrintTo(const Bad& b, std::ostream* out) { *out << b.name; }

const std::vector<Bad> inputs{
    {"no_file", "sample.csv", "samples.csv", "", "", {"scene.toml:", "shape.statistic", "no such file"}},
    {"shipped", "sample.csv", "ct:al", "", "", {"shape.statistic", "did you mean ct:all?"}},
    {"no_statistic", "statistic = \"sample.csv\"", "", "", "", {"shape.statistic is missing"}},
    {"no_size", "diameter = 0.004", "", "", "", {"shape.diameter is missing"}},
    {"set", "set = \"a\"", "set = \"c\"", "", "", {"sample.csv:1:1", "no row has set = c; the file has a, b"}},
    {"variants", "variants = 8", "variants = 0", "", "", {"shape.variants = 0"}},
    {"relaxations", "relaxations = 1", "relaxations = -1", "", "", {"shape.relaxations = -1"}},
    {"of_a_box", "relaxations = 1", "statistic = \"ct:all\"", "", "", {"shape.statistic: applies only where"}},
    {"rounding", "diameter = 0.003", "diameter = 0.003\nrounding = 0.002", "", "", {"chips", "does not fit"}},
    {"column", "", "", "L,W,T", "L,W,H", {"sample.csv:1:1", "column 'T' is missing"}},
    {"order", "", "", "10,7,5", "7,10,5", {"sample.csv:3:3", "L >= W >= T"}},
    {"sphericity", "", "", "0.75", "75", {"sample.csv:3:10", "sphericity is above 1"}},
    {"negative", "", "", "10,7,5", "10,7,-5", {"sample.csv:3:8: T = -5: allowed > 0"}},
    {"word", "", "", "10,7,5", "10,7,x", {"sample.csv:3:8"}},
    {"part",
     "kind = \"voronoi\"\nrelaxations = 1\nvariants = 70\ndiameter = 0.003",
     "kind = \"union\"\nparts = [{ shape = \"gravel\" }]",
     "",
     "",
     {"shape.parts", "\"gravel\" is of kind generated"}},
};

class BadGrains : public testing::TestWithParam<Bad> {};

TEST_P(BadGrains, AreRefused) {
  const Folder folder;
  const Bad& bad = GetParam();
  folder.write("sample.csv", program::replaced(sample, bad.sample_from, bad.sample_to));
  const std::string text = program::small_scene + program::replaced(grains, bad.from, bad.to);
  const Outcome o = program::dem({"run", folder.write("scene.toml", text), "--out", folder.path("out")});
  EXPECT_EQ(o.exit_code, 2) << o.err;
  for (const char* fragment : bad.message)
    EXPECT_NE(o.err.find(fragment), std::string::npos) << fragment << "\nnot in\n" << o.err;
  EXPECT_EQ(folder.files().size(), 2u);
}

INSTANTIATE_TEST_SUITE_P(Table, BadGrains, testing::ValuesIn(inputs), [](const auto& i) { return i.param.name; });

}  // namespace
