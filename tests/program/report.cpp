// dem report as a user calls it: the page, what it says of what is missing, what it refuses.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "libdem/io/programs.h"
#include "libdem/render/render.h"
#include "libdem/report/three.h"
#include "tests/program/page.h"
#include "tests/program/program.h"

namespace {

using program::Folder;
using program::Outcome;

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

// A variable of the environment for a while.
class Variable {
 public:
  Variable(const char* name, const std::string& value) : name_(name) {
    if (const char* was = std::getenv(name)) was_ = was;
    setenv(name, value.c_str(), 1);
  }
  Variable(const Variable&) = delete;
  Variable& operator=(const Variable&) = delete;
  ~Variable() {
    if (was_.empty())
      unsetenv(name_);
    else
      setenv(name_, was_.c_str(), 1);
  }

 private:
  const char* name_;
  std::string was_;
};

class Report : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = new Folder;
    const std::string scene = folder_->write(
        "scene.toml", program::replaced(program::small_scene, "three bodies", "three <bodies> & a floor"));
    ASSERT_EQ(program::dem({"run", scene, "--out", run(), "--quiet"}).exit_code, 0);
    const nlohmann::json summary = nlohmann::json::parse(program::read(run() + "/summary.json"));
    const std::string interval = std::to_string(20 * summary.at("dt").get<double>());
    const Outcome o =
        program::dem({"run", scene, "--out", run(), "--force", "--quiet", "--set", "output.interval=" + interval});
    ASSERT_EQ(o.exit_code, 0) << o.err;
  }
  static void TearDownTestSuite() { delete folder_; }
  static std::string run() { return folder_->path("run"); }
  static Folder* folder_;
};
Folder* Report::folder_ = nullptr;

void expect_refused(const std::vector<std::string>& arguments, const std::string& part, int code = 2) {
  std::vector<std::string> all{"report"};
  all.insert(all.end(), arguments.begin(), arguments.end());
  const Outcome o = program::dem(all);
  EXPECT_EQ(o.exit_code, code) << o.out << o.err;
  EXPECT_TRUE(has(o.err, part)) << o.err;
  EXPECT_EQ(std::count(o.err.begin(), o.err.end(), '\n'), 1) << o.err;
}

nlohmann::json data_of(const std::string& page) {
  const std::string open = "<script type=\"application/json\" id=\"data\">";
  const std::size_t begin = page.find(open) + open.size();
  return nlohmann::json::parse(page.substr(begin, page.find("</script>", begin) - begin));
}

TEST_F(Report, OnePageOfARun) {
  const Outcome o = program::dem({"report", run()});
  ASSERT_EQ(o.exit_code, 0) << o.err;
  EXPECT_TRUE(has(o.out, "report.html: ") && has(o.out, "3 bodies")) << o.out;
  const std::string page = program::read(run() + "/report.html"), own = program::without_libraries(page);
  EXPECT_EQ(program::fault_of_markup(own), "");
  EXPECT_FALSE(has(own, "http")) << own.substr(own.find("http") - 80, 160);
  EXPECT_FALSE(has(own, "src=\"") && !has(own, "src=\"data:image/png;base64,"));
  EXPECT_EQ(program::body_attribute(page, "data-bodies"), "3");
  EXPECT_TRUE(has(own, "<h1>three &lt;bodies&gt; &amp; a floor</h1>"));
  for (const char* part : {"<td>gravity</td>", "<td>rolling</td>", "off: no law named", "contact steps", "state hash",
                           "<summary>velocity</summary>", "<td>mean_speed</td><td>m/s</td>", "[[wall]]"})
    EXPECT_TRUE(has(own, part)) << part;
  const std::size_t figures = program::occurrences(own, "<figure id=");
  EXPECT_EQ(std::to_string(figures), program::body_attribute(page, "data-figures"));
  EXPECT_EQ(figures, program::occurrences(own, "<svg "));
  EXPECT_TRUE(std::filesystem::exists(run() + "/report_figures/rdf.gp"));
  EXPECT_EQ(std::filesystem::exists(run() + "/report_figures/rdf.svg"), dem::io::installed("gnuplot"));
  if (dem::io::installed("gnuplot")) {
    EXPECT_TRUE(o.err.empty() || !has(o.err, "gnuplot says")) << o.err;
    for (const char* name :
         {"series_velocity_mean_speed", "rdf", "density_envelope", "porosity_z", "coordination_distribution"})
      EXPECT_TRUE(has(own, std::string("figure-") + name)) << name;
  }
  // Again: the analysis stands, and the page has the same bytes.
  ASSERT_EQ(program::dem({"report", run()}).exit_code, 0);
  EXPECT_EQ(program::read(run() + "/report.html"), page);
}

TEST_F(Report, ANewRunTakesThePlaceOfPageFiguresAndAnalysis) {
  const std::string scene = folder_->path("scene.toml"), again = folder_->path("again");
  ASSERT_EQ(program::dem({"run", scene, "--out", again, "--quiet"}).exit_code, 0);
  ASSERT_EQ(program::dem({"report", again, "--what", "energy,velocity", "--quiet"}).exit_code, 0);
  const auto there = [&](const char* name) { return std::filesystem::exists(again + "/" + name); };
  EXPECT_TRUE(there("report.html") && there("analysis/energy_series.csv") && there("report_figures"));
  folder_->write("again/analysis/notes.txt", "the user's own");
  folder_->write("again/report_figures/mine.gp", "plot sin(x)\n");
  ASSERT_EQ(program::dem({"run", scene, "--out", again, "--quiet", "--force"}).exit_code, 0);
  EXPECT_FALSE(there("report.html"));
  std::vector<std::string> left;
  for (const char* name : {"/analysis", "/report_figures"})
    for (const auto& entry : std::filesystem::directory_iterator(again + name))
      left.push_back(entry.path().filename().string());
  EXPECT_EQ(left, (std::vector<std::string>{"notes.txt", "mine.gp"}));
  for (const char* name : {"/analysis/notes.txt", "/report_figures/mine.gp"}) std::filesystem::remove(again + name);
  std::filesystem::remove(again + "/analysis");
  std::filesystem::remove(again + "/report_figures");
  ASSERT_EQ(program::dem({"report", again, "--what", "energy", "--quiet"}).exit_code, 0);
  ASSERT_EQ(program::dem({"run", scene, "--out", again, "--quiet", "--force"}).exit_code, 0);
  EXPECT_FALSE(there("analysis") || there("report_figures"));
}

TEST_F(Report, WhatTheViewReads) {
  if (!dem::report::find_three().why.empty()) GTEST_SKIP() << dem::report::find_three().why;
  const std::string out = folder_->path("view.html");
  ASSERT_EQ(program::dem({"report", run(), "--out", out, "--what", "velocity"}).exit_code, 0);
  const nlohmann::json data = data_of(program::read(out));
  EXPECT_EQ(data.at("bodies").at("id").size(), 3u);
  EXPECT_GT(data.at("frames").size(), 2u);
  EXPECT_EQ(data.at("frames").back().at("step"), 200);
  EXPECT_EQ(data.at("frames")[0].at("walls").size(), data.at("walls").size());
  EXPECT_GE(data.at("walls").size(), 1u);
  EXPECT_FALSE(data.at("walls")[0].is_null());
  for (const char* name : {"speed", "force", "displacement", "strain", "vorticity"})
    EXPECT_TRUE(data.at("scales").contains(name)) << name;
  ASSERT_EQ(data.at("bands").size(), 3u);
  EXPECT_EQ(data.at("bands")[0].at("name"), "layers");
  EXPECT_EQ(data.at("bands")[0].at("names").size(), 8u);
  EXPECT_GT(data.at("scales").at("speed").at("largest"), 0);
  // Fewer bodies: every second one, and the page says so.
  const Outcome some = program::dem({"report", run(), "--out", out, "--bodies", "2"});
  ASSERT_EQ(some.exit_code, 0);
  EXPECT_TRUE(has(some.err, "one in 2 of the bodies")) << some.err;
  const std::string page = program::read(out);
  EXPECT_EQ(data_of(page).at("bodies").at("id"), (std::vector<int>{0, 2}));
  EXPECT_EQ(data_of(page).at("frames")[0].at("bodies"), 3);
  EXPECT_TRUE(has(page, "one in 2 of the bodies"));
}

TEST_F(Report, AnalysisOfTheUserStands) {
  const std::string folder = run() + "/analysis", out = folder_->path("stands.html");
  ASSERT_EQ(program::dem({"analyse", run(), "--what", "energy", "--frames", "0:2", "--quiet"}).exit_code, 0);
  ASSERT_EQ(program::dem({"report", run(), "--out", out}).exit_code, 0);
  std::string page = program::read(out);
  EXPECT_EQ(program::body_attribute(page, "data-frames"), "2");
  EXPECT_TRUE(has(page, "<summary>energy</summary>") && !has(page, "<summary>velocity</summary>"));
  ASSERT_EQ(program::dem({"report", run(), "--out", out, "--what", "velocity", "--frames", "-1"}).exit_code, 0);
  page = program::read(out);
  EXPECT_EQ(program::body_attribute(page, "data-frames"), "1");
  EXPECT_TRUE(has(page, "<summary>velocity</summary>") && !has(page, "<summary>energy</summary>"));
  // Other options of the analysis make it anew as well.
  ASSERT_EQ(program::dem({"report", run(), "--out", out, "--split", "layers", "--reference", "-1"}).exit_code, 0);
  page = program::read(out);
  EXPECT_TRUE(has(page, "groups by layers") && has(page, "<summary>energy</summary>"));
  // One that was broken off is made anew.
  folder_->write("run/analysis/analysis.json", "{\"complete\": false}\n");
  ASSERT_EQ(program::dem({"report", run(), "--out", out}).exit_code, 0);
  EXPECT_TRUE(has(program::read(out), "<summary>stress</summary>"));
}

TEST_F(Report, WithoutGnuplotAndThree) {
  const Variable three("DEM_THREE", folder_->path()), path("PATH", folder_->path());
  const std::string out = folder_->path("bare.html");
  const Outcome o = program::dem({"report", run(), "--out", out});
  ASSERT_EQ(o.exit_code, 0) << o.err;
  const std::string page = program::read(out);
  EXPECT_EQ(program::fault_of_markup(page), "");
  EXPECT_FALSE(has(page, "http"));
  for (const char* part : {"gnuplot is not installed (package gnuplot-nox)", "libjs-three is not installed"}) {
    EXPECT_TRUE(has(o.err, part)) << o.err;
    EXPECT_TRUE(has(page, part)) << part;
  }
  EXPECT_EQ(program::body_attribute(page, "data-figures"), "0");
  EXPECT_EQ(program::body_attribute(page, "data-view"), "still");
  EXPECT_EQ(has(page, "data:image/png;base64,"), dem::render::available());
  EXPECT_FALSE(has(page, "<script"));
}

TEST_F(Report, OutputOfAnotherCode) {
  const std::string dump =
      folder_->write("two.dump",
                     "ITEM: TIMESTEP\n100\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS pp pp pp\n0 4\n0 4\n0 4\n"
                     "ITEM: ATOMS id type x y z radius\n1 1 0.5 1 1 0.5\n2 1 1.5 1 1 0.5\n");
  const Outcome o = program::dem({"report", dump, "--quiet"});
  ASSERT_EQ(o.exit_code, 0) << o.err;
  const std::string page = program::read(folder_->path("two_report.html"));
  EXPECT_EQ(program::body_attribute(page, "data-bodies"), "2");
  EXPECT_EQ(program::fault_of_markup(program::without_libraries(page)), "");
  EXPECT_TRUE(has(page, "output of another code"));
  if (!dem::report::find_three().why.empty()) return;
  const nlohmann::json data = data_of(page);
  EXPECT_FALSE(data.at("scales").contains("speed"));  // the dump has no velocities
  EXPECT_FALSE(data.at("scales").contains("force"));
  EXPECT_EQ(data.at("frames")[0].at("cell").size(), 2u);
}

TEST_F(Report, Refuses) {
  expect_refused({folder_->path("nowhere")}, "no such folder or file");
  expect_refused({folder_->path("")}, "kept no record");
  expect_refused({run(), "--out", folder_->path("page.txt")}, "ends in .html");
  expect_refused({run(), "--out", folder_->path("none/page.html")}, "there is no folder");
  expect_refused({run(), "--what", "stres"}, "did you mean stress?");
  expect_refused({run(), "--frames", "999"}, "has frames 0 to");
  expect_refused({run(), "--reference", "999"}, "has frames 0 to");
  expect_refused({run(), "--boxes", "3"}, "--boxes: 1 number; allowed two or three");
  EXPECT_EQ(program::dem({"report", run(), "--bodies", "0"}).exit_code, 2);
}

}  // namespace
