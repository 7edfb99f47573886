// Contact networks of runs with every shape: what an analysis finds agrees with what the run itself counts and bears.
#include <gtest/gtest.h>
#include <omp.h>

#include <cstring>

#include "libdem/analysis/constraints.h"
#include "libdem/analysis/coordination.h"
#include "libdem/analysis/force_chains.h"
#include "libdem/analysis/quantities.h"
#include "libdem/analysis/stress.h"
#include "libdem/analysis/walls.h"
#include "libdem/deformation.h"
#include "tests/libdem/scenes_in_code.h"

namespace dem::analysis {
namespace {

constexpr std::size_t ridge = 4;  // the mesh of the tray

Scene tray() {
  Scene s = scenes::every_shape_driven(120);
  s.run.dt_auto = false;
  s.run.dt = 0x1p-16;
  s.output.interval = s.run.dt;  // maps of the run are then of one step
  s.output.picture = s.output.hdf5 = false;
  s.walls[ridge].pressure_map = true;
  return s;
}

void expect_walls_of_run(const Scene& scene, bool torques) {
  World w = build_world(scene);
  std::size_t loaded = 0;
  while (w.step < 1500) {
    advance(w, 1);
    if (w.step % 100 != 0) continue;
    const Snapshot s = snapshot_of(w);
    const std::vector<WallForce> forces = wall_forces(s);
    for (std::size_t k = 0; k < w.walls.size(); ++k) {
      const double scale = norm(w.walls[k].force) + forces[k].pressing;
      EXPECT_LE(norm(forces[k].force - w.walls[k].force), 1e-12 * scale);
      if (torques) {
        EXPECT_LE(norm(forces[k].torque - w.walls[k].torque), 1e-12 * scale);
      }
    }
    const std::vector<WallPatch> map = wall_map(s, ridge, domain_of(s), {1, 1});
    const std::vector<MapTraction> of_run = tractions(w, w.walls[ridge]);
    ASSERT_EQ(map.size(), of_run.size());
    for (std::size_t t = 0; t < map.size(); ++t) {
      const double scale = std::abs(of_run[t].pressure) + norm(of_run[t].traction);
      EXPECT_NEAR(map[t].pressing / map[t].area, of_run[t].pressure, 1e-9 * scale);
      EXPECT_LE(norm(map[t].force * (1 / map[t].area) - of_run[t].traction), 1e-9 * scale);
      loaded += map[t].pressing > 0 ? 1 : 0;
    }
  }
  EXPECT_GT(loaded, 3u);
}

TEST(AnalysisNetworkOfRun, WallsBearWhatTheRunSays) {
  expect_walls_of_run(tray(), false);  // patches bear couples too, which a snapshot has not
  Scene balls = tray();
  balls.fills[0].items.resize(1);
  expect_walls_of_run(balls, true);
}

TEST(AnalysisNetworkOfRun, CoordinationIsThatOfTheRun) {
  Scene scene = scenes::every_shape_in_a_cell(100);
  World w = build_world(scene);
  const double start = cell_volume(w);
  EXPECT_GT(start, 0);
  for (int k = 0; k < 1500; ++k) advance(w, 1);
  const Snapshot s = snapshot_of(w);
  const Pairs pairs = pairs_of(s);
  const Coordination found = coordination_of(s, pairs);
  const dem::Coordination own = dem::coordination(w);
  EXPECT_GT(own.pairs, 10u);
  EXPECT_EQ(pairs.bodies.size(), own.pairs);
  EXPECT_NEAR(found.mean, own.all, 1e-12);
  // The stresses of bodies add to that of the cell: contacts' part, symmetric.
  Mat3d sum{};
  const std::vector<Mat3d> stress = body_stresses(s);
  for (std::size_t i = 0; i < s.count(); ++i) add_to(sum, stress[i], s.volume[i] / cell_volume(w));
  const Mat3d whole = symmetric_part(stress_of(s, {}).contacts);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) EXPECT_NEAR(sum.row[i][j], whole.row[i][j], 1e-10 * std::abs(trace(whole)));
}

TEST(AnalysisNetworkOfRun, EveryQuantityIsFiniteAndTheSameOnAnyNumberOfThreads) {
  World w = build_world(tray());
  for (int k = 0; k < 600; ++k) advance(w, 1);
  const Snapshot before = snapshot_of(w);
  for (int k = 0; k < 600; ++k) advance(w, 1);
  const Snapshot s = snapshot_of(w);
  Settings settings;
  settings.reference = settings.before = &before;
  for (const char* name : {"coordination", "fabric", "rose", "forces", "walls", "orientation", "mixing", "flow",
                           "repose", "displacement"}) {
    const Quantity* q = find_quantity(name);
    ASSERT_NE(q, nullptr) << name;
    omp_set_num_threads(1);
    const Result r = q->of(s, settings);
    omp_set_num_threads(3);
    const Result again = q->of(s, settings);
    ASSERT_EQ(r.scalars.size(), again.scalars.size());
    EXPECT_FALSE(r.scalars.empty() && r.tables.empty()) << name;
    for (std::size_t k = 0; k < r.scalars.size(); ++k) {
      EXPECT_TRUE(std::isfinite(r.scalars[k].value)) << name << ' ' << r.scalars[k].name;
      EXPECT_EQ(std::memcmp(&r.scalars[k].value, &again.scalars[k].value, sizeof(double)), 0);
    }
    ASSERT_EQ(r.tables.size(), again.tables.size());
    for (std::size_t k = 0; k < r.tables.size(); ++k)
      for (std::size_t i = 0; i < r.tables[k].columns.size(); ++i) {
        const Table& t = r.tables[k];
        const Column& c = t.columns[i];
        EXPECT_EQ(c.values, again.tables[k].columns[i].values) << name << ' ' << t.name << ' ' << c.name;
        EXPECT_EQ(c.values.size(), t.columns[0].values.size()) << name << ' ' << t.name << ' ' << c.name;
        for (const double v : c.values) EXPECT_TRUE(std::isfinite(v)) << name << ' ' << t.name << ' ' << c.name;
      }
  }
}

// A cube that has come to rest on a floor, and one on top of it.
TEST(AnalysisNetworkOfRun, BoxesAtRestTouchFaceToFace) {
  Scene scene;
  scene.gravity = {0, 0, -8};
  scene.materials = {scenes::material("soft", 1e7, 1000, 0.2, 0.5)};
  scene.shapes = {scenes::box("cube", {0.0625, 0.0625, 0.0625})};
  WallSpec floor;
  floor.name = "floor";
  floor.kind = "plane";
  floor.material = "soft";
  scene.walls = {floor};
  scene.bodies = {scenes::body("cube", "soft", {0, 0, 0.03125}), scenes::body("cube", "soft", {0.01, 0.005, 0.09375})};
  World w = build_world(scene);
  for (int k = 0; k < 4000; ++k) advance(w, 1);
  const Snapshot s = snapshot_of(w);
  const Constraints c = constraints_of(s, pairs_of(s));
  EXPECT_EQ(c.of_pair, (std::vector<std::uint8_t>{3}));
  EXPECT_EQ(c.of_wall, (std::vector<std::uint8_t>{3}));
}

}  // namespace
}  // namespace dem::analysis
