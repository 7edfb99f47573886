// What the commands print and write, and what they refuse.
#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>

#include "libcontact/dispatch.h"
#include "libcontact/laws/list.h"
#include "tests/program/program.h"

namespace {

using nlohmann::json;
using program::Folder;
using program::Outcome;

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(Run, WritesItsFilesAndRefusesToReplaceThem) {
  const Folder folder;
  const std::string scene = folder.write("scene.toml", program::small_scene), out = folder.path("out");
  const Outcome first = program::dem({"run", scene, "--out", out, "--threads", "1"});
  ASSERT_EQ(first.exit_code, 0) << first.err;
  EXPECT_TRUE(has(first.err, "100.0 %")) << first.err;
  for (const char* name : {"scene.toml", "frames.pvd", "record.h5", "final.csv", "summary.json"})
    EXPECT_TRUE(std::filesystem::exists(out + "/" + name)) << name;
  const json summary = json::parse(program::read(out + "/summary.json"));
  EXPECT_EQ(summary["steps"], 200);
  EXPECT_EQ(summary["end"], "finished");
  const std::string state = program::read(out + "/final.csv");

  const Outcome again = program::dem({"run", scene, "--out", out});
  EXPECT_EQ(again.exit_code, 2);
  EXPECT_TRUE(has(again.err, "holds a run") && has(again.err, "--force")) << again.err;
  EXPECT_EQ(program::read(out + "/final.csv"), state);

  // --force replaces what a run writes and nothing else.
  folder.write("out/notes.txt", "mine");
  const Outcome forced =
      program::dem({"run", scene, "--out", out, "--force", "--quiet", "--threads", "1", "--set", "run.steps=100"});
  EXPECT_EQ(forced.exit_code, 0) << forced.err;
  EXPECT_TRUE(forced.err.empty()) << forced.err;
  EXPECT_EQ(program::read(out + "/notes.txt"), "mine");
  EXPECT_NE(program::read(out + "/final.csv"), state);
  EXPECT_FALSE(has(program::read(out + "/frames.pvd"), "000200.vtp"));

  const Outcome own = program::dem({"run", scene, "--out", folder.path(), "--force"});
  EXPECT_EQ(own.exit_code, 2);
  EXPECT_TRUE(has(own.err, "replace its own scene")) << own.err;
  EXPECT_EQ(program::read(scene), program::small_scene);
  std::filesystem::create_directory(folder.path("foreign"));
  folder.write("foreign/notes.txt", "mine");
  const Outcome foreign = program::dem({"run", scene, "--out", folder.path("foreign")});
  EXPECT_EQ(foreign.exit_code, 2);
  EXPECT_TRUE(has(foreign.err, "is not empty")) << foreign.err;
}

TEST(Run, TheResolvedSceneRunsToTheSameState) {
  const Folder folder;
  const std::string scene = folder.write("scene.toml", program::small_scene);
  ASSERT_EQ(program::dem({"run", scene, "--out", folder.path("a"), "--set", "run.steps=150"}).exit_code, 0);
  ASSERT_EQ(program::dem({"run", folder.path("a/scene.toml"), "--out", folder.path("b")}).exit_code, 0);
  EXPECT_EQ(program::read(folder.path("a/final.csv")), program::read(folder.path("b/final.csv")));
  EXPECT_EQ(program::read(folder.path("a/scene.toml")), program::read(folder.path("b/scene.toml")));
}

TEST(Check, SaysWhatTheSceneIs) {
  const Folder folder;
  const Outcome o = program::dem({"check", folder.write("scene.toml", program::small_scene), "--set", "run.dt=auto"});
  ASSERT_EQ(o.exit_code, 0) << o.err;
  for (const char* part : {"bodies: 3", "ball", "egg", "floor", "dt ", "auto", "limit", "200 to t =", "hertz_mindlin",
                           "off: no [[outlet]]", "collision at", "egg on wall floor", "Rayleigh", "impact",
                           "weight of the bed", "rebuild of the list", "memory", "disk"})
    EXPECT_TRUE(has(o.out, part)) << part << "\nnot in\n" << o.out;
  EXPECT_EQ(folder.files(), std::vector<std::string>{"scene.toml"});
}

TEST(Check, TakesTheExtremesOfALawAndSaysHowContactsEnd) {
  const Folder folder;
  const std::string scene = folder.write("scene.toml", program::small_scene);
  const Outcome clipped = program::dem({"check", scene, "--set", "material.glass.restitution=0.01"});
  EXPECT_EQ(clipped.exit_code, 0) << clipped.err;
  EXPECT_TRUE(has(clipped.out, "contacts end at zero force")) << clipped.out;
  const Outcome pulls = program::dem({"check", scene, "--set", "law.clip=false", "--set",
                                      "material.glass.restitution=0", "--set", "material.glass.friction=inf"});
  EXPECT_EQ(pulls.exit_code, 0) << pulls.err;
  EXPECT_TRUE(has(pulls.out, "contacts end at zero overlap") && has(pulls.out, "friction inf")) << pulls.out;
  EXPECT_FALSE(has(pulls.out, "angle in degrees")) << pulls.out;
}

TEST(Check, JsonHoldsTheCost) {
  const Folder folder;
  const Outcome o = program::dem({"check", folder.write("scene.toml", program::small_scene), "--json"});
  ASSERT_EQ(o.exit_code, 0) << o.err;
  const json cost = json::parse(o.out);
  EXPECT_EQ(cost["bodies"], 3);
  EXPECT_EQ(cost["steps"], 200);
  EXPECT_GT(cost["seconds"].get<double>(), 0);
  EXPECT_GT(cost["bytes"].get<double>(), 1e6);
  EXPECT_TRUE(cost["warnings"].is_array());
}

TEST(Check, WarnsOfAStepBeyondTheLimit) {
  const Folder folder;
  const Outcome o = program::dem({"check", folder.write("scene.toml", program::small_scene), "--set", "run.dt=1.5e-4"});
  EXPECT_TRUE(has(o.out, "of the stability limit")) << o.out << o.err;
}

TEST(Check, HintsAtWrongUnitsAndNamesSources) {
  const Folder folder;
  const std::string scene = folder.write("scene.toml", program::small_scene);
  EXPECT_TRUE(has(program::dem({"check", scene}).out, "warnings: none"));
  const auto said = [&](const char* set) {
    return program::dem({"check", scene, "--set", "run.dt=auto", "--set", set}).out;
  };
  EXPECT_TRUE(has(said("material.glass.young=70"), "is it in GPa or MPa?"));
  EXPECT_TRUE(has(said("material.glass.density=2.5"), "is it in g/cm^3?"));
  EXPECT_TRUE(has(said("world.gravity=[0,0,-9810]"), "the Earth's is 9.81"));
  EXPECT_TRUE(has(said("material.glass.like=steel"), "warnings: none"));
  const Outcome named = program::dem(
      {"check",
       folder.write("named.toml", program::replaced(program::small_scene, "poisson = 0.25", "like = \"steel\""))});
  EXPECT_TRUE(has(named.out, "like steel: poisson: Chung and Ooi 2011")) << named.out << named.err;
}

TEST(List, JsonHasEveryList) {
  const Outcome o = program::dem({"list", "--json"});
  ASSERT_EQ(o.exit_code, 0);
  const json all = json::parse(o.out);
  EXPECT_EQ(all["shapes"].size(), shapes::kind_count);
  EXPECT_EQ(all["methods"].size(), static_cast<std::size_t>(contact::methods_end() - contact::methods_begin()));
  EXPECT_EQ(all["pairs"].size(), shapes::kind_count * (shapes::kind_count + 1) / 2);
  EXPECT_EQ(all["laws"].size(), std::size(contact::named_laws) + std::tuple_size_v<contact::NormalLaws> +
                                    std::tuple_size_v<contact::TangentialLaws> +
                                    std::tuple_size_v<contact::RollingLaws> + std::tuple_size_v<contact::CohesionLaws>);
  // The scene format knows the same laws as the list of laws.
  for (const auto& law : all["laws"]) {
    const std::string family = law["family"];
    const Outcome keyword = program::dem({"explain", "law." + (family == "combination" ? "name" : family)});
    EXPECT_NE(keyword.out.find(law["name"].get<std::string>()), std::string::npos) << keyword.out;
  }
  EXPECT_EQ(all["grains"].size(), 120u + 120u + 13u + 1u);  // and one table of measures
  EXPECT_GT(all["keys"].size(), 80u);
  // Every pair of one dimension has a method, but for two walls and for kinds that nothing answers yet.
  std::map<std::string, shapes::Kind> kind;
  for (std::size_t i = 0; i < shapes::kind_count; ++i)
    kind[shapes::name_of(static_cast<shapes::Kind>(i))] = static_cast<shapes::Kind>(i);
  const auto answered = [](shapes::Kind k) {
    return std::any_of(contact::methods_begin(), contact::methods_end(),
                       [&](const contact::MethodInfo& m) { return m.a == k || m.b == k; });
  };
  for (const json& pair : all["pairs"]) {
    const shapes::Kind a = kind.at(pair["a"]), b = kind.at(pair["b"]);
    if (!answered(a) || !answered(b)) continue;
    const bool never = (shapes::is_wall(a) && shapes::is_wall(b)) || shapes::dimension_of(a) != shapes::dimension_of(b);
    EXPECT_EQ(pair["methods"].empty(), never) << pair["a"] << " " << pair["b"];
  }
}

TEST(List, EachTopicPrints) {
  for (const char* topic : {"shapes", "methods", "laws", "maps", "pairs", "keys", "materials", "friction", "scenes",
                            "grains", "quantities"}) {
    const Outcome o = program::dem({"list", topic});
    EXPECT_EQ(o.exit_code, 0) << topic;
    EXPECT_GT(std::count(o.out.begin(), o.out.end(), '\n'), 1) << topic;
  }
}

TEST(Explain, PrintsTheEntry) {
  const Outcome o = program::dem({"explain", "run.dt_fraction"});
  EXPECT_EQ(o.exit_code, 0);
  EXPECT_TRUE(has(o.out, "0 < dt_fraction <= 0.5") && has(o.out, "default  0.1")) << o.out;
  EXPECT_TRUE(has(program::dem({"explain", "wall"}).out, "remove_at [s]"));
  const Outcome entry = program::dem({"explain", "material.glass.young"});
  EXPECT_EQ(entry.out, program::dem({"explain", "material[0].young"}).out);
  EXPECT_TRUE(has(entry.out, "--set material.NAME.young=")) << entry.out;
  EXPECT_TRUE(has(program::dem({"explain", "fill[0].items[1].scale"}).out, "--set fill[0].items[0].scale="));
}

TEST(Help, EveryCommandHasExamples) {
  for (const char* command :
       {"run", "resume", "check", "list", "contact", "render", "analyse", "explain", "validate", "new", "schema"}) {
    const Outcome o = program::dem({command, "--help"});
    EXPECT_EQ(o.exit_code, 0) << command;
    EXPECT_TRUE(has(o.out, std::string("dem ") + command)) << o.out;
    EXPECT_TRUE(has(o.out, "Examples:")) << o.out;
  }
  EXPECT_EQ(program::dem({"--version"}).exit_code, 0);
}

}  // namespace
