// dem analyse as a user calls it: files, ranges of frames, what it refuses, and output of other codes.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "libdem/analysis/quantities.h"
#include "libdem/io/io.h"
#include "tests/program/program.h"

namespace {

using nlohmann::json;
using program::Folder;
using program::Outcome;

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

// The small scene with a frame each 20 steps: eleven frames.
class Analyse : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = new Folder;
    const std::string scene = folder_->write("scene.toml", program::small_scene);
    const Outcome probe = program::dem({"run", scene, "--out", folder_->path("probe"), "--quiet"});
    ASSERT_EQ(probe.exit_code, 0) << probe.err;
    const json summary = json::parse(program::read(folder_->path("probe/summary.json")));
    const double interval = 20 * summary.at("dt").get<double>();
    ASSERT_EQ(
        program::dem({"run", scene, "--out", run(), "--quiet", "--set", "output.interval=" + std::to_string(interval)})
            .exit_code,
        0);
  }
  static void TearDownTestSuite() { delete folder_; }
  static std::string run() { return folder_->path("run"); }
  static std::string out(const char* name) { return folder_->path(name); }
  static Folder* folder_;
};
Folder* Analyse::folder_ = nullptr;

void expect_refused(const std::vector<std::string>& arguments, const std::string& part) {
  std::vector<std::string> all{"analyse"};
  all.insert(all.end(), arguments.begin(), arguments.end());
  const Outcome o = program::dem(all);
  EXPECT_EQ(o.exit_code, 2) << o.out << o.err;
  EXPECT_TRUE(has(o.err, part)) << o.err;
  EXPECT_EQ(std::count(o.err.begin(), o.err.end(), '\n'), 1) << o.err;
}

TEST_F(Analyse, EveryFrameOfARun) {
  const Outcome o = program::dem({"analyse", run()});
  ASSERT_EQ(o.exit_code, 0) << o.err;
  EXPECT_TRUE(o.err.empty()) << o.err;  // quiet when piped
  EXPECT_TRUE(has(o.out, "11 frames")) << o.out;
  EXPECT_TRUE(has(o.out, "velocity\n") && has(o.out, ", last ")) << o.out;
  const json all = json::parse(program::read(run() + "/analysis/analysis.json"));
  EXPECT_EQ(all.at("frames").size(), 11u);
  for (const dem::analysis::Quantity& q : dem::analysis::quantities())
    EXPECT_EQ(all.at("quantities").contains(q.name), !q.costly) << q.name;
  const dem::io::Table series = dem::io::read_csv(run() + "/analysis/velocity_series.csv");
  EXPECT_EQ(series.row_count(), 11u);
  EXPECT_EQ(dem::io::number(series, 10, dem::io::column(series, "step")), 200);
  // Again, into the folder of the first: the same, nothing else.
  const std::string first = program::read(run() + "/analysis/stress_series.csv");
  ASSERT_EQ(program::dem({"analyse", run(), "--threads", "1"}).exit_code, 0);
  EXPECT_EQ(program::read(run() + "/analysis/stress_series.csv"), first);
  // And of its record, named itself.
  ASSERT_EQ(program::dem({"analyse", run() + "/record.h5", "--out", out("of_record")}).exit_code, 0);
  EXPECT_EQ(program::read(out("of_record") + "/stress_series.csv"), first);
}

TEST_F(Analyse, SomeFramesAndQuantities) {
  const Outcome o = program::dem({"analyse", run(), "--frames", "2:-1:4", "--what", "energy,stress", "--out",
                                  out("some"), "--boxes", "1,2,3", "--region", "-1,-1,0,1,1,2", "--quiet"});
  ASSERT_EQ(o.exit_code, 0) << o.err;
  const json all = json::parse(program::read(out("some") + "/analysis.json"));
  EXPECT_EQ(all.at("quantities").size(), 2u);
  EXPECT_EQ(all.at("frames")[1].at("frame"), 6);
  EXPECT_EQ(all.at("frames").size(), 2u);
  EXPECT_EQ(dem::io::read_csv(out("some") + "/stress_boxes_000000000120.csv").row_count(), 6u);
  EXPECT_EQ(std::count(o.out.begin(), o.out.end(), '\n'), 1) << o.out;
  const Outcome one = program::dem({"analyse", run(), "--frames", "-1", "--what", "stress", "--out", out("one")});
  ASSERT_EQ(one.exit_code, 0) << one.err;
  EXPECT_TRUE(std::filesystem::exists(out("one") + "/stress_boxes.csv"));
}

TEST_F(Analyse, Refuses) {
  expect_refused({run(), "--frames", "99"}, "frames 0 to 10");
  expect_refused({run(), "--frames", "5:2"}, "no frame is left");
  expect_refused({run(), "--what", "stres"}, "did you mean stress?");
  expect_refused({run(), "--reference", "11"}, "frames 0 to 10");
  expect_refused({run(), "--region", "0,0,0,1,1"}, "allowed six, or four in the plane");
  expect_refused({run(), "--region", "0,0,1,1"}, "allowed 6 in space");
  expect_refused({run(), "--region", "0,0,1,1,1,0"}, "lower < upper");
  expect_refused({run(), "--out", run()}, "holds no analysis");
  expect_refused({folder_->path("nowhere")}, "no such folder or file");
  expect_refused({folder_->path("")}, "no record");
  expect_refused({folder_->write("words.txt", "words\n")}, "not known; allowed");
}

TEST_F(Analyse, DamagedRecords) {
  namespace fs = std::filesystem;
  const std::string broken = out("broken");
  fs::create_directory(broken);
  fs::copy_file(run() + "/scene.toml", broken + "/scene.toml");
  fs::copy_file(run() + "/record.h5", broken + "/record.h5");
  fs::resize_file(broken + "/record.h5", fs::file_size(broken + "/record.h5") / 2);
  expect_refused({broken}, "record");
  EXPECT_FALSE(fs::exists(broken + "/analysis"));
  std::ofstream(broken + "/record.h5") << "no record";
  expect_refused({broken}, "cannot open the record");
  fs::remove(broken + "/record.h5");
  expect_refused({broken}, "kept no record");
  // Of another scene.
  fs::copy_file(run() + "/record.h5", broken + "/record.h5", fs::copy_options::overwrite_existing);
  std::ofstream(broken + "/scene.toml", std::ios::app)
      << "\n[[wall]]\nname = \"lid\"\nkind = \"plane\"\nmaterial = \"glass\"\npoint = [0, 0, 9]\nnormal = [0, 0, -1]\n";
  expect_refused({broken}, "does not belong to this scene");
}

TEST_F(Analyse, LastStateOfARunWithoutRecord) {
  const std::string folder = out("unrecorded"), scene = folder_->path("scene.toml");
  ASSERT_EQ(program::dem({"run", scene, "--out", folder, "--quiet", "--set", "output.hdf5=false"}).exit_code, 0);
  const Outcome o = program::dem({"analyse", folder, "--quiet"});
  ASSERT_EQ(o.exit_code, 0) << o.err;
  const json all = json::parse(program::read(folder + "/analysis/analysis.json"));
  EXPECT_EQ(all.at("frames")[0].at("step"), 200);
  EXPECT_TRUE(has(all.at("notes").dump(), "kept no record"));
}

TEST_F(Analyse, OfAnotherCodeAndOfNothing) {
  const std::string head = "ITEM: TIMESTEP\n100\nITEM: NUMBER OF ATOMS\n",
                    box = "ITEM: BOX BOUNDS pp pp pp\n0 4\n0 4\n0 4\n";
  const std::string dump = folder_->write(
      "three.dump", head + "3\n" + box +
                        "ITEM: ATOMS id type x y z vx vy vz radius\n1 1 0.5 1 1 1 0 0 0.5\n2 1 1.5 1 1 0 "
                        "0 0 0.5\n3 2 3.5 1 1 -1 0 0 0.5\n");
  const Outcome o = program::dem({"analyse", dump, "--time-step", "1e-3", "--density", "2000"});
  ASSERT_EQ(o.exit_code, 0) << o.err;
  const json all = json::parse(program::read(folder_->path("three_analysis/analysis.json")));
  EXPECT_EQ(all.at("frames")[0].at("bodies"), 3);
  EXPECT_EQ(all.at("frames")[0].at("contacts"), 2);  // one across the face
  EXPECT_DOUBLE_EQ(all.at("frames")[0].at("time").get<double>(), 0.1);
  EXPECT_TRUE(has(all.at("quantities").at("stress").at("notes").dump(), "no forces"));

  // Nothing: each quantity says so, and gives no number that is none.
  const std::string empty =
      folder_->write("empty.dump", head + "0\n" + box + "ITEM: ATOMS id type x y z vx vy vz radius\n");
  const Outcome none = program::dem({"analyse", empty, "--what", "all"});
  ASSERT_EQ(none.exit_code, 0) << none.err;
  const std::string text = program::read(folder_->path("empty_analysis/analysis.json"));
  EXPECT_FALSE(has(text, "not finite")) << text;
  const json quantities = json::parse(text).at("quantities");
  for (const auto& [name, q] : quantities.items()) EXPECT_FALSE(q.at("notes").empty()) << name;

  // One body, free in space.
  const std::string one = folder_->write("one.csv", "x,y,z,radius,vx,vy,vz,mass\n1,2,3,0.5,1,0,0,2\n");
  ASSERT_EQ(program::dem({"analyse", one, "--what", "all", "--out", out("lone")}).exit_code, 0);
  EXPECT_FALSE(has(program::read(out("lone") + "/analysis.json"), "not finite"));
}

TEST(AnalyseInRun, RowsInTheFolderOfTheRun) {
  const Folder folder;
  const std::string text =
      std::string(program::small_scene) +
      "\n[analysis]\nwhat = [\"energy\", \"stress\"]\nboxes = [1, 1, 4]\nregion_upper = [1, 1, 1]\n";
  const std::string scene = folder.write("scene.toml", text), out = folder.path("out");
  const Outcome o = program::dem({"run", scene, "--out", out, "--quiet"});
  ASSERT_EQ(o.exit_code, 0) << o.err;
  EXPECT_EQ(dem::io::read_csv(out + "/analysis_energy.csv").row_count(), 2u);  // with the frames: first and last
  EXPECT_TRUE(std::filesystem::exists(out + "/analysis_stress.csv"));
  EXPECT_TRUE(has(program::read(out + "/scene.toml"), "[analysis]\nwhat = [\"energy\", \"stress\"]"));
  const Outcome check = program::dem({"check", scene});
  EXPECT_TRUE(has(check.out, "with the frames: energy, stress")) << check.out;
  // Replaced with the run, and gone with its reason.
  ASSERT_EQ(program::dem({"run", folder.write("plain.toml", program::small_scene), "--out", out, "--force", "--quiet"})
                .exit_code,
            0);
  EXPECT_FALSE(std::filesystem::exists(out + "/analysis_energy.csv"));
  EXPECT_FALSE(has(program::read(out + "/scene.toml"), "[analysis]"));

  const auto refused = [&](const std::string& from, const std::string& to, const std::string& part) {
    const Outcome bad = program::dem({"check", folder.write("bad.toml", program::replaced(text, from, to))});
    EXPECT_EQ(bad.exit_code, 2);
    EXPECT_TRUE(has(bad.err, part)) << bad.err;
  };
  refused("\"stress\"]", "\"stres\"]", "did you mean stress?");
  refused("[1, 1, 4]", "[1, 1, 4.5]", "whole numbers");
  refused("[1, 1, 4]", "[1, 1, -4]", "analysis.boxes");
  refused("region_upper = [1, 1, 1]", "region_upper = [1, 1, -1]", "region_upper > region_lower in z");
  refused("boxes =", "split = \"colour\"\nboxes =", "species, size, shape, material");
}

TEST(AnalyseList, QuantitiesAreListed) {
  const Outcome o = program::dem({"list", "quantities", "--json"});
  ASSERT_EQ(o.exit_code, 0);
  const json list = json::parse(o.out).at("quantities");
  ASSERT_EQ(list.size(), dem::analysis::quantities().size());
  std::set<std::string> names;
  for (const json& q : list) {
    EXPECT_TRUE(names.insert(q.at("name")).second) << q;
    EXPECT_FALSE(q.at("what").get<std::string>().empty());
  }
}

}  // namespace
