// cell.csv and the box in the record: what is written comes back, and a resumed run writes the same bytes.
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "libdem/deformation.h"
#include "libdem/io/io.h"
#include "libdem/run.h"
#include "tests/libdem/io_world.h"
#include "tests/libdem/scenes_in_code.h"

namespace dem {
namespace {

using io_test::Folder;

std::string text_of(const std::string& path) {
  std::stringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

Scene scene() {
  Scene s = scenes::every_shape_in_a_cell(40);
  s.run.steps = 200;
  s.run.dt_auto = false;
  s.run.dt = 0x1p-16;
  s.output.vtk = s.output.picture = false;
  s.output.interval = 64 * s.run.dt;
  s.output.cell_interval = 16 * s.run.dt;
  return s;
}

TEST(IoCell, RowsHoldTheCellAndItsBodies) {
  const Folder folder("cell");
  World w = scenes::run(scene(), 150);
  const std::string path = folder / "cell.csv";
  io::CellSeries(path, w, false).write(w);
  const io::Table table = io::read_csv(path);
  ASSERT_EQ(table.row_count(), 1u);
  const auto value = [&](const char* name) { return io::number(table, 0, io::column(table, name)); };
  const Mat3d stress = cell_stress(w);
  const Coordination z = coordination(w);
  EXPECT_EQ(value("time"), w.time());
  EXPECT_EQ(value("length_x"), w.cell.lattice.length.x);
  EXPECT_EQ(value("length_z"), w.cell.lattice.length.z);
  EXPECT_EQ(value("stress_xx"), stress.row[0].x);
  EXPECT_EQ(value("stress_zz"), stress.row[2].z);
  EXPECT_EQ(value("stress_xz"), 0.5 * (stress.row[0].z + stress.row[2].x));
  EXPECT_EQ(value("solid_fraction"), solid_fraction(w));
  EXPECT_EQ(value("coordination"), z.all);
  EXPECT_EQ(value("rattlers"), z.rattlers);
  EXPECT_EQ(value("coordination_backbone"), z.backbone);
  EXPECT_EQ(value("translational"), energies(w).translational);
  EXPECT_EQ(value("work"), w.cell.work.value());
}

TEST(IoCell, AResumedSeriesDropsLaterAndBrokenRows) {
  const Folder folder("cell");
  const std::string path = folder / "cell.csv";
  World w = build_world(scene());
  {
    io::CellSeries series(path, w, false);
    for (; w.step <= 3; advance(w, 1)) {
      series.write(w);
      series.write(w);  // no second row of the same time
    }
  }
  const std::string whole = text_of(path);
  EXPECT_EQ(io::read_csv(path).row_count(), 4u);
  std::ofstream(path, std::ios::app) << "0.0001,0.1";  // a run that was killed
  w.step = 3;
  const io::CellSeries same(path, w, true);
  EXPECT_EQ(text_of(path), whole);
  w.step = 1;
  const io::CellSeries shorter(path, w, true);
  EXPECT_EQ(io::read_csv(path).row_count(), 2u);
}

TEST(IoCell, AResumedRunWritesTheSameBytes) {
  const Folder folder("cell");
  RunOptions options;
  options.folder = folder / "whole";
  World whole = build_world(scene());
  run(whole, options, false);
  EXPECT_EQ(io::read_csv(options.folder + "/cell.csv").row_count(), 1u + 200 / 16 + 1);

  std::atomic<bool> stop = false;
  options.folder = folder / "parts";
  options.interrupt = &stop;
  options.observe = [&stop](const World& w) { stop = w.step == 101; };
  World first = build_world(scene());
  ASSERT_EQ(run(first, options, false), RunEnd::interrupted);
  stop = false;
  options.observe = nullptr;
  World second = build_world(scene());
  load_state(second, io::read_last_checkpoint(options.folder)->state);
  run(second, options, true);
  for (const char* name : {"/cell.csv", "/final.csv"})
    EXPECT_EQ(text_of(folder / "whole" + name), text_of(options.folder + name)) << name;
  EXPECT_EQ(state_hash(second), state_hash(whole));
  EXPECT_NE(text_of(options.folder + "/summary.json").find("\"solid_fraction\""), std::string::npos);
}

TEST(IoCell, TheRecordHoldsTheBox) {
  const Folder folder("cell");
  const std::string path = folder / "record.h5";
  const World w = scenes::run(scene(), 50);
  io::Record(path, w, false).write(w);
  World read = build_world(scene());
  io::load_frame(path, read, 0);
  EXPECT_EQ(read.cell.lattice.length, w.cell.lattice.length);
  EXPECT_EQ(read.cell.lattice.inverse, w.cell.lattice.inverse);
  EXPECT_EQ(read.cell.lower, w.cell.lower);
}

}  // namespace
}  // namespace dem
