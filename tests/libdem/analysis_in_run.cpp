// Analysis of a run as it goes: the run's bits stay, rows come at their times, a resume goes on with them.
#include <gtest/gtest.h>

#include <fstream>

#include "libdem/analysis/in_run.h"
#include "libdem/io/io.h"
#include "libdem/run.h"
#include "tests/libdem/io_world.h"
#include "tests/libdem/scenes_in_code.h"

namespace {

using namespace dem;
using namespace dem::analysis;
using io_test::Folder;

std::string read(const std::string& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

Scene tray() {
  Scene s = scenes::every_shape(40);
  s.run.steps = 400;
  s.law.ledger = true;
  s.output.vtk = s.output.picture = false;
  return s;
}
// With everything that is cheap, each 80 steps.
Scene watched() {
  Scene s = tray();
  for (const analysis::Quantity& q : quantities())
    if (!q.costly) s.analysis.what.emplace_back(q.name);
  s.analysis.interval = 80.2 * build_world(s).time_step.dt;
  return s;
}

std::uint64_t hash_of_run(const Scene& scene, const std::string& folder) {
  World world = build_world(scene);
  RunOptions options;
  options.folder = folder;
  run(world, options, false);
  return state_hash(world);
}

TEST(AnalysisInRun, LeavesTheBitsOfTheRun) {
  const Folder folder("in_run_bits");
  const std::uint64_t without = hash_of_run(tray(), folder / "a"), with = hash_of_run(watched(), folder / "b");
  EXPECT_EQ(without, with);
  EXPECT_EQ(read(folder / "a/final.csv"), read(folder / "b/final.csv"));
  EXPECT_FALSE(std::filesystem::exists(folder / "a/analysis_energy.csv"));
  const io::Table energy = io::read_csv(folder / "b/analysis_energy.csv");
  ASSERT_EQ(energy.row_count(), 6u);  // 0, 80, … 400
  EXPECT_EQ(energy.cell(3, 1), "240");
  EXPECT_EQ(energy.cell(5, 1), "400");
  EXPECT_GT(io::number(energy, 5, io::column(energy, "lost_friction")), 0);
  EXPECT_GE(io::number(energy, 5, io::column(energy, "elastic")), 0);
  for (const std::string& name : watched().analysis.what)
    EXPECT_EQ(io::read_csv(folder / ("b/analysis_" + name + ".csv")).row_count(), 6u) << name;
}

TEST(AnalysisInRun, AResumedRunHasTheSameRows) {
  const Folder folder("in_run_resume");
  const Scene scene = watched();
  hash_of_run(scene, folder / "whole");
  // The same run, killed after step 200 with its checkpoint at step 100 and half a row on the disk.
  World world = build_world(scene);
  std::filesystem::create_directory(folder / "part");
  std::vector<std::uint8_t> state;
  {
    InRun series(world, folder / "part", false);
    series.write(world);
    for (int step = 1; step <= 200; ++step) {
      advance(world, 1);
      if (step % 80 == 0) series.write(world);
      if (step == 100) state = save_state(world);
    }
  }
  std::ofstream(folder / "part/analysis_energy.csv", std::ios::app) << "0.00";
  World again = build_world(scene);
  load_state(again, state);
  RunOptions options;
  options.folder = folder / "part";
  run(again, options, true);
  for (const std::string& name : scene.analysis.what)
    EXPECT_EQ(read(folder / ("whole/analysis_" + name + ".csv")), read(folder / ("part/analysis_" + name + ".csv")))
        << name;
}

TEST(AnalysisInRun, ColumnsThatComeLate) {
  const Folder folder("in_run_columns");
  GrowingSeries series(folder / "a.csv", false, 0);
  EXPECT_FALSE(series.ends_at(0));
  Result first, second;
  first.add("one", "m", 1);
  second.add("two", "m^2/s^2", 2);
  second.scalars.push_back({"one", "m", 3, 0.25});
  series.add(0, 0, first);
  EXPECT_TRUE(series.ends_at(0));
  series.add(0.5, 10, second);
  series.add(1, 20, {});
  EXPECT_EQ(read(folder / "a.csv"),
            "# units: time s, step 1, one m, two m^2/s^2, one_error m\ntime,step,one,two,one_error\n0,0,1,,\n"
            "0.5,10,3,2,0.25\n1,20,,,\n");
  GrowingSeries later(folder / "a.csv", true, 0.7);
  EXPECT_TRUE(later.ends_at(0.5));
  later.add(0.75, 15, first);
  EXPECT_EQ(read(folder / "a.csv"),
            "# units: time s, step 1, one m, two m^2/s^2, one_error m\ntime,step,one,two,one_error\n0,0,1,,\n"
            "0.5,10,3,2,0.25\n0.75,15,1,,\n");
  EXPECT_EQ(io::read_csv(folder / "a.csv").row_count(), 3u);
}

TEST(AnalysisInRun, SettingsOfAScene) {
  AnalysisSpec spec;
  EXPECT_FALSE(settings_of(spec).region);
  EXPECT_TRUE(quantities_of(spec).empty());
  spec.what = {"all"};
  spec.boxes = {1, 0, 3};
  spec.region_upper = {1, 2, 3};
  spec.split = "size";
  EXPECT_EQ(quantities_of(spec).size(), quantities().size());
  EXPECT_EQ(settings_of(spec).boxes, (std::array<int, 3>{1, 0, 3}));
  EXPECT_EQ(settings_of(spec).region.value_or(Domain{}).upper, (Vec3d{1, 2, 3}));
  EXPECT_EQ(settings_of(spec).split, "size");
}

}  // namespace
