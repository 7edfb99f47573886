// Files of an analysis: units first, read back, whole, and only ever its own are replaced.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>

#include "libdem/analysis/write.h"
#include "libdem/io/io.h"
#include "tests/libdem/io_world.h"

namespace {

using namespace dem;
using namespace dem::analysis;
using io_test::Folder;
using nlohmann::json;

std::string read(const std::string& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}
std::size_t files(const Folder& folder) {
  const std::filesystem::directory_iterator all(folder.path());
  return static_cast<std::size_t>(std::distance(begin(all), end(all)));
}

Result nothing(const Snapshot&, const Settings&) { return {}; }
const analysis::Quantity heat{"heat", "what it is", "(1)", false, false, nothing};

Snapshot at(std::uint64_t step, double time) {
  Snapshot s;
  s.step = step;
  s.time = time;
  s.notes = {"of the source"};
  return s;
}
Result result(double value, double third) {
  Result r;
  r.add("flow", "W", value);
  r.scalars.push_back({"level", "K", 2 * value, 0.5});
  if (value > 1) r.add("late", "1", 7);
  r.tables.push_back({"profile", "along the way", {{"x", "m", {1, 2, 3}}, {"t", "K", {0.1, 1.0 / 3, third}}}});
  r.notes.emplace_back(value > 1 ? "late" : "early");
  return r;
}

TEST(AnalysisWrite, SeveralFrames) {
  const Folder folder("analysis_write");
  Writer writer(folder.path(), "somewhere", {&heat}, false);
  for (std::uint64_t f = 0; f < 3; ++f) {
    writer.begin_frame(10 + f, at(100 * f, 0.1 * static_cast<double>(f)));
    writer.add(heat, result(static_cast<double>(f), f == 2 ? std::numeric_limits<double>::quiet_NaN() : 4));
  }
  writer.add_of_all(heat, {"whole", "of all frames", {{"age", "s", {1.5, 2}}}});
  writer.finish();
  EXPECT_EQ(io::number(io::read_csv(folder / "heat_whole.csv"), 0, 0), 1.5);
  const io::Table series = io::read_csv(folder / "heat_series.csv");
  EXPECT_EQ(series.columns, (std::vector<std::string>{"time", "step", "flow", "level", "level_error", "late"}));
  ASSERT_EQ(series.row_count(), 3u);
  EXPECT_EQ(io::number(series, 1, 0), 0.1);
  EXPECT_EQ(io::number(series, 2, 3), 4);
  EXPECT_EQ(io::number(series, 2, 4), 0.5);
  EXPECT_EQ(series.cell(1, 5), "");
  EXPECT_EQ(series.cell(2, 5), "7");
  EXPECT_TRUE(read(folder / "heat_series.csv").starts_with("# units: time s, step 1, flow W, level K, level_error K,"));
  const io::Table profile = io::read_csv(folder / "heat_profile_000000000100.csv");
  EXPECT_EQ(io::number(profile, 1, 1), 1.0 / 3);
  EXPECT_EQ(io::read_csv(folder / "heat_profile_000000000200.csv").cell(2, 1), "");

  const json all = json::parse(read(folder / "analysis.json"));
  EXPECT_EQ(all.at("units").at("heat.flow"), "W");
  EXPECT_TRUE(read(folder / "analysis.json").starts_with("{\n \"units\""));
  EXPECT_EQ(all.at("complete"), true);
  EXPECT_EQ(all.at("frames").size(), 3u);
  EXPECT_EQ(all.at("frames")[2].at("frame"), 12);
  EXPECT_EQ(all.at("notes"), json{"of the source"});
  const json& heat_json = all.at("quantities").at("heat");
  EXPECT_EQ(heat_json.at("scalars").at("flow").at("values"), (json{0.0, 1.0, 2.0}));
  EXPECT_EQ(heat_json.at("scalars").at("flow").at("mean"), 1.0);
  EXPECT_EQ(heat_json.at("scalars").at("flow").at("steady"), nullptr);  // too short to say
  EXPECT_EQ(heat_json.at("scalars").at("late").at("values"), (json{nullptr, nullptr, 7.0}));
  EXPECT_EQ(heat_json.at("tables")[0].at("files").size(), 3u);
  EXPECT_EQ(heat_json.at("tables")[0].at("columns")[1].at("unit"), "K");
  std::map<std::string, json> notes;
  for (const json& n : heat_json.at("notes")) notes[n.at("text")] = n;
  EXPECT_EQ(notes.at("early").at("frames"), 2);
  EXPECT_EQ(notes.at("late").at("first_step"), 200);
  EXPECT_EQ(notes.size(), 3u);  // and one of the value that is not finite
  EXPECT_EQ(all.at("files").size(), files(folder));
  for (const json& name : all.at("files"))
    EXPECT_TRUE(std::filesystem::exists(folder / name.get<std::string>())) << name;
}

TEST(AnalysisWrite, OneFrameAndManyForBlocks) {
  const Folder folder("analysis_one");
  Writer one(folder.path(), "somewhere", {&heat}, true);
  one.begin_frame(0, at(5, 1));
  one.add(heat, result(1, 4));
  one.finish();
  EXPECT_TRUE(std::filesystem::exists(folder / "heat_profile.csv"));
  EXPECT_FALSE(std::filesystem::exists(folder / "heat_blocks.csv"));
  EXPECT_EQ(io::read_csv(folder / "series_summary.csv").row_count(), 2u);

  Writer many(folder.path(), "somewhere", {&heat}, false);
  for (std::uint64_t f = 0; f < 40; ++f) {
    many.begin_frame(f, at(f, static_cast<double>(f)));
    many.add(heat, [&] {
      Result r;
      r.add("flow", "W", f % 2 == 0 ? 1 : 3);
      return r;
    }());
  }
  many.finish();
  const io::Table blocks = io::read_csv(folder / "heat_blocks.csv");
  ASSERT_EQ(blocks.row_count(), 10u);
  EXPECT_EQ(io::number(blocks, 3, io::column(blocks, "flow")), 2);
  EXPECT_NEAR(io::number(blocks, 3, io::column(blocks, "flow_error")), std::sqrt(4.0 / 3 / 4), 1e-15);
  EXPECT_EQ(io::number(blocks, 9, io::column(blocks, "last_time")), 39);
  const io::Table summary = io::read_csv(folder / "series_summary.csv");
  EXPECT_EQ(io::number(summary, 0, io::column(summary, "mean")), 2);
  EXPECT_EQ(io::number(summary, 0, io::column(summary, "steady_from")), 0);
}

TEST(AnalysisWrite, ReplacesItsOwnFilesAlone) {
  const Folder folder("analysis_folder");
  prepare_folder(folder / "new/one");
  EXPECT_EQ(json::parse(read(folder / "new/one/analysis.json")).at("complete"), false);
  const std::string name(quantities().front().name);
  for (const std::string& file : {name + "_series.csv", name + ".csv", std::string("series_summary.csv"),
                                  std::string("notes.txt"), name + "s_of_mine.csv"})
    std::ofstream(folder / ("new/one/" + file)) << "x";
  prepare_folder(folder / "new/one");
  EXPECT_FALSE(std::filesystem::exists(folder / ("new/one/" + name + "_series.csv")));
  EXPECT_FALSE(std::filesystem::exists(folder / ("new/one/" + name + ".csv")));
  EXPECT_FALSE(std::filesystem::exists(folder / "new/one/series_summary.csv"));
  EXPECT_TRUE(std::filesystem::exists(folder / "new/one/notes.txt"));
  EXPECT_TRUE(std::filesystem::exists(folder / ("new/one/" + name + "s_of_mine.csv")));
  std::filesystem::create_directory(folder / "full");
  std::ofstream(folder / "full/notes.txt") << "x";
  EXPECT_THROW(prepare_folder(folder / "full"), InputError);
  std::ofstream(folder / "full/scene.toml") << "x";
  std::ofstream(folder / "full/analysis.json") << "{}";
  EXPECT_THROW(prepare_folder(folder / "full"), InputError);  // a run
  EXPECT_THROW(prepare_folder(folder / "full/notes.txt"), InputError);
}

}  // namespace
