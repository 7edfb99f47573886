// Scenes put together from several files; named materials and published friction; dem new.
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "libdem/scene/material_library.h"
#include "libdem/scene/scene.h"
#include "tests/program/program.h"

namespace {

using namespace dem;
using program::Folder;
using program::Outcome;
using program::replaced;

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

std::string refusal(const std::string& path) {
  try {
    load_scene(path);
  } catch (const InputError& error) {
    return error.what();
  }
  ADD_FAILURE() << path << " was accepted";
  return "";
}

TEST(Include, TablesAddUpAndKeysReplace) {
  const Folder folder;
  std::filesystem::create_directory(folder.path("parts"));
  folder.write("parts/walls.toml",
               "include = [\"../common.toml\"]\n[[wall]]\nname = \"lid\"\nkind = \"plane\"\nmaterial = \"glass\"\n"
               "point = [0, 0, 1]\nnormal = [0, 0, -1]\n");
  folder.write("common.toml", program::small_scene);
  const Scene s =
      load_scene(folder.write("scene.toml",
                              "include = [\"common.toml\", \"parts/walls.toml\"]\n[run]\ntime = 1e-3\n"
                              "[world]\ngravity = [1, 0, 0]\n[[body]]\nshape = \"ball\"\nmaterial = \"glass\"\n"
                              "position = [0, 0, 0.1]\n"),
                 {"body[3].scale=2"});
  EXPECT_EQ(s.title, "three bodies");
  EXPECT_EQ(s.gravity, (Vec3d{1, 0, 0}));
  EXPECT_EQ(s.run.time, 1e-3);
  EXPECT_EQ(s.run.steps, 0u);  // time on top takes the place of steps below
  EXPECT_EQ(s.run.dt, 1e-5);
  ASSERT_EQ(s.walls.size(), 2u);  // common.toml is read once
  EXPECT_EQ(s.walls[1].name, "lid");
  EXPECT_EQ(s.walls[1].where.file, folder.path("parts/walls.toml"));
  ASSERT_EQ(s.bodies.size(), 4u);
  EXPECT_EQ(s.bodies[3].scale, 2);
  EXPECT_EQ(s.bodies[3].where.file, folder.path("scene.toml"));

  // The folder of a run holds the whole scene.
  ASSERT_EQ(program::dem({"run", folder.path("scene.toml"), "--out", folder.path("out"), "--quiet"}).exit_code, 0);
  const Scene merged = load_scene(folder.path("out/scene.toml"));
  EXPECT_EQ(merged.walls.size(), 2u);
  EXPECT_FALSE(has(program::read(folder.path("out/scene.toml")), "include"));
}

TEST(Include, AnErrorNamesItsFile) {
  const Folder folder;
  const std::string main = folder.write("scene.toml", "include = [\"part.toml\"]\n");
  folder.write("part.toml", replaced(program::small_scene, "friction = 0.5", "fricton = 0.5"));
  EXPECT_TRUE(has(refusal(main), folder.path("part.toml:17:1: unknown key material.fricton"))) << refusal(main);
  folder.write("part.toml",
               replaced(program::small_scene, "position = [0.001, 0, 0.0155]", "position = [0.001, 0, 0.012]"));
  const Outcome overlap = program::dem({"check", main});  // found after reading, when the world is built
  EXPECT_TRUE(has(overlap.err, folder.path("part.toml:")) && has(overlap.err, "overlaps")) << overlap.err;
  folder.write("part.toml", "[run\n");
  EXPECT_TRUE(has(refusal(main), folder.path("part.toml:1:5: TOML syntax"))) << refusal(main);
  folder.write("part.toml", std::string(program::small_scene) +
                                "[[shape]]\nname = \"rock\"\nkind = \"polyhedron\"\nfile = \"rock.off\"\n");
  EXPECT_TRUE(has(refusal(main), folder.path("part.toml:51:8: shape.file"))) << refusal(main);
}

TEST(Include, FilesOfAPartAreRelativeToIt) {
  const Folder folder;
  std::filesystem::create_directory(folder.path("parts"));
  folder.write("parts/part.toml",
               replaced(program::small_scene, "[[body]]",
                        "[[bodies_csv]]\nfile = \"a.csv\"\nshape = \"ball\"\nmaterial = \"glass\"\n[[body]]"));
  folder.write("parts/a.csv", "x,y,z,radius\n1,1,1,0.01\n");
  const Scene s = load_scene(folder.write("scene.toml", "include = [\"parts/part.toml\"]\n"));
  EXPECT_EQ(s.csv.at(0).file, folder.path("parts/a.csv"));
}

TEST(Include, WhatCannotBeIncludedIsRefused) {
  const Folder folder;
  const std::string main = folder.path("scene.toml");
  const auto said = [&](const char* text) {
    folder.write("scene.toml", text);
    return refusal(main);
  };
  EXPECT_TRUE(
      has(said("include = [\"scene.toml\"]\n"), "scene.toml:1:12: include = \"scene.toml\": the file includes itself"));
  EXPECT_TRUE(has(said("include = [\"none.toml\"]\n"), "no such file"));
  EXPECT_TRUE(has(said("include = \"part.toml\"\n"), "needs a list of text, found text"));
  EXPECT_TRUE(has(said("include = []\n"), "include: is empty"));
  EXPECT_TRUE(has(said("include = [1]\n"), "found a number"));
  EXPECT_TRUE(has(said("include = [\"\"]\n"), "empty name"));
  folder.write("a.toml", "include = [\"b.toml\"]\n");
  folder.write("b.toml", "include = [\"a.toml\"]\n");
  const std::string cycle = said("include = [\"a.toml\"]\n");
  EXPECT_TRUE(has(cycle, folder.path("b.toml:1:12")) && has(cycle, "a.toml -> ")) << cycle;
  const Outcome set =
      program::dem({"check", folder.write("small.toml", program::small_scene), "--set", "include=[\"a.toml\"]"});
  EXPECT_EQ(set.exit_code, 2);
  EXPECT_TRUE(has(set.err, "read before overrides")) << set.err;
}

TEST(Materials, ValuesByName) {
  const Folder folder;
  std::string text =
      replaced(program::small_scene, "young = 1e7\npoisson = 0.25\ndensity = 2500", "like = \"steel\"\nyoung = 1e7");
  text +=
      "[[material]]\nname = \"plate\"\nlike = \"glass\"\n"
      "[[material_pair]]\na = \"glass\"\nb = \"plate\"\npublished = \"steel plate - steel ball\"\n";
  const Scene s = load_scene(folder.write("scene.toml", text));
  EXPECT_EQ(s.materials[0].young, 1e7);  // what the scene says stands
  EXPECT_EQ(s.materials[0].density, 7850);
  EXPECT_EQ(s.materials[0].poisson, 0.30);
  EXPECT_EQ(s.materials[0].source, "poisson, density: Chung and Ooi 2011: impact test 5");
  EXPECT_EQ(s.pairs[0].friction, 0.214);
  EXPECT_EQ(s.pairs[0].source, "steel ball - steel plate: 0.214 (Li 2005)");
  const Scene again = load_scene(folder.write("again.toml", scene_to_toml(s)));
  EXPECT_EQ(scene_to_toml(again), scene_to_toml(s));
  EXPECT_EQ(again.materials[0].source, s.materials[0].source);
  const Scene chosen =
      load_scene(folder.write("chosen.toml", replaced(text, "steel plate - steel ball",
                                                      "cellulose acetate - cellulose acetate (Mullier 1991)")));
  EXPECT_EQ(chosen.pairs[0].friction, 0.22);

  ASSERT_EQ(program::dem({"run", folder.path("scene.toml"), "--out", folder.path("out"), "--quiet"}).exit_code, 0);
  const auto summary = nlohmann::json::parse(program::read(folder.path("out/summary.json")));
  EXPECT_EQ(summary["materials"][0]["source"], s.materials[0].source);
  EXPECT_EQ(summary["published_friction"][0]["source"], s.pairs[0].source);
}

TEST(Materials, TheTablesAreWhole) {
  EXPECT_GE(named_materials().size(), 10u);
  for (const NamedMaterial& m : named_materials()) {
    EXPECT_TRUE(m.young > 1e6 && m.young < 1e12 && m.poisson > 0 && m.poisson <= 0.5) << m.name;
    EXPECT_FALSE(m.source.empty()) << m.name;
  }
  EXPECT_EQ(published_friction().size(), 19u);
  for (const PublishedFriction& f : published_friction()) {
    EXPECT_EQ(find_friction(f.name), std::vector<const PublishedFriction*>{&f}) << f.name;
    EXPECT_FALSE(f.reference.empty()) << f.name;
  }
  EXPECT_EQ(find_friction("cellulose acetate - cellulose acetate").size(), 2u);
}

TEST(New, CopiesASceneThatRunsFromAnywhere) {
  const Folder folder;
  const Outcome o = program::dem({"new", folder.path("mine"), "--from", "bed_spheres"});
  ASSERT_EQ(o.exit_code, 0) << o.err;
  EXPECT_TRUE(has(o.out, "dem run " + folder.path("mine.toml"))) << o.out;
  const std::string text = program::read(folder.path("mine.toml"));
  EXPECT_TRUE(has(text, "# a tenth of a diameter")) << "comments stay";
  EXPECT_NO_THROW(load_scene(folder.path("mine.toml")));  // its CSV file is found
  const Outcome again = program::dem({"new", folder.path("mine.toml")});
  EXPECT_EQ(again.exit_code, 2);
  EXPECT_TRUE(has(again.err, "is there already")) << again.err;
  const Outcome unknown = program::dem({"new", folder.path("x"), "--from", "bed_sphere"});
  EXPECT_EQ(unknown.exit_code, 2);
  EXPECT_TRUE(has(unknown.err, "did you mean bed_spheres?") && has(unknown.err, "two_bodies")) << unknown.err;
  EXPECT_EQ(program::dem({"new", folder.path("none/x")}).exit_code, 2);
  EXPECT_EQ(folder.files(), std::vector<std::string>{"mine.toml"});
}

}  // namespace
