// Bodies of parts in scenes: what a user writes, and what is refused.
#include <gtest/gtest.h>

#include <algorithm>

#include "libdem/scene/scene.h"
#include "libdem/world.h"
#include "tests/program/program.h"

namespace {

using program::Folder;
using program::Outcome;

const std::string shapes = R"(
[[shape]]
name = "bar"
kind = "box"
extents = [0.012, 0.004, 0.004]
[[shape]]
name = "wedge"
kind = "polyhedron"
vertices = [[0, 0, 0], [0.004, 0, 0], [0, 0.004, 0], [0, 0, 0.004]]
[[shape]]
name = "peanut"
kind = "clump"
spheres = [[-0.002, 0, 0, 0.003], [0.002, 0, 0, 0.0025]]
[[shape]]
name = "tool"
kind = "union"
parts = [{ shape = "bar" }, { shape = "wedge", position = [0.006, -0.002, -0.002] },
         { shape = "egg", position = [-0.006, 0, 0], orientation = [0.6, 0, 0.8, 0] }]
[[body]]
shape = "peanut"
material = "glass"
position = [0.03, 0, 0.006]
[[body]]
shape = "tool"
material = "glass"
position = [-0.03, 0, 0.012]
orientation = [0.8, 0.6, 0, 0]
)";

TEST(Parts, ASceneRunsIsWrittenAndReadsBack) {
  const Folder folder;
  const std::string scene = folder.write("scene.toml", program::small_scene + shapes);
  const Outcome run = program::dem({"run", scene, "--out", folder.path("out")});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const std::string text = program::read(folder.path("out/scene.toml"));
  EXPECT_EQ(dem::scene_to_toml(dem::load_scene(folder.path("out/scene.toml"))), text);
  EXPECT_NE(text.find("spheres = [[-0.002"), std::string::npos) << text;
  EXPECT_NE(text.find("{ shape = \"egg\", position = [-0.006"), std::string::npos) << text;
  EXPECT_NE(program::read(folder.path("out/final.csv")).find(",tool,glass,"), std::string::npos);
  const Outcome check = program::dem({"check", scene});
  ASSERT_EQ(check.exit_code, 0) << check.err;
  EXPECT_NE(check.out.find("compound, 3 parts"), std::string::npos) << check.out;
  EXPECT_NE(check.out.find("compound, 2 parts"), std::string::npos) << check.out;
}

// Spheres of a file, in any unit: shape.diameter says the size.
TEST(Parts, AFileOfSpheres) {
  const Folder folder;
  folder.write("peanut.csv", "# a peanut\nx,y,z,radius\n-4,0,0,6\n4,0,0,5\n");
  const std::string text = program::replaced(shapes, "spheres = [[-0.002, 0, 0, 0.003], [0.002, 0, 0, 0.0025]]",
                                             "spheres_file = \"peanut.csv\"\ndiameter = 0.007");
  const dem::World w = dem::build_world(dem::load_scene(folder.write("scene.toml", program::small_scene + text)));
  const auto peanut = std::find_if(w.shapes.begin(), w.shapes.end(), [](const auto& s) { return s.name == "peanut"; });
  ASSERT_NE(peanut->compound, nullptr);
  EXPECT_EQ(peanut->compound->parts.size(), 2u);
  EXPECT_NEAR(peanut->equivalent_radius, 0.0035, 1e-12);
  folder.write("peanut.csv", "x,y,z,radius\n-4,0,0,6\n4,0,0,-5\n");
  const Outcome bad = program::dem({"check", folder.path("scene.toml")});
  EXPECT_EQ(bad.exit_code, 2);
  EXPECT_NE(bad.err.find("peanut.csv:3:7: radius = -5: allowed radius > 0"), std::string::npos) << bad.err;
}

TEST(Parts, APartFarOffIsTold) {
  const Folder folder;
  const std::string text =
      program::replaced(program::replaced(shapes, "[0.002, 0, 0, 0.0025]", "[0.012, 0, 0, 0.0025]"),
                        "position = [0.03, 0, 0.006]", "position = [0.06, 0, 0.006]");
  const Outcome check = program::dem({"check", folder.write("scene.toml", program::small_scene + text)});
  EXPECT_EQ(check.exit_code, 0) << check.err;
  EXPECT_NE(check.out.find("\"peanut\": 1 of its 2 parts touch none of the others"), std::string::npos) << check.out;
}

struct Bad {
  const char* name;
  const char* from;
  const char* to;
  std::vector<const char*> message;
};
void PrintTo(const Bad& b, std::ostream* out) { *out << b.name; }

const std::vector<Bad> inputs{
    {"radius", "0, 0, 0.003]", "0, 0, -0.003]", {"scene.toml:", "shape.spheres", "allowed radius > 0", "-0.003"}},
    {"no_radius", "0, 0, 0.003]", "0, 0]", {"shape.spheres", "lists of 4 numbers"}},
    {"no_spheres",
     "spheres = [[-0.002, 0, 0, 0.003], [0.002, 0, 0, 0.0025]]",
     "",
     {"scene.toml:", "\"peanut\" needs exactly one of spheres and spheres_file"}},
    {"no_file",
     "spheres = [[-0.002, 0, 0, 0.003], [0.002, 0, 0, 0.0025]]",
     "spheres_file = \"none.csv\"",
     {"none.csv"}},
    {"no_number", "[-0.002, 0, 0, 0.003]", "[nan, 0, 0, 0.003]", {"shape.spheres"}},
    {"endless", "position = [-0.006, 0, 0]", "position = [inf, 0, 0]", {"shape.parts.position"}},
    {"rounded",
     "extents = [0.012, 0.004, 0.004]",
     "extents = [0.012, 0.004, 0.004]\nrounding = 0.001",
     {"shape.parts", "\"bar\" has shape.rounding", "allowed: solids with sharp edges"}},
    {"empty_spheres", "[[-0.002, 0, 0, 0.003], [0.002, 0, 0, 0.0025]]", "[]", {"shape.spheres"}},
    {"spheres_of_a_box",
     "extents = [0.012, 0.004, 0.004]",
     "extents = [0.012, 0.004, 0.004]\nspheres = [[0, 0, 0, 1]]",
     {"shape.spheres: applies only where kind = clump", "\"box\""}},
    {"unknown_part",
     "{ shape = \"bar\" }",
     "{ shape = \"baar\" }",
     {"shape.parts.shape = \"baar\"", "did you mean bar?"}},
    {"itself", "{ shape = \"bar\" }", "{ shape = \"tool\" }", {"shape.parts", "\"tool\" is of kind union"}},
    {"a_clump", "{ shape = \"bar\" }", "{ shape = \"peanut\" }", {"\"peanut\" is of kind clump", "allowed: sphere"}},
    {"no_part", "{ shape = \"bar\" }", "{ position = [0, 0, 0] }", {"shape.parts.shape is missing"}},
    {"unknown_key", "{ shape = \"bar\" }", "{ shape = \"bar\", place = [0, 0, 0] }", {"unknown key shape.parts.place"}},
    {"quaternion", "[0.6, 0, 0.8, 0]", "[0.6, 0, 0.9, 0.5]", {"shape.parts.orientation", "found 1.42"}},
    {"no_parts", "kind = \"union\"", "kind = \"union\"\nradius = 1", {"shape.radius: applies only where"}},
    {"too_deep",
     "position = [-0.03, 0, 0.012]",
     "position = [-0.03, 0, 0.002]",
     {"overlaps wall", "max_initial_overlap"}},
};

class BadParts : public testing::TestWithParam<Bad> {};

TEST_P(BadParts, AreRefused) {
  const Folder folder;
  const std::string text = program::small_scene + program::replaced(shapes, GetParam().from, GetParam().to);
  const Outcome o = program::dem({"run", folder.write("scene.toml", text), "--out", folder.path("out")});
  EXPECT_EQ(o.exit_code, 2) << o.err;
  for (const char* fragment : GetParam().message)
    EXPECT_NE(o.err.find(fragment), std::string::npos) << fragment << "\nnot in\n" << o.err;
  EXPECT_EQ(folder.files().size(), 1u);
}

INSTANTIATE_TEST_SUITE_P(Table, BadParts, testing::ValuesIn(inputs), [](const auto& i) { return i.param.name; });

}  // namespace
